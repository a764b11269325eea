/** Searches in idle time, with answers of a stand-in for the solver. */
import {describe, expect, it, vi} from 'vitest';

import type {Design} from '@/model/design/design.js';
import type {SingleProblem} from '@/model/design/solve-problem.js';
import type {Print} from '@/model/print/repeating-print.js';
import type {SolveResult} from '@/model/result/result.js';
import type {SolverService} from '@/solver/service.js';
import {Afterwards} from '@/workbench/afterwards.js';
import {whileVisible} from '@/workbench/considerate.js';
import {canResize} from '@/workbench/other-sizes.js';

const design: Design = {
  garment: {name: 'two.json', text: '{}'},
  print: {
    ...{title: '', group: 'pmm', turnDeg: 0, oneWay: false, cell: 'primitive', image: ''},
    size: {width: 10, height: 8, angleDeg: 90},
  },
  ...{symmetry: 'none', seed: 1, method: 'best', options: {grain: {default: 'on'}}},
};

/** A result with so many of three seams that match. */
const matching = (matched: number): SolveResult => {
  const seamGroups = [0, 1, 2].map((k) => ({
    ...{seams: [k], place: 'side', visibility: 2},
    state: k < matched ? 'matches' : 'off',
  }));
  const empty = {pieces: [], seams: [], symmetries: []};
  const metrics = {answerCost: 1, method: 'best', searchBound: 1};
  return {...empty, seamGroups, metrics} as unknown as SolveResult;
};

/** A solved problem: its seed, and the sides and turn of its print. */
interface Asked {
  readonly seed: number;
  readonly width: number;
  readonly isTurned: boolean;
}

const askedIn = ({print, seed = 1}: SingleProblem): Asked => {
  const [x, y] = (print as Print).w1;
  return {seed, width: Number(Math.hypot(x, y).toFixed(6)), isTurned: y !== 0};
};

/** Work after a solve with these answers; `stopped` is called before each of them. */
function working(
  matched: (asked: Asked) => number,
  before: (asked: Asked) => void = () => undefined,
) {
  const asked: Asked[] = [];
  const solve = (problem: SingleProblem, {signal}: {signal?: AbortSignal} = {}) => {
    const one = askedIn(problem);
    before(one);
    if (signal?.aborted) return Promise.reject(new Error('stopped'));
    asked.push(one);
    return Promise.resolve(matching(matched(one)));
  };
  const kept = new Map<Design, SolveResult>();
  const afterwards: Afterwards = new Afterwards(
    {solve} as unknown as SolverService,
    (found, result) => kept.set(found, result),
  );
  return {afterwards, asked, kept};
}

describe('a longer search', () => {
  it('tries other seeds until four gain nothing, and offers more seams that match', async () => {
    const {afterwards, asked, kept} = working(({seed}) => (seed === 3 ? 2 : 1));
    await afterwards.search('longer', design, matching(1));
    expect(asked.map(({seed}) => seed)).toEqual([2, 3, 4, 5, 6, 7]);
    expect(afterwards.searches.better(design)).toEqual({seed: 3, gained: 1});
    expect([...kept.keys()].map(({seed}) => seed)).toEqual([3]);
    expect(afterwards.searches.isRunning('longer', design)).toBe(false);
  });

  it('reports a better answer as soon as there is one', async () => {
    const {afterwards, asked} = working(({seed}) => (seed === 3 ? 2 : 1));
    const {searches} = afterwards;
    let solvesBefore: number | undefined;
    searches.subscribe(() => {
      if (searches.better(design)) solvesBefore ??= asked.length;
    });
    await afterwards.search('longer', design, matching(1));
    expect(solvesBefore).toBe(2);
  });

  it('solves nothing again once its answer is taken, or taken back', async () => {
    const {afterwards, asked} = working(({seed}) => (seed === 3 ? 2 : 1));
    await afterwards.search('longer', design, matching(1));
    const taken = {...design, seed: 3};
    await afterwards.search('longer', taken, matching(2));
    await afterwards.search('longer', design, matching(1));
    expect(asked).toHaveLength(6);
    expect(afterwards.searches.better(taken)).toBeUndefined();
    expect(afterwards.searches.better(design)).toEqual({seed: 3, gained: 1});
  });

  it('stops at once, and continues where it ended', async () => {
    let isStopping = true;
    const {afterwards, asked} = working(
      () => 1,
      ({seed}) => {
        if (seed === 3 && isStopping) afterwards.stop();
      },
    );
    await afterwards.search('longer', design, matching(1));
    expect(asked.map(({seed}) => seed)).toEqual([2]);
    isStopping = false;
    await afterwards.search('longer', design, matching(1));
    expect(asked.map(({seed}) => seed)).toEqual([2, 3, 4, 5]);
  });

  it('does not begin again after the user has ended it', async () => {
    const {afterwards, asked} = working(
      () => 1,
      ({seed}) => {
        if (seed === 2) afterwards.searches.end('longer', design);
      },
    );
    await afterwards.search('longer', design, matching(1));
    await afterwards.follow({...design}, matching(3), false);
    expect(asked.filter(({seed}) => seed > 1)).toEqual([]);
  });
});

