/** Suggests seams: those that are almost certain, and those to be confirmed. */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import {edgeAt, meetsAtStarts, partnersIn, type PairingHooks} from './rank.js';
import {dartsOf} from './darts.js';
import {imagesOf, numberOf, scoresOf} from './scores.js';
import {isPlain} from './sure.js';

interface SuggestedSeam {
  readonly a: EdgeOfPiece;
  readonly b: EdgeOfPiece;
  /** Likelihood, from 0 to 1. */
  readonly p: number;
  /** Start meets start. */
  readonly sameDirection: boolean;
}

/** Least likelihood of a seam that is added without a question. */
const sure = 0.92;

/**
 * Returns open pairs that are each other's likeliest partners, the likeliest first. Each edge
 * appears once at most, and every answer changes the ranking.
 * @param least least likelihood, from 0 to 1
 */
export function likeliestSeams(
  garment: GarmentDocument,
  least: number,
  {refused = []}: PairingHooks = {},
): readonly SuggestedSeam[] {
  const scores = scoresOf(garment, refused);
  const best = scores.garment.edges.map((_, edge) => partnersIn(scores, edge)[0]);
  return best
    .filter((one) => one !== undefined)
    .filter(({a, b, p}) => a < b && p >= least && best[b]?.b === a)
    .sort((one, other) => other.p - one.p)
    .map(({a, b, p}) => {
      const [from, to] = [edgeAt(scores, a), edgeAt(scores, b)];
      return {a: from, b: to, p, sameDirection: meetsAtStarts(garment, from, to)};
    });
}

/** Returns the seams that are almost certain, the likeliest first: four in a hundred are wrong. */
export function sureSeams(
  document: GarmentDocument,
  hooks: PairingHooks = {},
): readonly SuggestedSeam[] {
  const {garment} = scoresOf(document, hooks.refused);
  return likeliestSeams(document, sure, hooks).filter(({a, b}) => {
    const [one, other] = [a, b].map((edge) => garment.edges[numberOf(garment, edge)]);
    return one && other && isPlain(document, garment, one, other);
  });
}

/** Returns the darts of a garment that are not sewn yet. */
export function openDarts(
  document: GarmentDocument,
): readonly (readonly [EdgeOfPiece, EdgeOfPiece])[] {
  const {garment} = imagesOf(document);
  const sewn = new Set(
    document.seams.flatMap(({a, b}) => [a, b].map((end) => numberOf(garment, end))),
  );
  return dartsOf(garment).flatMap(([first, second]) => {
    const [a, b] = [garment.edges[first]?.at, garment.edges[second]?.at];
    return a && b && !sewn.has(first) && !sewn.has(second) ? [[a, b] as const] : [];
  });
}
