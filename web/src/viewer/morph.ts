/**
 * Animates a drawing from its last state to the next one: progress over time, and the alignment of
 * a print on the way.
 */
import {apply, determinant, type PlaneMap} from '../model/geometry/plane-map.js';
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
} from '../model/geometry/vectors.js';
import type {Print} from '../model/print/repeating-print.js';
import {printElements, reduced} from '../model/print/wallpaper.js';

/**
 * Parts of a drawing that are animated; the rest changes at once. `shapes` excludes the print while
 * it is still being placed.
 */
export type Motion = 'none' | 'shapes' | 'all';

/** [ms] */
export const morphTime = 200;

/** Fast at first, so that an interrupted motion continues without a halt. */
const eased = (share: number): number => 1 - (1 - share) ** 3;

/** Counts from its first frame, so that a late or hidden frame does not shorten it. */
export class Morph {
  #start: number | undefined;
  #duration = 0;

  /** Returns whether more frames follow. */
  get isRunning(): boolean {
    return this.#duration > 0;
  }

  /** Starts; the duration is 0 if the user prefers reduced motion or the page is hidden. [ms] */
  begin(duration: number): void {
    const isStill = document.hidden || matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.#duration = isStill ? 0 : duration;
    this.#start = undefined;
  }

  end(): void {
    this.#duration = 0;
  }

  /** Progress of the current frame; 1 at the end. */
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

/**
 * Returns the alignment equivalent to `to` that is reached from `from` by the least turn and the
 * shortest way, seen from a point of the piece.
 */
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

/** Returns an alignment between two others, seen from a point of the piece. */
export function between(from: Alignment, to: Alignment, share: number, at: Point): Alignment {
  const angle = from.angle + share * (to.angle - from.angle);
  return lyingOn(angle, at, pointBetween(onPrint(from, at), onPrint(to, at), share));
}
