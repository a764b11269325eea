/**
 * The repeat of a print across and along its fabric, and shifts that match as well. Lengths in cm.
 */
import {apply, determinant} from '../model/geometry/plane-map.js';
import {combined, cross, minus, norm, type Point} from '../model/geometry/vectors.js';
import {
  latticeAround,
  printElements,
  reduced,
  reducedBasis,
  type Repeat,
} from '../model/print/wallpaper.js';

/** Accuracy of a lattice, as a share of its shortest vector. */
const tolerance = 1e-6;
/**
 * Greatest coordinates of the lattice vectors searched along the fabric's edges. A rotated print
 * may have none.
 */
const reach = 12;

/**
 * Length of the shortest lattice vector in a direction.
 * @param direction of length 1
 */
function repeatAlong({w1, w2}: Repeat, direction: Point): number | undefined {
  const basis = reducedBasis(w1, w2);
  const near = tolerance * norm(basis[0]);
  const lengths = latticeAround(basis, reach)
    .filter((vector) => Math.abs(cross(vector, direction)) < near)
    .map(norm)
    .filter((length) => length > near);
  return lengths.length > 0 ? Math.min(...lengths) : undefined;
}

/** The repeat of the print along the fabric; undefined if it never repeats in that direction. */
export const warpRepeat = (repeat: Repeat): number | undefined => repeatAlong(repeat, [0, 1]);

/** Smallest step across the fabric that people can measure. [cm] */
const leastStep = 0.5;

/** The greatest length of which both are multiples, within a tolerance. */
function commonMeasure(one: number, other: number, near: number): number {
  let [a, b] = [Math.abs(one), Math.abs(other)];
  while (b > near) [a, b] = [b, a % b > b - near ? 0 : a % b];
  return a;
}

/**
 * The distance across the fabric after which the print may start with the same effect. The cut is
 * free unless `isStartFixed`.
 */
export function acrossRepeat(repeat: Repeat, isStartFixed = false): number {
  const {w1, w2} = repeat;
  const shortest = norm(reducedBasis(w1, w2)[0]);
  const along = repeatAlong(repeat, [1, 0]) ?? shortest;
  if (isStartFixed) return along;
  const measure = commonMeasure(w1[0], w2[0], tolerance * shortest);
  return measure < leastStep ? along : measure;
}

/** Step of a freely movable print [cm], and the greatest number of its shifts. */
const freeStep = 0.5;
const mostShifts = 400;

/**
 * Returns whether a print matches itself after arbitrarily small moves, along an axis or in any
 * direction.
 */
export function movesFreely(repeat: Repeat): boolean {
  const [, other, third] = printElements(repeat);
  return !other || (!third && determinant(other) < 0);
}

/** Number of equal steps along each lattice vector in the search for shifts. */
function stepsOf({w1, w2, ...repeat}: Repeat): readonly [number, number] {
  const elements = printElements({w1, w2, ...repeat});
  const [identity, other] = elements;
  if (identity && !other) {
    const step = Math.max(freeStep, Math.sqrt((norm(w1) * norm(w2)) / mostShifts));
    const steps = (w: Point): number => Math.max(1, Math.floor(norm(w) / step));
    return [steps(w1), steps(w2)];
  }
  if (elements.length === 2 && other && determinant(other) < 0) {
    // even, since half a repeat across the axis matches as well
    const steps = (w: Point): number =>
      2 * Math.max(1, Math.min(mostShifts / 4, Math.round(norm(w) / (2 * freeStep))));
    return [steps(w1), steps(w2)];
  }
  return [6, 6]; // covers halves and thirds
}

/**
 * Nonzero shifts of the print after which it matches at all seams as before: every v for which each
 * symmetry followed by v equals v followed by a symmetry. A continuous set is sampled by some
 * hundred of them.
 */
export function equalShifts(repeat: Repeat): readonly Point[] {
  const {w1, w2} = repeat;
  const turns = printElements(repeat).map((element) => ({...element, shift: [0, 0] as const}));
  const near = tolerance * norm(reducedBasis(w1, w2)[0]);
  const [m, n] = stepsOf(repeat);
  return Array.from({length: m * n - 1}, (_, k): Point => {
    const [i, j] = [Math.floor((k + 1) / n), (k + 1) % n];
    return combined([w1, w2], i / m, j / n);
  }).filter((v) => turns.every((turn) => norm(reduced(repeat, minus(v, apply(turn, v)))) < near));
}

/** The distance between two shifts, modulo whole repeats. */
const shiftsApart = (repeat: Repeat, one: Point, other: Point): number =>
  norm(reduced(repeat, minus(one, other)));

/** At most `most` of the equal shifts, chosen farthest from zero and from each other. */
export function spreadShifts(repeat: Repeat, most: number): readonly Point[] {
  const all = equalShifts(repeat);
  const chosen: Point[] = [];
  const room = all.map((v) => shiftsApart(repeat, v, [0, 0]));
  while (chosen.length < Math.min(most, all.length)) {
    const next = all[room.indexOf(Math.max(...room))] ?? [0, 0];
    chosen.push(next);
    for (const [k, v] of all.entries()) {
      room[k] = Math.min(room[k] ?? 0, shiftsApart(repeat, v, next));
    }
  }
  return chosen;
}

/** Returns whether the print is unchanged by a half turn. */
export const hasHalfTurn = (repeat: Repeat): boolean =>
  printElements(repeat).some((element) => determinant(element) > 0 && element.xx < -1 + 1e-9);
