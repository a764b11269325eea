import {expect, it} from 'vitest';

import type {Design} from '@/model/design/design.js';
import type {Print} from '@/model/print/repeating-print.js';
import type {SolveResult} from '@/model/result/result.js';
import type {SolverService} from '@/solver/service.js';
import {Afterwards} from '@/workbench/afterwards.js';
import {bestSize, canResize, enlarged} from '@/workbench/print-sizes.js';

const design: Design = {
  garment: {name: 'two.json', text: '{}'},
  print: {
    ...{title: '', group: 'pm', turnDeg: 0, oneWay: false, cell: 'primitive', image: ''},
    size: {width: 10, height: 8, angleDeg: 90},
  },
  ...{symmetry: 'none', seed: 1, method: 'best', options: {maxChangeCm: 0.5}},
};

/** A result with so many of three seams that match. */
const matching = (matched: number): SolveResult => {
  const seamGroups = [0, 1, 2].map((k) => ({
    ...{seams: [k], place: 'side', visibility: 2},
    state: k < matched ? 'matches' : 'off',
  }));
  return {seamGroups, metrics: {answerCost: 1}} as unknown as SolveResult;
};

/** Compares sizes with a solver that has these answers by width; the user stops it at one width. */
async function compared(matched: (width: number) => number, stopAt?: string) {
  const solve: SolverService['solve'] = ({print}, {signal} = {}) => {
    const [width] = (print as Print).w1;
    if (width.toFixed(1) === stopAt) afterwards.stopPrintSizes();
    if (signal?.aborted) return Promise.reject(new Error('stopped'));
    return Promise.resolve(matching(matched(width)));
  };
  const afterwards = new Afterwards({solve} as SolverService, (same) => same);
  const working = afterwards.comparePrintSizes(design, matching(0)).catch(() => undefined);
  await expect.poll(() => afterwards.printSizes(design)?.isRunning).toBe(false);
  afterwards.stop();
  await working;
  return afterwards.printSizes(design);
}

it('all sizes are compared, and the best one is offered', async () => {
  const comparison = await compared((width) => (width < 9.5 ? 2 : 1));
  expect(comparison?.answers.map(({scale}) => scale)).toEqual([
    1, 0.9, 0.92, 0.94, 0.96, 0.98, 1.02, 1.04, 1.06, 1.08, 1.1,
  ]);
  expect(comparison && bestSize(comparison)).toMatchObject({scale: 0.9, matched: 2});
});

it('the present size is no offer', async () => {
  const comparison = await compared(() => 1);
  expect(comparison && bestSize(comparison)).toBeUndefined();
});

it('a stopped comparison keeps the answers by then', async () => {
  const comparison = await compared(() => 1, '9.2');
  expect(comparison?.answers.map(({scale}) => scale)).toEqual([1, 0.9]);
});

it('a print of unknown size has no other size', () => {
  expect(canResize(design)).toBe(true);
  expect(canResize({...design, print: {...design.print, unscaled: true}})).toBe(false);
  expect(enlarged(design.print, 0.9).size).toEqual({width: 9, height: 7.2, angleDeg: 90});
});
