/** Scrolls a part of the fabric into view. */

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
