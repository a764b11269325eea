/** Which edges an edge may be sewn to, the likeliest first. */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment-document.js';
import {numberOf, scoresOf, type Refused, type Scores} from './scores.js';

/** An edge that another one may be sewn to. */
interface Partner {
  readonly edge: EdgeOfPiece;
  /** How likely it is, from 0 to 1. */
  readonly p: number;
  /** Start meets start. */
  readonly sameDirection: boolean;
}

export interface PairingHooks {
  /** Pairs that somebody said are not sewn to each other. */
  readonly refused?: Refused;
}

/** Two edges of a list, by number, and how likely they are sewn to each other. */
interface ScoredPair {
  readonly a: number;
  readonly b: number;
  readonly p: number;
}

/** All partners of an edge of the list, the likeliest first. */
export function partnersIn({likelihoods, isFree}: Scores, a: number): readonly ScoredPair[] {
  const {size, values} = likelihoods;
  if (isFree[a] !== 1) return [];
  return [...values.subarray(a * size, (a + 1) * size)]
    .map((p, b) => ({a, b, p}))
    .filter(({b, p}) => p > 0 && isFree[b] === 1)
    .sort((one, other) => other.p - one.p);
}

/**
 * What an edge may be sewn to, the likeliest first: shapes decide, the seams of the garment count as confirmed, and
 * edges that are sewn or said to stay open are nobody's partners. Nothing for an edge that is one of those. The first
 * question about a garment takes some 30 ms for 60 edges, all further ones nothing.
 */
export function rankPartners(
  garment: GarmentDocument,
  edge: EdgeOfPiece,
  {refused = []}: PairingHooks = {},
): readonly Partner[] {
  const scores = scoresOf(garment, refused);
  return partnersIn(scores, numberOf(scores.garment, edge)).map(({b, p}) => {
    const other = edgeAt(scores, b);
    return {edge: other, p, sameDirection: meetsAtStarts(garment, edge, other)};
  });
}

export const edgeAt = ({garment}: Scores, edge: number): EdgeOfPiece =>
  garment.edges[edge]?.at ?? {piece: 0, edge: 0};

/**
 * Whether the starts of two edges would meet. Pieces lie face up and all outlines run the same way round, so the start of
 * one edge meets the end of the other, unless what is sewn of the two pieces is sewn otherwise, as turned collars are.
 */
export function meetsAtStarts({seams}: GarmentDocument, a: EdgeOfPiece, b: EdgeOfPiece): boolean {
  const joins = (one: EdgeOfPiece, other: EdgeOfPiece): boolean =>
    one.piece === a.piece && other.piece === b.piece;
  const between = seams.filter((seam) => joins(seam.a, seam.b) || joins(seam.b, seam.a));
  return between.length > 0 && between.every(({sameDirection}) => sameDirection);
}
