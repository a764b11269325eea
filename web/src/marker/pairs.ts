/**
 * Pairs of mirrored pieces that are cut at once from both plies of folded fabric. Lengths in cm,
 * angles in radians.
 */
import {SolverError} from '../model/base/failure.js';
import {rotated, type MirrorMap, type Point} from '../model/geometry/vectors.js';
import {cutMap} from '../model/print/as-cut.js';
import {inverse, mirrors} from '../model/print/mirror-images.js';
import type {LaidTurns, MarkerPiece} from '../model/result/marker-search.js';
import {distanceTo} from '../model/geometry/polyline.js';
import type {SolveResult} from '../model/result/result.js';
import {mirrorImage} from '../scene/marks.js';
import type {MarkerOrder} from './problem.js';

/** Two pieces by their indices in a problem, and the map from the first to its mirror image. */
export interface CutPair {
  readonly first: number;
  readonly second: number;
  readonly map: MirrorMap;
}

/** Greatest distance between the cut lines of mirror images. [cm] */
const sameLine = 0.02;

const wrong = (message: string): SolverError => new SolverError({code: 'options', message});

/** The mirror image of each piece of a result, by name; a piece may be its own mirror image. */
function twinsIn({
  pieces,
  symmetries,
  print,
}: SolveResult): ReadonlyMap<string, {readonly name: string; readonly map: MirrorMap}> {
  const nameOf = (k: number): string => pieces[k]?.name ?? '';
  return new Map(
    symmetries.flatMap((symmetry) => {
      const {angle, translation} = symmetry.map;
      const second = symmetry.kind === 'piece' ? symmetry.piece : symmetry.pieces[1];
      const {alignment = symmetry.map} = pieces[second] ?? {};
      const map = {angle, translation: cutMap(alignment, print.delivered)(translation)};
      if (symmetry.kind === 'piece') {
        const name = nameOf(symmetry.piece);
        return [[name, {name, map}] as const];
      }
      const [one, other] = [nameOf(symmetry.pieces[0]), nameOf(symmetry.pieces[1])];
      return [[one, {name: other, map}] as const, [other, {name: one, map: inverse(map)}] as const];
    }),
  );
}

const liesOn = (line: readonly Point[], other: readonly Point[]): boolean =>
  line.every((p) => distanceTo(other, p) < sameLine);

/** Tolerance of a rotation. [rad] */
const sameTurn = 1e-6;

const rightTurns: Readonly<Record<LaidTurns, number>> = {
  ...{half: Math.PI, quarter: Math.PI / 2, any: 0},
};

/**
 * Returns whether the second piece keeps a rotation allowed by its grain, for every place of the
 * first.
 */
function keepsGrain(one: MarkerPiece, other: MarkerPiece, map: MirrorMap): boolean {
  const step = rightTurns[other.turns];
  const turn = one.alignment.angle + other.alignment.angle - map.angle;
  return step === 0 || Math.abs(turn - step * Math.round(turn / step)) < sameTurn;
}

/** Returns whether both pieces point the same way up, for every place of the first. */
function keepsUpside(one: MarkerPiece, other: MarkerPiece, map: MirrorMap): boolean {
  const angle = -one.alignment.angle;
  const rise = rotated(one.up, angle)[1] * rotated(other.up, -angle - map.angle)[1];
  return rise >= 0;
}

/**
 * Checks that two pieces mirror each other.
 * @throws {SolverError} if their cut lines or their print are not mirrored, or the nap or grain
 *   differs
 */
function checkMirrored({problem}: MarkerOrder, {first, second, map}: CutPair): void {
  const [one, other] = [problem.pieces[first], problem.pieces[second]];
  if (!one || !other) return;
  const image = one.outline.map((p) => mirrorImage(map, p));
  const named = one.name === other.name ? `'${one.name}'` : `'${one.name}' and '${other.name}'`;
  if (!liesOn(image, other.outline) || !liesOn(other.outline, image)) {
    throw wrong(
      `${named} are not cut as mirror images, so the plies of folded fabric cannot be cut at once; lay them on single fabric.`,
    );
  }
  const {print, ignoresPrint, nap} = problem;
  if (!ignoresPrint && !mirrors(print, map, one.alignment, other.alignment)) {
    throw wrong(
      `${named} do not show each other's mirror image of the print, as the plies of folded fabric do; lay them on single fabric.`,
    );
  }
  if (nap !== 'none' && !keepsUpside(one, other, map)) {
    throw wrong(
      `On the lower ply of folded fabric, the mirror image of '${one.name}' would lie upside down, against the nap; lay it on single fabric.`,
    );
  }
  if (!keepsGrain(one, other, map)) {
    throw wrong(
      `On the lower ply of folded fabric, the mirror image of '${one.name}' would lie off its grain; lay it on single fabric, or solve it on grain.`,
    );
  }
}

/**
 * All pieces of a problem in pairs.
 * @throws {SolverError} with the name of a piece that has no mirror image to be cut with
 */
export function cutPairs(order: MarkerOrder, results: readonly SolveResult[]): readonly CutPair[] {
  const numbersOf = (result: number, name: string): number[] =>
    order.pieces.flatMap((one, k) => (one.result === result && one.piece === name ? [k] : []));
  const pairs = results.flatMap((solved, result) => {
    const twins = twinsIn(solved);
    const done = new Set<string>();
    return [
      ...new Set(order.pieces.flatMap((one) => (one.result === result ? one.piece : []))),
    ].flatMap((name): CutPair[] => {
      if (done.has(name)) return [];
      const twin = twins.get(name);
      const [all, others] = [numbersOf(result, name), numbersOf(result, twin?.name ?? '')];
      if (!twin || others.length !== all.length) {
        throw wrong(
          `Piece '${name}' has no mirror image, which the lower ply of folded fabric would be; lay it on single fabric.`,
        );
      }
      done.add(twin.name);
      const {map} = twin;
      if (twin.name !== name) {
        return all.map((first, k) => ({first, second: others[k] ?? first, map}));
      }
      if (all.length % 2 !== 0) {
        throw wrong(
          `Piece '${name}' is its own mirror image, and both plies of folded fabric are cut at once; lay an even number of copies, or single fabric.`,
        );
      }
      return all.flatMap((first, k) => {
        const second = all[k + 1];
        return k % 2 === 0 && second !== undefined ? [{first, second, map}] : [];
      });
    });
  });
  for (const pair of pairs) checkMirrored(order, pair);
  return pairs;
}
