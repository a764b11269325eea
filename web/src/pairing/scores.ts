/** How likely every two edges of a garment are sewn to each other, given the seams that it has. */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment-document.js';
import {believed, candidatesOf, givenBeliefs, hopeful, type Candidates} from './candidates.js';
import {measured, type MeasuredGarment} from './edges.js';
import {surroundingsOf} from './features.js';
import type {Table} from './matching.js';
import {mirrorEdges, withPartImages} from './mirror-edges.js';
import {logOdds, unpacked, type Network} from './network.js';
import {isOfTwins, isUnderarm} from './twins.js';
import {alone, given} from './weights.js';

/** Pairs that somebody said are not sewn to each other. */
export type Refused = readonly (readonly [EdgeOfPiece, EdgeOfPiece])[];

export interface Scores {
  readonly garment: MeasuredGarment;
  readonly likelihoods: Table;
  /** Per edge 1 where it may still be sewn. */
  readonly isFree: Uint8Array;
  /** The mirror image of each edge, or -1. */
  readonly images: Int32Array;
}

/** How often neighbours are asked again what they have come to believe. */
const rounds = 3;

/** What is added to the logarithm of the odds that a sleeve is closed: the garments of training had few of one piece. */
const underarm = 5;

const known = new WeakMap<GarmentDocument, {readonly refused: Refused; readonly scores: Scores}>();

/** Reckoned once for the same garment and the same list of refused pairs. */
export function scoresOf(document: GarmentDocument, refused: Refused = []): Scores {
  const last = known.get(document);
  if (last && (last.refused === refused || last.refused.length + refused.length === 0)) {
    return last.scores;
  }
  const scores = newScores(document, refused);
  known.set(document, {refused, scores});
  return scores;
}

/** The number of an edge in the list of all. */
export const numberOf = ({pieces}: MeasuredGarment, {piece, edge}: EdgeOfPiece): number =>
  (pieces[piece]?.first ?? 0) + edge;

function newScores({pieces, seams}: GarmentDocument, refused: Refused): Scores {
  const garment = measured(pieces);
  const {edges} = garment;
  const pairOf = (a: EdgeOfPiece, b: EdgeOfPiece) =>
    [numberOf(garment, a), numberOf(garment, b)] as const;
  const sewn = seams.map(({a, b}) => pairOf(a, b));
  const isFree = Uint8Array.from(edges, ({isOpen}) => (isOpen ? 0 : 1));
  for (const end of sewn.flat()) isFree[end] = 0;
  const keyOf = (i: number, j: number): number => Math.max(i, j) * edges.length + Math.min(i, j);
  const isNot = new Set(refused.map(([a, b]) => keyOf(...pairOf(a, b))));
  const wholes = mirrorEdges(garment); // as those learned from
  const images = withPartImages(garment, wholes);
  const all = candidatesOf(
    surroundingsOf(garment, wholes),
    (i, j) =>
      isFree[i] === 1 &&
      isFree[j] === 1 &&
      !isNot.has(keyOf(i, j)) &&
      !isOfTwins(garment, images, i, j),
  );
  const [first, later] = [unpacked(alone), unpacked(given)];
  const weighed = (
    {pairs}: Candidates,
    network: Network,
    features: readonly (readonly number[])[],
  ) =>
    pairs.map(
      ([i, j], k) =>
        logOdds(network, features[k] ?? []) + (isUnderarm(garment, i, j) ? underarm : 0),
    );
  const firstOdds = weighed(all, first, all.features);
  const candidates = hopeful(all, firstOdds);
  let beliefs = believed(all, firstOdds, sewn);
  for (let round = 0; round < rounds; round++) {
    const odds = weighed(candidates, later, givenBeliefs(candidates, beliefs));
    beliefs = believed(candidates, odds, sewn);
  }
  return {garment, likelihoods: beliefs.likelihoods, isFree, images};
}
