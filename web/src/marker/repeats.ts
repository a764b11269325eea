/** How a print repeats across and along its cloth, and by which shifts it fits as well. Lengths in cm. */
import {combined, cross, minus, norm, type Point} from '../model/geometry.js';
import {
  apply,
  determinant,
  latticeAround,
  printElements,
  reduced,
  reducedBasis,
  type Repeat,
} from '../model/wallpaper.js';

/** As exact as a lattice is, as a share of its shortest vector. */
const tolerance = 1e-6;
/** Lattice vectors along the edges of the cloth have no greater coordinates; a print that is turned may have none. */
const reach = 12;

/** The shortest vector of the lattice in a direction. @param direction of length 1 */
function repeatAlong({w1, w2}: Repeat, direction: Point): number | undefined {
  const basis = reducedBasis(w1, w2);
  const near = tolerance * norm(basis[0]);
  const lengths = latticeAround(basis, reach)
    .filter((vector) => Math.abs(cross(vector, direction)) < near)
    .map(norm)
    .filter((length) => length > near);
  return lengths.length > 0 ? Math.min(...lengths) : undefined;
}

/** After how much of the cloth's length the print comes again; undefined where it never does. */
export const warpRepeat = (repeat: Repeat): number | undefined => repeatAlong(repeat, [0, 1]);

/** Steps finer than this across the cloth make no difference to anybody who measures it. */
const leastStep = 0.5;

/** The greatest length of which both are multiples, as far as they are known. */
function commonMeasure(one: number, other: number, near: number): number {
  let [a, b] = [Math.abs(one), Math.abs(other)];
  while (b > near) [a, b] = [b, a % b > b - near ? 0 : a % b];
  return a;
}

/** By how much the print may start further from the left edge and lie on the cloth as before, which is cut anywhere unless `isStartFixed`. */
export function acrossRepeat(repeat: Repeat, isStartFixed = false): number {
  const {w1, w2} = repeat;
  const shortest = norm(reducedBasis(w1, w2)[0]);
  const along = repeatAlong(repeat, [1, 0]) ?? shortest;
  if (isStartFixed) return along;
  const measure = commonMeasure(w1[0], w2[0], tolerance * shortest);
  return measure < leastStep ? along : measure;
}

/** Where a print may be moved freely, it is moved in steps of about this much, and to so many places at the most. */
const freeStep = 0.5;
const mostShifts = 400;

/** Whether a print may be moved by as little as one likes, along an axis or anywhere, and meet itself as before. */
export function movesFreely(repeat: Repeat): boolean {
  const [, other, third] = printElements(repeat);
  return !other || (!third && determinant(other) < 0);
}

/** In how many steps of equal length each vector of the lattice is gone through for shifts. */
function stepsOf({w1, w2, ...repeat}: Repeat): readonly [number, number] {
  const elements = printElements({w1, w2, ...repeat});
  const [identity, other] = elements;
  if (identity && !other) {
    const step = Math.max(freeStep, Math.sqrt((norm(w1) * norm(w2)) / mostShifts));
    const steps = (w: Point): number => Math.max(1, Math.floor(norm(w) / step));
    return [steps(w1), steps(w2)];
  }
  if (elements.length === 2 && other && determinant(other) < 0) {
    // even: across the axis, half a repeat fits as well
    const steps = (w: Point): number =>
      2 * Math.max(1, Math.min(mostShifts / 4, Math.round(norm(w) / (2 * freeStep))));
    return [steps(w1), steps(w2)];
  }
  return [6, 6]; // halves and thirds
}

/**
 * Shifts of the print, beside none, after which it meets itself at all seams as before: v for which every symmetry
 * followed by v is v followed by a symmetry. Where they run on without steps, some hundred of them.
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

/** How far apart two shifts are, less whole repeats. */
const shiftsApart = (repeat: Repeat, one: Point, other: Point): number =>
  norm(reduced(repeat, minus(one, other)));

/** The same, but of so many at most those that are furthest from none and from each other. */
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

/** Whether the print shows the same when it is turned upside down. */
export const hasHalfTurn = (repeat: Repeat): boolean =>
  printElements(repeat).some((element) => determinant(element) > 0 && element.xx < -1 + 1e-9);
