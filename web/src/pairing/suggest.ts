/** Seams to suggest: those that are as good as certain, and those to ask about. */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment-document.js';
import {edgeAt, meetsAtStarts, partnersIn, type PairingHooks} from './rank.js';
import {numberOf, scoresOf} from './scores.js';
import {isPlain} from './sure.js';

interface SuggestedSeam {
  readonly a: EdgeOfPiece;
  readonly b: EdgeOfPiece;
  /** How likely it is, from 0 to 1. */
  readonly p: number;
  /** Start meets start. */
  readonly sameDirection: boolean;
}

/** Pairs at least as likely as this are drawn without a question. */
const sure = 0.92;

/**
 * Open pairs that are each other's likeliest partners, the likeliest first: each edge comes once at most. After every
 * answer all is ranked anew.
 * @param least how likely, from 0 to 1
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

/** The seams that are as good as certain, the likeliest first: of a hundred, four are wrong. */
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
