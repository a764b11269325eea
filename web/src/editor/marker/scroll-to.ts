/** Scrolls a part of the fabric into view. */
import type {Point} from '../../model/geometry/vectors.js';
import {offSheet} from '../../marker/sheet-frame.js';

/** Distance from the part to the edges of the view. [CSS px] */
const apart = 8;

/**
 * Returns the distance by which `low` to `high` misses a view `from` to `to`; 0 for a part that
 * fills the view.
 */
export function missed(low: number, high: number, from: number, to: number): number {
  const [before, after] = [low - from, high - to];
  if (before * after <= 0) return 0; // inside, or beyond both edges
  return Math.abs(before) < Math.abs(after) ? before : after;
}

/** Scrolls no further than needed. */
export function scrollTo(view: Element, shown: Element): void {
  const [{left, right, top, bottom}, seen] = [view, shown].map((one) =>
    one.getBoundingClientRect(),
  ) as [DOMRect, DOMRect];
  view.scrollBy({
    left: missed(seen.left - apart, seen.right + apart, left, right),
    top: missed(seen.top - apart, seen.bottom + apart, top, bottom),
    behavior: 'instant',
  });
}

/**
 * Returns the middle of the visible fabric in a view that scrolls.
 * @param sheet drawing of the fabric
 */
export function middleInSight(
  view: Element,
  sheet: SVGSVGElement,
  widthCm: number,
): Point | undefined {
  const matrix = sheet.getScreenCTM();
  if (!matrix) return undefined;
  const [seen, all] = [view, sheet].map((one) => one.getBoundingClientRect()) as [DOMRect, DOMRect];
  const x = (Math.max(seen.left, all.left) + Math.min(seen.right, all.right)) / 2;
  const y = (Math.max(seen.top, all.top) + Math.min(seen.bottom, all.bottom)) / 2;
  const [across, along] = offSheet(new DOMPoint(x, y).matrixTransform(matrix.inverse()));
  return [Math.min(widthCm, Math.max(0, across)), Math.max(0, along)];
}
