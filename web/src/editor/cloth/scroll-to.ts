/** Brings what lies on the cloth into the part of it that is in sight. */

/** From it to the edges of the view. [CSS px] */
const apart = 8;

/** By how much what reaches from `low` to `high` misses a view from `from` to `to`; what is larger than the view fills it. */
export function missed(low: number, high: number, from: number, to: number): number {
  const [before, after] = [low - from, high - to];
  if (before * after <= 0) return 0; // it is within, or on both sides beyond
  return Math.abs(before) < Math.abs(after) ? before : after;
}

/** As little as is needed. */
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
