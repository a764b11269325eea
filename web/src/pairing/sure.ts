/** What a seam needs, besides being likely, to be drawn without a question. */
import type {GarmentDocument} from '../model/garment-document.js';
import type {MeasuredEdge, MeasuredGarment} from './edges.js';

/** Nothing shorter is a seam of its own. [cm] */
const scrap = 2;
/** Logarithms of lengths: no more is ease, and no more is gathered. */
const most = {eased: 0.07, gathered: 0.3};
/** Pieces that others are gathered onto, and those that are gathered. */
const gathers = /cuff|band|^wb|skirt|ruffle|frill|flounce|gather/i;
/** Nearer to the middle of a piece, as a share of its width, is neither left nor right. */
const middle = 0.05;

/** 1 where an edge is worn on the left, -1 on the right, 0 where neither names nor places tell. Pieces lie face up. */
function sideOf({pieces}: MeasuredGarment, {at, place: [across]}: MeasuredEdge): number {
  const {side = 0, face = 0} = pieces[at.piece]?.words ?? {};
  if (side !== 0) return side;
  return Math.abs(across) > middle ? face * Math.sign(across) : 0;
}

/** Halves of whole pieces are sewn on their own side; only left and right pieces meet at a centre. */
function areSidesAlike(garment: MeasuredGarment, a: MeasuredEdge, b: MeasuredEdge): boolean {
  const isCentre = [a, b].every(({at}) => garment.pieces[at.piece]?.words.side !== 0);
  return isCentre || sideOf(garment, a) * sideOf(garment, b) >= 0;
}

/** Whether nothing that can be seen speaks against a seam: lengths, sides, and that it is no scrap. */
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
