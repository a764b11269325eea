import {afterEach, beforeEach, expect, it, vi} from 'vitest';

import type {Design} from '@/model/design/design.js';
import {Steps} from '@/workbench/steps.js';

const design: Design = {
  garment: {name: 'tee.json', text: '{}'},
  print: {
    ...{title: 'Dots', group: 'p4m', size: {width: 8, height: 8, angleDeg: 90}, turnDeg: 0},
    ...{oneWay: false, cell: 'primitive', image: 'data:image/png,'},
  },
  symmetry: 'none',
  seed: 1,
  method: 'best',
  options: {maxChangeCm: 0},
};

function begun(): Steps {
  const steps = new Steps();
  steps.begin({past: [], present: {design, view: null}, future: []});
  return steps;
}

const limit = (steps: Steps, maxChangeCm: number, kind = 'limit'): void => {
  steps.change({options: {maxChangeCm}}, kind, null);
};

const limits = (steps: Steps): readonly unknown[] =>
  [...(steps.history?.past ?? []), steps.history?.present].map(
    (step) => step?.design.options.maxChangeCm,
  );

beforeEach(() => {
  vi.useFakeTimers({toFake: ['performance']});
});
afterEach(() => {
  vi.useRealTimers();
});

it('takes changes of one kind that follow each other quickly for one step', () => {
  const steps = begun();
  limit(steps, 1);
  vi.advanceTimersByTime(900);
  limit(steps, 2);
  vi.advanceTimersByTime(1100);
  limit(steps, 3);
  expect(limits(steps)).toEqual([0, 2, 3]);
});

it('takes a drag for one step, however long it rests, and nothing else with it', () => {
  const steps = begun();
  limit(steps, 1);
  steps.hold();
  limit(steps, 2);
  vi.advanceTimersByTime(60_000);
  limit(steps, 3);
  steps.letGo();
  limit(steps, 4);
  expect(limits(steps)).toEqual([0, 1, 3, 4]);
});

it('takes a change of another kind for a step of its own during a drag, too', () => {
  const steps = begun();
  steps.hold();
  limit(steps, 1);
  limit(steps, 2, '');
  limit(steps, 3);
  expect(limits(steps)).toEqual([0, 1, 2, 3]);
});

it('begins a step anew where one was taken back in the middle of a drag', () => {
  const steps = begun();
  steps.hold();
  limit(steps, 1);
  expect(steps.undo()).toBe(true);
  limit(steps, 2);
  expect(limits(steps)).toEqual([0, 2]);
});