it('an order is searched neither for seeds nor for sizes', async () => {
  const {afterwards, asked} = working(() => 1);
  await afterwards.follow(design, matching(0), false);
  expect(asked).toEqual([]);
});

describe('sizes of the print', () => {
  it('are compared before its turns and other seeds, without a request', async () => {
    const {afterwards, asked} = working(({width}) => (width < 9.5 ? 2 : 1));
    await afterwards.follow(design, matching(1), true);
    const ten = asked.slice(0, 10).map(({width}) => width);
    expect(ten).toEqual([9, 9.2, 9.4, 9.6, 9.8, 10.2, 10.4, 10.6, 10.8, 11]);
    expect(asked.slice(10, 12)).toEqual([
      {seed: 1, width: 10, isTurned: true},
      {seed: 1, width: 10, isTurned: true},
    ]);
    expect(asked[12]).toEqual({seed: 2, width: 10, isTurned: false});
    const comparison = afterwards.searches.printSizes(design);
    expect(comparison?.better?.variant).toEqual({scale: 0.9, turnDeg: 0});
    expect(comparison?.sizes.map(({variant}) => variant.scale)).toHaveLength(11);
    expect(comparison?.turns.map(({variant}) => variant.turnDeg)).toEqual([0, 45, 90]);
  });

  it('still refer to the own size once another is taken, and none is solved again', async () => {
    const {afterwards, asked} = working(({width}) => (width < 9.5 ? 2 : 1));
    await afterwards.search('sizes', design, matching(1));
    const {print} = afterwards.searches.printSizes(design)?.better?.design ?? design;
    expect(print.size.width).toBe(9);
    const taken = {...design, print};
    asked.length = 0;
    await afterwards.search('sizes', taken, matching(2));
    expect(asked.filter(({isTurned}) => !isTurned)).toEqual([]);
    const comparison = afterwards.searches.printSizes(taken);
    expect(comparison?.present.variant.scale).toBe(0.9);
    expect(comparison?.better).toBeUndefined();
  });

  it('are those that a shop offers', async () => {
    const {afterwards, asked} = working(() => 1);
    afterwards.searches.offeredSizes = [0.95, 1];
    await afterwards.search('sizes', design, matching(1));
    expect(asked).toEqual([{seed: 1, width: 9.5, isTurned: false}]);
    afterwards.searches.offeredSizes = [];
    expect(afterwards.searches.hasOtherSizes(design)).toBe(false);
  });

  it('are not compared for fabric that is printed, or has no known size', () => {
    expect(canResize(design)).toBe(true);
    expect(canResize({...design, print: {...design.print, unscaled: true}})).toBe(false);
    expect(canResize({...design, print: {...design.print, isPrinted: true}})).toBe(false);
  });
});

it('work ends when the page is hidden, and begins again with the page', async () => {
  const page = Object.assign(new EventTarget(), {hidden: false});
  vi.stubGlobal('document', page);
  const show = (hidden: boolean): void => {
    page.hidden = hidden;
    page.dispatchEvent(new Event('visibilitychange'));
  };
  const signals: AbortSignal[] = [];
  const work = (signal: AbortSignal): Promise<string> =>
    new Promise((resolve, reject) => {
      signals.push(signal);
      if (signals.length === 2) resolve('done');
      signal.addEventListener('abort', () => {
        reject(new Error('ended'));
      });
    });
  const result = whileVisible(new AbortController().signal, work);
  await vi.waitFor(() => {
    expect(signals).toHaveLength(1);
  });
  show(true);
  await Promise.resolve();
  expect(signals[0]?.aborted).toBe(true);
  expect(signals).toHaveLength(1);
  show(false);
  expect(await result).toBe('done');
  vi.unstubAllGlobals();
});
