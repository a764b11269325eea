/** A garment in the sewing tool: matching edges, computed once per garment and answer. */
import {has, type Run} from '../clicks/run.js';
import {
  sameSides,
  type Candidate,
  type Sewing,
  type SuggestedSeam,
  type Suggestion,
} from '../clicks/seam-tool.js';
import type {EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import {edgeOf, isOpen, seamAt, sideLength} from '../model/garment/edits.js';
import {rankPartners} from '../pairing/rank.js';
import {likeliestSides} from '../pairing/sides.js';
import {openDarts, sureSeams} from '../pairing/suggest.js';
import {wholeSeams, type Parts, type WholeSeam} from '../pairing/whole-seams.js';
import {wordsOf} from '../model/garment/piece-words.js';
import {lastOf} from '../model/base/last-of.js';

/** Least likelihood of a seam in a question. */
const leastLikely = 0.4;
/** Least likelihood of a partner that the tool names. */
const leastNamed = 0.3;
/** Greatest number of displayed candidates, which have keys. */
const mostCandidates = 5;

export const allEdges = ({pieces}: GarmentDocument): readonly EdgeOfPiece[] =>
  pieces.flatMap(({outline}, piece) => outline.map((_, edge) => ({piece, edge})));

/**
 * Ranks single edges for a run of several edges by length, since no edge has the shape of several.
 */
function byLength(garment: GarmentDocument, run: Run): readonly Candidate[] {
  const length = sideLength(garment, run);
  return allEdges(garment)
    .filter(
      (edge) =>
        !has(run, edge) && seamAt(garment, edge) === undefined && !isOpen(edgeOf(garment, edge)),
    )
    .map((edge) => {
      const ratio = Math.abs(Math.log(sideLength(garment, [edge]) / length));
      return {a: run, b: [edge], p: Math.exp(-10 * ratio), sameDirection: false};
    });
}

/** Returns pairs of single edges, since sides of several edges are not ranked by their shapes. */
const pairsOf = ({a: [a, ...moreA], b: [b, ...moreB]}: Suggestion) =>
  a && b && moreA.length + moreB.length === 0 ? [[a, b] as const] : [];

/** Returns the pairs of a suggestion: the parts of a whole seam, without its mirror images. */
const refusedPairs = (one: SuggestedSeam) => (one.parts ?? [one]).flatMap(pairsOf);

const sameRun = (one: Run, other: Run): boolean =>
  one.length === other.length && one.every((edge) => has(other, edge));

/** Kinds of pieces that one edge of is sewn around several others. */
const rings: ReadonlySet<string | undefined> = new Set([
  'sleeve',
  'cuff',
  'collar',
  'hood',
  'band',
]);

const sewnPair = ([a, b]: Parts[number], sameDirection: boolean): Suggestion => ({
  ...{a: [a], b: [b], sameDirection},
});

/** Returns a whole seam as a question. */
function asked({parts, images, place, sameDirection}: WholeSeam): SuggestedSeam {
  const b = parts.map(([, other]) => other);
  return {
    a: parts.map(([one]) => one),
    b: sameDirection ? b : b.reverse(),
    ...{sameDirection, place},
    parts: [...parts, ...images].map((pair) => sewnPair(pair, sameDirection)),
    isPaired: images.length > 0,
  };
}

/** @param refused pairs of sides that the user rejected */
export function sewingOf(garment: GarmentDocument, refused: readonly SuggestedSeam[]): Sewing {
  const hooks = {refused: refused.flatMap(refusedPairs)};
  const isLeft = (one: Suggestion): boolean => !refused.some((other) => sameSides(one, other));
  const sides = lastOf((): readonly Candidate[] =>
    likeliestSides(garment, hooks)
      .map(({edge, side, p}) => ({a: side, b: [edge], p, sameDirection: false}))
      .filter(isLeft),
  );
  /**
   * Candidates with sides of several edges: the run is the partner of such a side, or part of it.
   */
  const sidesWith = (run: Run): readonly Candidate[] =>
    sides().flatMap((one): Candidate[] => {
      if (sameRun(one.b, run)) return [{...one, a: one.b, b: one.a}];
      return run.every((edge) => has(one.a, edge)) ? [one] : [];
    });
  const candidates = lastOf((run: Run): readonly Candidate[] => {
    const [first] = run;
    if (!first) return [];
    const single =
      run.length === 1
        ? rankPartners(garment, first, hooks).map(({edge, p, sameDirection}) => ({
            ...{a: run, b: [edge], p, sameDirection},
          }))
        : byLength(garment, run).filter(isLeft);
    const more = sidesWith(run).filter(
      ({b}) => run.length === 1 || !single.some((one) => sameRun(one.b, b)),
    );
    return [...more, ...single].sort((one, other) => other.p - one.p).slice(0, mostCandidates);
  });
  const darts = lastOf(() => openDarts(garment).map((pair) => sewnPair(pair, false)));
  /** Sleeves and bands that are set in as a ring. */
  const ringed = (): readonly SuggestedSeam[] =>
    sides()
      .filter(({b: [edge], p}) => {
        const name = garment.pieces[edge?.piece ?? -1]?.name ?? '';
        return p >= leastLikely && rings.has(wordsOf(name).kind);
      })
      .slice(0, 1);
  const questions = lastOf((): readonly SuggestedSeam[] => {
    const whole = wholeSeams(garment, leastLikely, hooks).map(asked);
    return whole.length > 0 ? whole : ringed();
  });
  const sure = lastOf(() => sureSeams(garment, hooks).map(sided));
  const best = (run: Run): Candidate | undefined => {
    const [first] = candidates(run);
    return first && first.p >= leastNamed ? first : undefined;
  };
  return {garment, candidates, best, sure, darts, questions, order: allEdges(garment)};
}

/** Returns a suggestion with one edge on each side. */
const sided = ({
  a,
  b,
  sameDirection,
}: {
  readonly a: EdgeOfPiece;
  readonly b: EdgeOfPiece;
  readonly sameDirection: boolean;
}): Suggestion => ({a: [a], b: [b], sameDirection});
