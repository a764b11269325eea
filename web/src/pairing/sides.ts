/**
 * Suggests partners of a sleeve cap: two edges of two pieces that continue each other at a seam, as
 * both armholes do at the shoulder.
 */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import {near} from './features.js';
import {edgeAt, partnersIn, type PairingHooks} from './rank.js';
import {numberOf, scoresOf, type Scores} from './scores.js';

/** Two edges in sewing order, each from its start to its end, and the edge they may be sewn to. */
interface SideSuggestion {
  readonly edge: EdgeOfPiece;
  readonly side: readonly [EdgeOfPiece, EdgeOfPiece];
  /** Likelihood, from 0 to 1. */
  readonly p: number;
}

/** Least likelihood of the seam between the two edges. */
const leastJoint = 0.5;
/**
 * Width of the log ratio of lengths, and of the corners' deviation from a half turn [rad]: both may
 * be eased.
 */
const width = {length: 0.06, angle: 0.8};

interface Meeting {
  readonly first: number;
  readonly second: number;
  readonly p: number;
  /** Length of the seam at which they meet. [cm] */
  readonly length: number;
}

/**
 * Keeps the shorter seam of two edges that meet at both ends, as armholes do: the longer one closes
 * a sleeve.
 */
const withoutTurned = (meetings: readonly Meeting[]): readonly Meeting[] =>
  meetings.filter(({first, second, length}) =>
    meetings.every(
      (other) => other.first !== second || other.second !== first || other.length >= length,
    ),
  );

/** Returns all pairs of free edges that continue each other at a confirmed or likely seam. */
function meetingsIn(scores: Scores, {seams}: GarmentDocument): readonly Meeting[] {
  const {garment, isFree, likelihoods} = scores;
  const {edges} = garment;
  const sewn = seams.flatMap(({a, b, sameDirection}) => {
    const ends = [numberOf(garment, a), numberOf(garment, b)] as const;
    return sameDirection ? [] : [ends, [ends[1], ends[0]] as const];
  });
  const likely = edges.flatMap((_, a) => {
    const [best] = partnersIn(scores, a);
    return best && best.p >= leastJoint ? [[a, best.b] as const] : [];
  });
  return [...sewn, ...likely].flatMap(([a, b]): Meeting[] => {
    const [first, second] = [edges[a]?.before ?? a, edges[b]?.after ?? b];
    const [one, joint, other] = [edges[first], edges[a], edges[second]];
    if (isFree[first] !== 1 || isFree[second] !== 1 || !one || !joint || !other) return [];
    if (one.at.piece === other.at.piece) return [];
    const isSewn = isFree[a] !== 1;
    const p = isSewn ? 1 : (likelihoods.values[a * likelihoods.size + b] ?? 0);
    const {length} = joint;
    return [
      {first, second, length, p: p * near(joint.corner + other.corner - Math.PI, width.angle)},
    ];
  });
}

/**
 * Returns sides of two edges, each with an edge it may be sewn to, the likeliest first: for edges
 * without a likely single partner. The likelihoods of one edge add up to 1 at most.
 */
export function likeliestSides(
  document: GarmentDocument,
  {refused = []}: PairingHooks = {},
): readonly SideSuggestion[] {
  const scores = scoresOf(document, refused);
  const {garment, isFree} = scores;
  const {edges} = garment;
  const alone = edges.map((_, edge) => 1 - (partnersIn(scores, edge)[0]?.p ?? 0));
  const meetings = withoutTurned(meetingsIn(scores, document));
  return edges
    .flatMap(({at, length}, k) => {
      if (isFree[k] !== 1) return [];
      const found = meetings.flatMap(({first, second, p}) => {
        const [one, other] = [edges[first], edges[second]];
        if (!one || !other || one.at.piece === at.piece || other.at.piece === at.piece) return [];
        const ratio = Math.log((one.length + other.length) / length);
        const free = (alone[k] ?? 0) * (alone[first] ?? 0) * (alone[second] ?? 0);
        return [{edge: at, first, second, p: p * free * near(ratio, width.length)}];
      });
      const total = Math.max(
        1,
        found.reduce((sum, {p}) => sum + p, 0),
      );
      return found.map(({edge, first, second, p}): SideSuggestion => {
        const side = [edgeAt(scores, first), edgeAt(scores, second)] as const;
        return {edge, side, p: p / total};
      });
    })
    .sort((one, other) => other.p - one.p);
}
