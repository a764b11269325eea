/** Computes the likelihood of every pair of a garment's edges, given its existing seams. */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import {believed, candidatesOf, givenBeliefs, hopeful, type Candidates} from './candidates.js';
import {measured, type MeasuredGarment, type PleatState} from './edges.js';
import {hiddenParts} from '../model/garment/pleated-edges.js';
import {rowOf} from './names.js';
import {surroundingsOf} from './features.js';
import type {Table} from './matching.js';
import {mirrorEdges, withPartImages} from './mirror-edges.js';
import {logOdds, unpacked, type Network} from './network.js';
import {isOfTwins, isUnderarm} from './twins.js';
import {alone, given} from './weights.js';

/** Pairs that the user has rejected. */
export type Refused = readonly (readonly [EdgeOfPiece, EdgeOfPiece])[];

export interface Scores {
  readonly garment: MeasuredGarment;
  readonly likelihoods: Table;
  /** 1 for each edge that may still be sewn. */
  readonly isFree: Uint8Array;
  /** Mirror image of each edge, or -1. */
  readonly images: Int32Array;
}

/**
 * Most edges of a garment whose pairs are scored. They take 7 s on one core, and the time grows with
 * the square of their number.
 */
export const mostScoredEdges = 600;

/** Number of rounds that update the beliefs from those of the neighbours. */
const rounds = 3;

/**
 * Added to the log odds that a sleeve is closed: the training garments had few one-piece sleeves.
 */
const underarm = 5;
/** Added to the log odds for neighbours in a numbered row, subtracted for others in it. */
const inRow = 3;

const known = new WeakMap<GarmentDocument, {readonly refused: Refused; readonly scores: Scores}>();

/** Returns the scores, computed once for the same garment and the same list of rejected pairs. */
export function scoresOf(document: GarmentDocument, refused: Refused = []): Scores {
  const last = known.get(document);
  if (last && (last.refused === refused || last.refused.length + refused.length === 0)) {
    return last.scores;
  }
  const scores = bestScores(document, refused);
  known.set(document, {refused, scores});
  return scores;
}

/** Returns the number of an edge in the list of all edges. */
export const numberOf = ({pieces}: MeasuredGarment, {piece, edge}: EdgeOfPiece): number =>
  (pieces[piece]?.first ?? 0) + edge;

/** Results that depend on the pieces alone, and not on their seams. */
interface Shapes {
  readonly garment: MeasuredGarment;
  readonly images: Int32Array;
  readonly candidates: Candidates;
  /** One value for each candidate. */
  readonly odds: readonly number[];
}

const shapes = {
  closed: new WeakMap<GarmentDocument['pieces'], Shapes>(),
  open: new WeakMap<GarmentDocument['pieces'], Shapes>(),
};

function shapesOf(pieces: GarmentDocument['pieces'], pleats: PleatState): Shapes {
  const before = shapes[pleats].get(pieces);
  if (before) return before;
  const garment = measured(pieces, pleats);
  const {edges} = garment;
  const wholes = mirrorEdges(garment); // the networks were trained with these images
  const images = withPartImages(garment, wholes);
  const candidates = candidatesOf(
    surroundingsOf(garment, wholes),
    (i, j) =>
      edges.length <= mostScoredEdges &&
      edges[i]?.isOpen === false &&
      edges[j]?.isOpen === false &&
      !isOfTwins(garment, images, i, j),
  );
  const odds = weighed(candidates, unpacked(alone), candidates.features);
  const found = {garment, images, candidates, odds};
  shapes[pleats].set(pieces, found);
  return found;
}

/** Returns the measured edges of a garment, and the mirror image of each edge, or -1. */
export const imagesOf = ({pieces}: GarmentDocument): Pick<Shapes, 'garment' | 'images'> =>
  shapesOf(pieces, 'closed');

/** Returns the log odds of all candidates. */
const weighed = (
  {pairs, surroundings: {garment}}: Candidates,
  network: Network,
  features: readonly (readonly number[])[],
): readonly number[] =>
  pairs.map(
    ([i, j], k) =>
      logOdds(network, features[k] ?? []) +
      (isUnderarm(garment, i, j) ? underarm : 0) +
      inRow * rowOf(garment, i, j),
  );

/** The length of all edges that the scores expect to be sewn. [cm] */
const explained = ({garment: {edges}, likelihoods: {size, values}}: Scores): number =>
  edges.reduce(
    (sum, {length}, k) => sum + length * Math.max(0, ...values.subarray(k * size, (k + 1) * size)),
    0,
  );

/** The scores with pleats closed or as cut, whichever explains more of the garment. */
function bestScores(document: GarmentDocument, refused: Refused): Scores {
  const closed = newScores(document, refused, 'closed');
  if (document.pieces.every((piece) => hiddenParts(piece).length === 0)) return closed;
  const open = newScores(document, refused, 'open');
  return explained(open) > explained(closed) ? open : closed;
}

function newScores({pieces, seams}: GarmentDocument, refused: Refused, pleats: PleatState): Scores {
  const {garment, images, candidates: shaped, odds: shapedOdds} = shapesOf(pieces, pleats);
  const {edges} = garment;
  const pairOf = (a: EdgeOfPiece, b: EdgeOfPiece) =>
    [numberOf(garment, a), numberOf(garment, b)] as const;
  const sewn = seams.map(({a, b}) => pairOf(a, b));
  const isFree = Uint8Array.from(edges, ({isOpen}) => (isOpen ? 0 : 1));
  for (const end of sewn.flat()) isFree[end] = 0;
  const keyOf = (i: number, j: number): number => Math.max(i, j) * edges.length + Math.min(i, j);
  const isNot = new Set(refused.map(([a, b]) => keyOf(...pairOf(a, b))));
  const isLeft = shaped.pairs.map(
    ([i, j]) => isFree[i] === 1 && isFree[j] === 1 && !isNot.has(keyOf(i, j)),
  );
  const left = <T>(list: readonly T[]): T[] => list.filter((_, k) => isLeft[k]);
  const all: Candidates = {
    surroundings: shaped.surroundings,
    pairs: left(shaped.pairs),
    features: left(shaped.features),
  };
  const firstOdds = left(shapedOdds);
  const candidates = hopeful(all, firstOdds);
  const later = unpacked(given);
  let beliefs = believed(all, firstOdds, sewn);
  for (let round = 0; round < rounds; round++) {
    const odds = weighed(candidates, later, givenBeliefs(candidates, beliefs));
    beliefs = believed(candidates, odds, sewn);
  }
  return {garment, likelihoods: beliefs.likelihoods, isFree, images};
}
