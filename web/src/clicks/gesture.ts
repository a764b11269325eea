/** Tells a tap from a drag. Screen points in CSS px, times in ms. */
import type {Point} from '../model/geometry.js';

/** What a pointer does. Buttons that neither tap nor drag are left out by who listens. */
export type PointerHappening =
  | {
      readonly type: 'down';
      readonly pointer: number;
      readonly at: Point;
      readonly time: number;
      /** False for the middle button of a mouse, which only drags. */
      readonly taps: boolean;
    }
  | {readonly type: 'move'; readonly pointer: number; readonly at: Point}
  | {readonly type: 'up'; readonly pointer: number; readonly time: number}
  | {readonly type: 'cancel'; readonly pointer: number};

/** Pointers that are down, and how far the view has followed each. */
export type Pointers = ReadonlyMap<number, Point>;

/** Until the last pointer is up, a drag stays one. */
export type Gesture =
  | {readonly stage: 'rest'; readonly pointers: Pointers}
  | {
      /** May become a tap yet. */
      readonly stage: 'press';
      readonly pointers: Pointers;
      readonly at: Point;
      readonly since: number;
    }
  | {readonly stage: 'drag'; readonly pointers: Pointers}
  | {
      /** The last press was one, where it began. It is so until the next press. */
      readonly stage: 'tap';
      readonly pointers: Pointers;
      readonly at: Point;
      readonly held: number;
    };

/** A pointer that never gets further than this from where it came down has tapped. [CSS px] */
export const tapRange = 6;

const nothingDown: Pointers = new Map();

export const atRest: Gesture = {stage: 'rest', pointers: nothingDown};

function lifted(gesture: Gesture, pointer: number): Gesture {
  const pointers = new Map([...gesture.pointers].filter(([id]) => id !== pointer));
  return pointers.size > 0 ? {stage: 'drag', pointers} : atRest;
}

/**
 * In a drag the view follows from the pointers before an event to those after it. A press has stayed
 * where it began, so that its first move as a drag makes up for the whole way.
 */
export function afterPointer(gesture: Gesture, event: PointerHappening): Gesture {
  if (event.type === 'down') {
    const {pointer, at, time, taps} = event;
    const pointers = new Map([...gesture.pointers, [pointer, at]]);
    return pointers.size === 1 && taps
      ? {stage: 'press', pointers, at, since: time}
      : {stage: 'drag', pointers};
  }
  if (!gesture.pointers.has(event.pointer)) return gesture;
  if (event.type === 'move') {
    const {pointer, at} = event;
    if (
      gesture.stage === 'press' &&
      Math.hypot(at[0] - gesture.at[0], at[1] - gesture.at[1]) <= tapRange
    )
      return gesture;
    return {stage: 'drag', pointers: new Map([...gesture.pointers, [pointer, at]])};
  }
  if (event.type === 'up' && gesture.stage === 'press')
    return {
      stage: 'tap',
      pointers: nothingDown,
      at: gesture.at,
      held: event.time - gesture.since,
    };
  return lifted(gesture, event.pointer);
}
