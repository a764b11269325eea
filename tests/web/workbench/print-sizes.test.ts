import {expect, it} from 'vitest';

import type {Design} from '@/model/design/design.js';
import type {ComparedAnswer} from '@/model/design/solve-problem.js';
import type {SolveResult} from '@/model/result/result.js';
import type {SolverService} from '@/solver/service.js';
import {Afterwards} from '@/workbench/afterwards.js';
import {bestSize, canResize, enlarged} from '@/workbench/print-sizes.js';

const design: Design = {
  garment: {name: 'two.json', text: '{}'},
  print: {
    ...{title: '', group: 'p1', turnDeg: 0, oneWay: false, cell: 'primitive', image: ''},
    size: {width: 10, height: 8, angleDeg: 90},
  },
  ...{symmetry: 'none', seed: 1, method: 'best', options: {maxChangeCm: 0.5}},
};

const answer = (scale: number, matched: number, isBest: boolean): ComparedAnswer => ({
  ...{scale, seed: 1, visible: 3, matched, answerCost: 1, isBest},
});

/** Compares with a solver that has these answers; `stopAfter` of them the user stops. */
async function compared(answers: readonly ComparedAnswer[], stopAfter = Infinity) {
  const solve: SolverService['solve'] = ({options}, {signal, onCompared} = {}) => {
    if (!JSON.stringify(options).includes('printSize')) return Promise.reject(new Error('later'));
    expect(options).toEqual({maxChangeCm: 0.5, printSize: {from: 0.9, to: 1.1}});
    for (const [k, one] of answers.entries()) {
      if (k === stopAfter) afterwards.stopPrintSizes();
      if (signal?.aborted) return Promise.reject(new Error('stopped'));
      onCompared?.(one);
    }
    return Promise.resolve({symmetries: []} as unknown as SolveResult);
  };
  const afterwards = new Afterwards({solve} as SolverService, (same) => same);
  const working = afterwards.comparePrintSizes(design, {} as SolveResult).catch(() => undefined);
  await expect.poll(() => afterwards.printSizes(design)?.isRunning).toBe(false);
  afterwards.stop();
  await working;
  return afterwards.printSizes(design);
}

it('sizes are told one by one, and the best one is offered', async () => {
  const better = answer(0.9, 2, true);
  const comparison = await compared([answer(1, 1, true), better, answer(1.1, 0, false)]);
  expect(comparison).toMatchObject({isRunning: false, answers: {length: 3}});
  expect(comparison && bestSize(comparison)).toBe(better);
  expect(enlarged(design.print, better.scale).size).toEqual({width: 9, height: 7.2, angleDeg: 90});
});

it('the present size is no offer', async () => {
  const comparison = await compared([answer(1, 2, true), answer(0.9, 1, false)]);
  expect(comparison && bestSize(comparison)).toBeUndefined();
});

it('a stopped comparison keeps the answers by then', async () => {
  const comparison = await compared([answer(1, 1, true), answer(0.9, 2, true)], 1);
  expect(comparison).toEqual({isRunning: false, answers: [answer(1, 1, true)]});
});

it('a print of unknown size has no other size', () => {
  expect(canResize(design)).toBe(true);
  expect(canResize({...design, print: {...design.print, unscaled: true}})).toBe(false);
});
