/** Mirrors, glides and rotation centres of a group, in lattice coordinates and over a photo. */
import {determinant, type PlaneMap} from '../model/geometry/plane-map.js';
import {cross, leftOf, type Point} from '../model/geometry/vectors.js';
import {pixelOf} from '../model/print/photo-map.js';
import type {PhotoMap} from '../model/print/photo-reading.js';
import type {GroupName} from '../model/print/repeating-print.js';
import {printElements} from '../model/print/wallpaper.js';
import {boxOf, isInside, pathBetween, type LatticeBox, type PhotoSize} from './lattice-lines.js';

/** All points x with cross(along, x) = offset + n for whole n. */
interface AxisLines {
  /** Whole numbers without a common factor. */
  readonly along: Point;
  /** Range [0, 1). */
  readonly offset: number;
  readonly isMirror: boolean;
}

interface TurnCentre {
  readonly order: 2 | 3 | 4 | 6;
  /** Both coordinates in [0, 1); one such centre in every cell. */
  readonly at: Point;
}

const near = 1e-6;
const orders = new Map([
  [-2, 2],
  [-1, 3],
  [0, 4],
  [1, 6],
] as const);

const wholeSteps = [-2, -1, 0, 1, 2].flatMap((i) => [-2, -1, 0, 1, 2].map((j): Point => [i, j]));

/** Wraps a value into [0, 1); a value rounded to just below 1 becomes 0. */
const withinOne = (value: number): number => {
  const rest = value - Math.floor(value);
  return rest > 1 - near ? 0 : rest;
};

const elementsOf = (group: GroupName): readonly PlaneMap[] =>
  printElements({group, w1: [1, 0], w2: [0, 1]});

const factor = (a: number, b: number): number => (b === 0 ? Math.abs(a) : factor(b, a % b));

/** Returns the direction that a reflection of the lattice leaves unchanged. */
function axisOf({xx, xy, yx, yy}: PlaneMap): Point {
  const [x, y] = xx + 1 !== 0 || yx !== 0 ? [xx + 1, yx] : [xy, yy + 1];
  const common = factor(x, y) * (x < 0 || (x === 0 && y < 0) ? -1 : 1);
  return [x / common + 0, y / common + 0];
}

export function axesOf(group: GroupName): readonly AxisLines[] {
  const found = new Map<string, AxisLines>();
  for (const element of elementsOf(group)) {
    if (determinant(element) > 0) continue;
    const {xx, xy, yx, yy, shift} = element;
    const along = axisOf(element);
    for (const [i, j] of wholeSteps) {
      const [x, y] = [shift[0] + i, shift[1] + j];
      const [mx, my] = [xx * x + xy * y, yx * x + yy * y];
      const isMirror = Math.hypot(x + mx, y + my) < near;
      const offset = withinOne(cross(along, [(x - mx) / 4, (y - my) / 4]));
      const key = `${along.join()} ${offset.toFixed(4)}`;
      // a glide along a mirror is that mirror plus a translation of the lattice
      if (isMirror || !found.has(key)) found.set(key, {along, offset, isMirror});
    }
  }
  return [...found.values()];
}

export function centresOf(group: GroupName): readonly TurnCentre[] {
  const found = new Map<string, TurnCentre>();
  for (const element of elementsOf(group)) {
    const {xx, xy, yx, yy, shift} = element;
    const order = orders.get(Math.round(xx + yy) as -2 | -1 | 0 | 1);
    if (determinant(element) < 0 || order === undefined) continue;
    const whole = (1 - xx) * (1 - yy) - xy * yx;
    for (const [i, j] of wholeSteps) {
      const [x, y] = [shift[0] + i, shift[1] + j];
      const at: Point = [
        withinOne(((1 - yy) * x + xy * y) / whole),
        withinOne((yx * x + (1 - xx) * y) / whole),
      ];
      const key = at.map((share) => share.toFixed(4)).join();
      if ((found.get(key)?.order ?? 0) < order) found.set(key, {order, at});
    }
  }
  return [...found.values()];
}

/** Returns the part of a line inside a box. */
function within(
  {least, most}: LatticeBox,
  at: Point,
  along: Point,
): readonly [Point, Point] | undefined {
  let [from, to] = [-Infinity, Infinity];
  for (const k of [0, 1] as const) {
    if (along[k] === 0) {
      if (at[k] < least[k] || at[k] > most[k]) return undefined;
      continue;
    }
    const ends = [(least[k] - at[k]) / along[k], (most[k] - at[k]) / along[k]];
    from = Math.max(from, Math.min(...ends));
    to = Math.min(to, Math.max(...ends));
  }
  const point = (s: number): Point => [at[0] + s * along[0], at[1] + s * along[1]];
  return from < to ? [point(from), point(to)] : undefined;
}

interface ShownMarks {
  readonly mirrors: string;
  readonly glides: string;
  readonly centres: readonly {readonly order: TurnCentre['order']; readonly at: Point}[];
}

/** Greatest number of cells with marks; more cells are too small for them. */
const mostCells = 300;

/** Returns all visible marks. [px] */
export function marksOn(group: GroupName, map: PhotoMap, size: PhotoSize): ShownMarks {
  const box = boxOf(map, size);
  const {least, most} = box;
  const cells = (most[0] - least[0]) * (most[1] - least[1]);
  if (cells > mostCells) return {mirrors: '', glides: '', centres: []};
  const paths = (isMirror: boolean): string =>
    axesOf(group)
      .filter((axis) => axis.isMirror === isMirror)
      .flatMap((axis) => linesIn(box, axis))
      .map(([from, to]) => pathBetween(map, size, from, to))
      .join('');
  const centres = centresOf(group).flatMap(({order, at}) =>
    Array.from({length: cells}, (_, k) => {
      const across = most[0] - least[0];
      const [i, j] = [k % across, Math.floor(k / across)];
      const place: Point = [least[0] + i + at[0], least[1] + j + at[1]];
      return {order, at: pixelOf(map, size, place)};
    }).filter((one) => isInside(one.at, size)),
  );
  return {mirrors: paths(true), glides: paths(false), centres};
}

function linesIn(box: LatticeBox, {along, offset}: AxisLines): (readonly [Point, Point])[] {
  const {least, most} = box;
  const corners: readonly Point[] = [least, most, [least[0], most[1]], [most[0], least[1]]];
  const values = corners.map((corner) => cross(along, corner) - offset);
  const [first, last] = [Math.ceil(Math.min(...values)), Math.floor(Math.max(...values))];
  const [x, y] = leftOf(along);
  const squared = along[0] ** 2 + along[1] ** 2;
  return Array.from({length: Math.max(0, last - first + 1)}, (_, k) => {
    const share = (offset + first + k) / squared;
    return within(box, [share * x, share * y], along);
  }).filter((line) => line !== undefined);
}
