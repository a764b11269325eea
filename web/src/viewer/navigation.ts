/**
 * Moves a view by mouse, wheel, trackpad, touch and keys. Only a real drag moves the view; a click
 * remains a click.
 */
import {distance, type Point} from '../model/geometry/vectors.js';

/** A movable view. Screen points are in CSS px from the upper left of the element. */
interface Navigable {
  fit(): void;
  zoomBy(factor: number, at?: Point): void;
  /**
   * @param isModified true with two fingers or Shift; a view may give it another meaning than one
   * finger
   */
  panBy(dx: number, dy: number, isModified?: boolean): void;
}

/** Greatest movement of a pointer during a click. [CSS px] */
const clickRange = 6;
const keyFactor = 1.25;
/** Zoom factor for one notch of a wheel; smaller steps use a share of it. */
const notchFactor = 1.2;
const pixelsPerNotch = 100;
/** Zoom factor for each px of a trackpad's pinch, which arrives as small wheel steps with ctrl. */
const pinchFactor = 1.01;

/**
 * Returns whether an event is from a wheel with notches: vertical only, in large steps. A trackpad
 * sends small steps and moves sideways, too.
 */
function isNotched(event: WheelEvent): boolean {
  if (event.deltaMode !== WheelEvent.DOM_DELTA_PIXEL) return true;
  return event.deltaX === 0 && Math.abs(event.deltaY) >= 50 && Number.isInteger(event.deltaY);
}

const middle = (points: readonly Point[]): Point => [
  points.reduce((sum, [x]) => sum + x, 0) / points.length,
  points.reduce((sum, [, y]) => sum + y, 0) / points.length,
];

/** Returns the mean distance from the middle, which a pinch changes. */
function spread(points: readonly Point[]): number {
  const centre = middle(points);
  return points.reduce((sum, point) => sum + distance(point, centre), 0) / points.length;
}

/**
 * Returns whether other code handles this press at a point of the element; the view then stays
 * still.
 */
export type TakesPress = (event: PointerEvent, at: Point) => boolean;

interface NavigationOptions {
  readonly takesPress?: TakesPress | undefined;
  /**
   * True if the view is part of a scrolling page: the wheel scrolls the page unless ctrl is held.
   */
  readonly leavesWheel?: boolean | undefined;
}

/** Listens on `element` until `signal` fires. The element becomes focusable, for the keys. */
export function navigate(
  element: HTMLElement,
  view: Navigable,
  signal: AbortSignal,
  {takesPress = () => false, leavesWheel = false}: NavigationOptions = {},
): void {
  const fingers = new Map<number, Point>();
  let start: Point | undefined; // start of a press that may still become a click
  let taken: number | undefined; // pointer with a press that other code handles

  const at = (event: MouseEvent): Point => {
    const {left, top} = element.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  };
  const lift = (event: PointerEvent): void => {
    fingers.delete(event.pointerId);
    if (taken === event.pointerId) taken = undefined;
    if (fingers.size === 0) element.style.cursor = '';
  };
  const listen = <K extends keyof HTMLElementEventMap>(
    type: K,
    listener: (event: HTMLElementEventMap[K]) => void,
    capture = false,
  ): void => {
    element.addEventListener(type, listener, {signal, capture, passive: false});
  };

  element.tabIndex = 0;
  element.style.touchAction = 'none';

  listen('pointerdown', (event) => {
    if (event.pointerType === 'mouse' && event.button > 1) return;
    const point = at(event);
    start = fingers.size === 0 ? point : undefined;
    if (start && takesPress(event, point)) taken = event.pointerId;
    else fingers.set(event.pointerId, point);
  });
  listen('pointermove', (event) => {
    const from = fingers.get(event.pointerId);
    if (!from && event.pointerId !== taken) return;
    const to = at(event);
    if (start) {
      if (distance(start, to) < clickRange) return;
      start = undefined;
      if (from) element.style.cursor = 'grabbing';
    }
    if (!from) return;
    if (!element.hasPointerCapture(event.pointerId)) element.setPointerCapture(event.pointerId);
    const before = [...fingers.values()];
    fingers.set(event.pointerId, to);
    const after = [...fingers.values()];
    const [was, is] = [middle(before), middle(after)];
    view.panBy(is[0] - was[0], is[1] - was[1], before.length > 1 || event.shiftKey);
    if (spread(before) > 0) view.zoomBy(spread(after) / spread(before), is);
  });
  listen('pointerup', lift);
  listen('pointercancel', lift);
  // suppresses the click at the end of a drag
  listen(
    'click',
    (event) => {
      if (start || event.detail === 0) return;
      event.stopPropagation();
      event.preventDefault();
    },
    true,
  );

  listen('wheel', (event) => {
    if (leavesWheel && !event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    if (isNotched(event)) {
      const notches =
        event.deltaMode === WheelEvent.DOM_DELTA_PIXEL
          ? event.deltaY / pixelsPerNotch
          : Math.sign(event.deltaY);
      view.zoomBy(notchFactor ** -notches, at(event));
    } else if (event.ctrlKey || event.metaKey) {
      view.zoomBy(pinchFactor ** -event.deltaY, at(event));
    } else {
      view.panBy(-event.deltaX, -event.deltaY);
    }
  });

  const keys: Readonly<Record<string, () => void>> = {
    '+': () => {
      view.zoomBy(keyFactor);
    },
    '-': () => {
      view.zoomBy(1 / keyFactor);
    },
    '0': () => {
      view.fit();
    },
  };
  listen('keydown', (event) => {
    const action = keys[event.key === '=' ? '+' : event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  });
}
