import {describe, expect, it} from 'vitest';

import {
  afterPointer,
  atRest,
  type Gesture,
  type PointerHappening,
} from '../../web/src/clicks/gesture.js';

const down = (x: number, y = 0, pointer = 1, taps = true): PointerHappening => ({
  type: 'down',
  pointer,
  at: [x, y],
  time: 1000,
  taps,
});
const move = (x: number, y = 0, pointer = 1): PointerHappening => ({
  type: 'move',
  pointer,
  at: [x, y],
});
const up = (pointer = 1, time = 1100): PointerHappening => ({type: 'up', pointer, time});

const after = (...events: readonly PointerHappening[]): Gesture =>
  events.reduce(afterPointer, atRest);

describe('a pointer', () => {
  it('taps where it comes down and up again', () => {
    expect(after(down(10, 20), up())).toMatchObject({stage: 'tap', at: [10, 20]});
  });

  it('has no tap before it is up', () => {
    expect(after(down(10, 20)).stage).toBe('press');
  });

  it('may tremble by 6 pixels in a tap, which counts where it began', () => {
    const tap = after(down(10), move(16), move(10, -6), up());
    expect(tap).toMatchObject({stage: 'tap', at: [10, 0]});
  });

  it('drags once it has moved further than 6 pixels', () => {
    expect(after(down(10), move(16.1)).stage).toBe('drag');
    expect(after(down(10), move(15, 5)).stage).toBe('drag');
  });

  it('does not tap after a drag that comes back', () => {
    expect(after(down(10), move(30), move(10)).stage).toBe('drag');
    expect(after(down(10), move(30), move(10), up())).toEqual(atRest);
  });

  it('says how long a tap was held', () => {
    expect(after(down(10), up(1, 1600))).toMatchObject({held: 600});
  });

  it('moves nothing before it drags, and then the whole way', () => {
    const press = after(down(10), move(15));
    expect(press.pointers.get(1)).toEqual([10, 0]);
    expect(afterPointer(press, move(17)).pointers.get(1)).toEqual([17, 0]);
  });

  it('drags at once with a button that does not tap', () => {
    expect(after(down(10, 0, 1, false)).stage).toBe('drag');
    expect(after(down(10, 0, 1, false), up())).toEqual(atRest);
  });

  it('does nothing while it hovers', () => {
    expect(after(move(10), move(40))).toBe(atRest);
  });

  it('does not tap when it is cancelled', () => {
    expect(after(down(10), {type: 'cancel', pointer: 1})).toEqual(atRest);
  });

  it('can tap again after a tap and after a drag', () => {
    expect(after(down(1), up(), down(2), up())).toMatchObject({stage: 'tap', at: [2, 0]});
    expect(after(down(1), move(50), up(), down(2), up())).toMatchObject({stage: 'tap'});
  });
});

describe('several pointers', () => {
  it('never tap, whichever is lifted first', () => {
    const both = [down(10), down(90, 0, 2)];
    expect(after(...both).stage).toBe('drag');
    expect(after(...both, up(2), up(1))).toEqual(atRest);
    expect(after(...both, up(1), up(2))).toEqual(atRest);
  });

  it('leave a drag to the one that stays down', () => {
    const gesture = after(down(10), down(90, 0, 2), up(1), move(91, 0, 2));
    expect(gesture).toEqual({stage: 'drag', pointers: new Map([[2, [91, 0]]])});
  });

  it('are followed each by itself', () => {
    const {pointers} = after(down(10), down(90, 0, 2), move(95, 5, 2));
    expect([...pointers]).toEqual([
      [1, [10, 0]],
      [2, [95, 5]],
    ]);
  });
});
