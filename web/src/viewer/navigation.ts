/** Moves a view by mouse, wheel, trackpad, touch and keys. Clicks stay clicks: only a real drag moves anything. */
import {distance, type Point} from '../model/geometry.js';

/** What can be moved. Screen points in CSS px from the upper left of the element. */
interface Navigable {
  fit(): void;
  zoomBy(factor: number, at?: Point): void;
  /** @param isModified by two fingers or with Shift, where one finger may mean something else */
  panBy(dx: number, dy: number, isModified?: boolean): void;
}

/** A pointer that stays within this is a click. [CSS px] */
const clickRange = 6;
const keyFactor = 1.25;
/** One notch of a wheel, and its share for a finer one. */
const notchFactor = 1.2;
const pixelsPerNotch = 100;
/** A trackpad's pinch comes as small steps of a wheel with ctrl. */
const pinchFactor = 1.01;

/** A wheel with notches moves up and down only, in large steps; a trackpad in small ones and sideways as well. */
function isNotched(event: WheelEvent): boolean {
  if (event.deltaMode !== WheelEvent.DOM_DELTA_PIXEL) return true;
  return event.deltaX === 0 && Math.abs(event.deltaY) >= 50 && Number.isInteger(event.deltaY);
}

const middle = (points: readonly Point[]): Point => [
  points.reduce((sum, [x]) => sum + x, 0) / points.length,
  points.reduce((sum, [, y]) => sum + y, 0) / points.length,
];

/** Mean distance from the middle, which a pinch changes. */
function spread(points: readonly Point[]): number {
  const centre = middle(points);
  return points.reduce((sum, point) => sum + distance(point, centre), 0) / points.length;
}

/** Whether somebody else follows this press, at a point of the element: then nothing here moves for it. */
export type TakesPress = (event: PointerEvent, at: Point) => boolean;

interface NavigationOptions {
  readonly takesPress?: TakesPress | undefined;
  /** Where the view is a part of a page that is read on: a wheel scrolls that, unless ctrl is held. */
  readonly leavesWheel?: boolean | undefined;
}

/** Listens on `element` until `signal` fires. The element is made focusable, for the keys. */
export function navigate(
  element: HTMLElement,
  view: Navigable,
  signal: AbortSignal,
  {takesPress = () => false, leavesWheel = false}: NavigationOptions = {},
): void {
  const fingers = new Map<number, Point>();
  let start: Point | undefined; // of a press that may still become a click
  let taken: number | undefined; // the pointer whose press somebody else follows

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
  // what ends a drag is no click
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
