import {describe, expect, it} from 'vitest';

import {Afterwards} from '@/workbench/afterwards.js';
import {improving, Steps} from '@/workbench/steps.js';
import type {Design} from '@/model/design/design.js';
import type {SolveOptions} from '@/model/design/options.js';
import type {SolveResult} from '@/model/result/result.js';
import type {SolverService} from '@/solver/service.js';
import {plainMetrics, squarePair, squarePiece} from '../../support/garments/two-squares.js';

const design: Design = {
  garment: {name: 'two.json', text: '{}'},
  print: {
    ...{title: '', group: 'p1', turnDeg: 0, oneWay: false, cell: 'primitive', image: ''},
    size: {width: 10, height: 10, angleDeg: 90},
  },
  ...{symmetry: 'none', seed: 1, method: 'best', options: {maxChangeCm: 0.5}},
};

/** Two squares whose seam has this mismatch. [cm] */
const missing = (cm: number): SolveResult => ({
  ...{format: 'seamwise-result/1', units: 'cm', search: [], metrics: plainMetrics, notes: []},
  ...squarePair({
    pieces: [
      squarePiece('left_half'),
      squarePiece('right_half', {alignment: {angle: 0, translation: [-4, cm]}}),
    ],
  }),
});

/**
 * Returns the result of a search of each effort; a search without one waits until it is stopped.
 */
function searching(found: Readonly<Record<number, number>>): SolverService {
  const solve: SolverService['solve'] = ({options}, {signal} = {}) => {
    const cm = found[(options as SolveOptions).effort ?? 1];
    if (cm !== undefined) return Promise.resolve(missing(cm));
    return new Promise((_, reject) => {
      signal?.addEventListener('abort', () => {
        reject(new Error('stopped'));
      });
    });
  };
  return {solve} as SolverService;
}

/** A history that keeps better answers like a workbench. */
function keeping(found: Readonly<Record<number, number>>) {
  const steps = new Steps();
  steps.begin({past: [], present: {design, view: null}, future: []});
  const told: string[] = [];
  const kept: number[] = [];
  const present = (): Design => steps.history?.present.design ?? design;
  const afterwards = new Afterwards(searching(found), (from, effort) => {
    kept.push(effort);
    steps.change({options: {...from.options, effort}}, improving, null);
    return present();
  });
  afterwards.subscribe(() => {
    const {isRunning, isBetter, gained} = afterwards.improving(present()) ?? {};
    told.push(`${isRunning ? 'looking' : 'done'} ${isBetter ? `better by ${gained}` : ''}`.trim());
  });
  return {steps, told, kept, afterwards, present};
}

describe('improving', () => {
  it('looks twice as long each time, and keeps what is better as one step', async () => {
    const {steps, told, kept, afterwards, present} = keeping({2: 0.5, 4: 0.42, 8: 0.42, 16: 0.2});
    await afterwards.improve(design, missing(0.5));
    expect(kept).toEqual([4, 16]);
    expect(present().options).toEqual({maxChangeCm: 0.5, effort: 16});
    expect(steps.history?.past).toHaveLength(1);
    expect(new Set(told)).toEqual(
      new Set(['looking', 'looking better by 0', 'looking better by 1', 'done better by 1']),
    );
  });

  it('says when nothing better was found, and changes nothing', async () => {
    const {steps, told, afterwards} = keeping({1: 0.5, 2: 0.5, 4: 0.6, 8: 0.498, 16: 0.5});
    await afterwards.improve(design, missing(0.5));
    expect(steps.history?.past).toHaveLength(0);
    expect(told.at(-1)).toBe('done');
  });

  it('ends when it is stopped, and keeps what was gained by then', async () => {
    const {afterwards, present, told} = keeping({2: 0.2});
    const improvement = afterwards.improve(design, missing(0.5));
    while (told.at(-1) !== 'looking better by 1')
      await new Promise((resolve) => setTimeout(resolve));
    await new Promise((resolve) => setTimeout(resolve, 200));
    afterwards.stopImproving();
    await improvement;
    expect(told.at(-1)).toBe('done better by 1');
    expect(present().options.effort).toBe(2);
    expect(afterwards.improving(present())).toMatchObject({isRunning: false});
  });

  it('goes on from the effort that was made already', async () => {
    const {kept, afterwards} = keeping({16: 0.1});
    await afterwards.improve({...design, options: {effort: 8}}, missing(0.5));
    expect(kept).toEqual([16]);
  });
});
