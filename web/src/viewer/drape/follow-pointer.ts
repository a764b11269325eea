/** Reports the points that a pointer hovers over or clicks. */
import type {Point} from '../../model/geometry/vectors.js';

/** Points of the element, from its upper left. [CSS px] */
interface PointerListener {
  /** Receives undefined once the pointer has left; called at most once per frame. */
  readonly point: ((at: Point | undefined) => void) | undefined;
  readonly pick: ((at: Point) => void) | undefined;
}

/** Listens on `host` until `signal` fires. A finger never hovers, but it clicks. */
export function followPointer(
  host: HTMLElement,
  signal: AbortSignal,
  {point, pick}: PointerListener,
): void {
  const place = ({clientX, clientY}: MouseEvent): Point => {
    const {left, top} = host.getBoundingClientRect();
    return [clientX - left, clientY - top];
  };
  let at: Point | undefined;
  let frame = 0;
  const moved = (event: PointerEvent): void => {
    if (event.buttons > 0 || event.pointerType === 'touch') return;
    at = event.type === 'pointerleave' ? undefined : place(event);
    frame ||= requestAnimationFrame(() => {
      frame = 0;
      if (!signal.aborted) point?.(at);
    });
  };
  if (point) {
    host.addEventListener('pointermove', moved, {signal});
    host.addEventListener('pointerleave', moved, {signal});
  }
  const picked = (event: MouseEvent): void => {
    pick?.(place(event));
  };
  if (pick) host.addEventListener('click', picked, {signal});
}
