/** The way of a drawing from what it showed to what it shows: how much of it is gone, and how a print lies on that way. */
import {
  angleOf,
  between as pointBetween,
  lyingOn,
  minus,
  onPrint,
  plus,
  wrapped,
  type Alignment,
  type Point,
} from '../model/geometry.js';
import type {Print} from '../model/print.js';
import {apply, determinant, printElements, reduced, type PlaneMap} from '../model/wallpaper.js';

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

const turnOf = ({xx, yx}: PlaneMap): number => angleOf([xx, yx]);

/** What looks the same on the print as `to`, and is the least turn and the shortest way from `from`, seen from a point of the piece. */
export function nearestLike(print: Print, from: Alignment, to: Alignment, at: Point): Alignment {
  const turns = printElements(print).filter((element) => determinant(element) > 0);
  const change = (element: PlaneMap): number =>
    Math.abs(wrapped(to.angle - turnOf(element) - from.angle));
  const element = turns.reduce((best, one) => (change(one) < change(best) - 1e-9 ? one : best));
  const angle = from.angle + wrapped(to.angle - turnOf(element) - from.angle);
  const start = onPrint(from, at);
  const way = reduced(print, minus(apply(element, onPrint(to, at)), start));
  return lyingOn(angle, at, plus(start, way));
}

/** A part of the way between two alignments, as seen from a point of the piece. */
export function between(from: Alignment, to: Alignment, share: number, at: Point): Alignment {
  const angle = from.angle + share * (to.angle - from.angle);
  return lyingOn(angle, at, pointBetween(onPrint(from, at), onPrint(to, at), share));
}
