/** Conditions, besides likelihood, for a seam that is added without a question. */
import type {GarmentDocument} from '../model/garment/garment-document.js';
import type {MeasuredEdge, MeasuredGarment} from './edges.js';
import {sideOf} from './names.js';

/** Least length of a seam. [cm] */
const scrap = 2;
/** Greatest difference of log lengths: eased seams, and gathered ones. */
const most = {eased: 0.07, gathered: 0.3};
/** Names of pieces that others are gathered onto, and of gathered pieces. */
const gathers = /cuff|band|^wb|skirt|ruffle|frill|flounce|gather/i;
/**
 * Halves of whole pieces are sewn on their own side; only left and right pieces meet at a centre.
 */
function areSidesAlike(garment: MeasuredGarment, a: MeasuredEdge, b: MeasuredEdge): boolean {
  const isCentre = [a, b].every(({at}) => garment.pieces[at.piece]?.words.side !== 0);
  return isCentre || sideOf(garment, a) * sideOf(garment, b) >= 0;
}

/** Returns whether lengths and sides allow a seam, and both edges are long enough. */
export function isPlain(
  {pieces}: GarmentDocument,
  garment: MeasuredGarment,
  a: MeasuredEdge,
  b: MeasuredEdge,
): boolean {
  const [isA, isB] = [a, b].map(({at}) => gathers.test(pieces[at.piece]?.name ?? ''));
  const difference = Math.abs(Math.log(a.length / b.length));
  return (
    Math.min(a.length, b.length) >= scrap &&
    difference <= (isA === isB ? most.eased : most.gathered) &&
    areSidesAlike(garment, a, b)
  );
}
