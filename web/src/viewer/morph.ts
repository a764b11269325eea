/** The way of a drawing from what it showed to what it shows: how much of it is gone, and how a print lies on that way. */
import {rotated, type Alignment, type Point} from '../model/geometry.js';
import type {Print} from '../model/print.js';
import {apply, determinant, printElements, type PlaneMap} from '../model/wallpaper.js';

/** What of a drawing moves to its new place; the rest is there at once. The shapes alone while the print is still being placed. */
export type Motion = 'none' | 'shapes' | 'all';

/** [ms] */
export const morphTime = 200;

/** Fast at first, so that an interrupted way goes on without a halt. */
const eased = (share: number): number => 1 - (1 - share) ** 3;

/** Counts from the first frame on: what is shown later, or not at all meanwhile, is late by nothing. */
export class Morph {
  #start: number | undefined;
  #duration = 0;

  /** Whether there is still something to come. */
  get isRunning(): boolean {
    return this.#duration > 0;
  }

  /** Takes no time where people want no motion, or nobody looks. [ms] */
  begin(duration: number): void {
    const isStill = document.hidden || matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.#duration = isStill ? 0 : duration;
    this.#start = undefined;
  }

  end(): void {
    this.#duration = 0;
  }

  /** How much of the way is gone in this frame; 1 at its end. */
  get share(): number {
    if (!this.isRunning) return 1;
    const now = performance.now();
    this.#start ??= now;
    const share = (now - this.#start) / this.#duration;
    if (share < 1) return eased(Math.max(0, share));
    this.end();
    return 1;
  }
}

/** The point of the print under a point of a piece. */
const underneath = ({angle, translation: [x, y]}: Alignment, p: Point): Point =>
  rotated([p[0] - x, p[1] - y], -angle);

/** Into (-pi, pi]. */
const nearZero = (angle: number): number => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));

/** The vector of the lattice that is nearest to a vector, of a lattice whose cell is not very flat. */
function latticeVectorNear({w1, w2}: Print, [x, y]: Point): Point {
  const d = determinant({xx: w1[0], xy: w2[0], yx: w1[1], yy: w2[1], shift: [0, 0]});
  const u = Math.round((w2[1] * x - w2[0] * y) / d);
  const v = Math.round((w1[0] * y - w1[1] * x) / d);
  const around = [-1, 0, 1].flatMap((i) =>
    [-1, 0, 1].map((j): Point => [
      (u + i) * w1[0] + (v + j) * w2[0],
      (u + i) * w1[1] + (v + j) * w2[1],
    ]),
  );
  const off = (vector: Point): number => Math.hypot(vector[0] - x, vector[1] - y);
  return around.reduce((best, one) => (off(one) < off(best) ? one : best), [0, 0]);
}

const turnOf = ({xx, yx}: PlaneMap): number => Math.atan2(yx, xx);

/** What looks the same on the print as `to`, and is the least turn and the shortest way from `from`, seen from a point of the piece. */
export function nearestLike(print: Print, from: Alignment, to: Alignment, at: Point): Alignment {
  const turns = printElements(print).filter((element) => determinant(element) > 0);
  const change = (element: PlaneMap): number =>
    Math.abs(nearZero(to.angle - turnOf(element) - from.angle));
  const element = turns.reduce((best, one) => (change(one) < change(best) - 1e-9 ? one : best));
  const angle = from.angle + nearZero(to.angle - turnOf(element) - from.angle);
  const [x, y] = apply(element, underneath(to, at));
  const [fromX, fromY] = underneath(from, at);
  const [dx, dy] = latticeVectorNear(print, [fromX - x, fromY - y]);
  return lyingOn(angle, at, [x + dx, y + dy]);
}

/** A part of the way between two alignments, as seen from a point of the piece. */
export function between(from: Alignment, to: Alignment, share: number, at: Point): Alignment {
  const [a, b] = [underneath(from, at), underneath(to, at)];
  const angle = from.angle + share * (to.angle - from.angle);
  return lyingOn(angle, at, [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]);
}

/** The alignment that brings a point of the print under a point of the piece. */
function lyingOn(angle: number, at: Point, printPoint: Point): Alignment {
  const [x, y] = rotated(printPoint, angle);
  return {angle, translation: [at[0] - x, at[1] - y]};
}
