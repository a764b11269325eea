/** Sizes of a print and seeds of a search, compared by the answers of a stand-in for the solver. */
import {describe, expect, it} from 'vitest';

import type {PrintSizes, PrintTurns} from '@/model/design/options.js';
import type {ComparedAnswer, Problem} from '@/model/design/solve-problem.js';
import type {Print} from '@/model/print/repeating-print.js';
import type {SeamGroup, SolveResult} from '@/model/result/result.js';
import {isBetter, standingOf} from '@/model/result/visible-seams.js';
import type {ProblemTexts, Requests} from '@/solver/requests/requests.js';
import {chosenProblem} from '@/solver/search/asked-search.js';
import {TextService} from '@/solver/service.js';

const print: Print = {group: 'p4m', w1: [4, 0], w2: [0, 4]};

const group = (state: SeamGroup['state'], visibility = 2): SeamGroup => ({
  ...{seams: [0], place: 'side', visibility, state},
});

/** An answer with `matched` of three visible seams. */
function answer(matched: number, answerCost = 10): SolveResult {
  const states = [0, 1, 2].map((k) => group(k < matched ? 'matches' : 'off'));
  const result = {print, seamGroups: [...states, group('off', 1), group('choice')]};
  return {...result, metrics: {answerCost}} as unknown as SolveResult;
}

/** A solver with given answers by w1's x and the seed; it counts its solves. */
class StandIn extends TextService {
  readonly asked: (readonly [width: number, seed: number])[] = [];
  readonly #answerTo: (width: number, seed: number) => SolveResult;

  constructor(answerTo: (width: number, seed: number) => SolveResult) {
    super();
    this.#answerTo = answerTo;
  }

  ask<K extends keyof Requests>(_: K, request: Requests[K]['request']) {
    const texts = request as ProblemTexts;
    expect(texts.options).not.toMatch(/printSize|auto/);
    const {w1} = JSON.parse(texts.print) as Print;
    this.asked.push([w1[0], texts.seed]);
    const {metrics, ...result} = this.#answerTo(w1[0], texts.seed);
    const answered = {...result, metrics: {...metrics, seed: texts.seed}};
    return Promise.resolve(answered) as Promise<Requests[K]['answer']>;
  }
}

const problem = (options: Problem['options']): Problem => ({
  ...{garment: '{}', print},
  ...(options !== undefined && {options}),
});
const sized = (printSize: PrintSizes): Problem => problem({printSize});

describe('several sizes of the print', () => {
  it('are compared by the visible seams that match, then by the mismatch', async () => {
    const found: Readonly<Record<string, SolveResult>> = {
      '4': answer(1, 5),
      '3.6': answer(2, 9),
      '3.8': answer(2, 8),
      '4.4': answer(0, 1),
    };
    const solver = new StandIn((width) => found[String(width)] ?? answer(0));
    const compared: ComparedAnswer[] = [];
    const result = await solver.solve(sized({sizes: [0.9, 0.95, 1.1]}), {
      onCompared: (one) => compared.push(one),
    });
    expect(result.print.scale).toBe(0.95);
    expect(compared.map(({scale, matched, isBest}) => [scale, matched, isBest])).toEqual([
      [1, 1, true],
      [0.9, 2, true],
      [0.95, 2, true],
      [1.1, 0, false],
    ]);
  });

  it('keep the own one, which is solved first, unless another is better', async () => {
    const solver = new StandIn(() => answer(2));
    const result = await solver.solve(sized({from: 0.9, to: 1.1}));
    expect(result.print).toEqual(print);
    expect(solver.asked.map(([width]) => width)).toEqual([
      4, 3.6, 3.68, 3.76, 3.84, 3.92, 4.08, 4.16, 4.24, 4.32, 4.4,
    ]);
  });

  it('end where every visible seam matches', async () => {
    const solver = new StandIn((width) => answer(width < 4 ? 3 : 0));
    await solver.solve(sized({from: 0.9, to: 1.1}));
    expect(solver.asked).toHaveLength(2);
  });

  it('leave out one that cannot be solved, and report it', async () => {
    const solver = new StandIn((width) => {
      if (width > 4) throw new Error('too large');
      return answer(1);
    });
    const refused: number[] = [];
    const onRefused = ({scale}: {readonly scale: number}) => refused.push(scale);
    await solver.solve(sized({sizes: [0.9, 1.1]}), {onRefused});
    expect(refused).toEqual([1.1]);
    const none = new StandIn(() => {
      throw new Error('no garment');
    });
    await expect(none.solve(sized({from: 0.9, to: 1.1}))).rejects.toThrow('no garment');
  });

  it('report one progress, which never falls, to 1', async () => {
    const fractions: number[] = [];
    const onProgress = ({fraction}: {readonly fraction: number}) => fractions.push(fraction);
    await new StandIn(() => answer(1)).solve(sized({sizes: [0.9]}), {onProgress});
    expect(fractions.at(-1)).toBe(1);
  });

  it('are abandoned with the signal', async () => {
    const ending = new AbortController();
    const solver = new StandIn(() => answer(1));
    const solving = solver.solve(sized({from: 0.9, to: 1.1}), {
      signal: ending.signal,
      onCompared: () => {
        ending.abort();
      },
    });
    await expect(solving).rejects.toThrow('aborted');
    expect(solver.asked).toHaveLength(1);
  });

  it.each([
    [3, 'printSize is 3, but must be a number from 0.5 to 2.'],
    [{sizes: []}, 'printSize.sizes must list 1 to 32 sizes.'],
    [{sizes: [1, 'x']}, 'a size of printSize is "x", but must be a number from 0.5 to 2.'],
    [{from: 1.1, to: 0.9}, 'printSize.from is greater than printSize.to; exchange them.'],
    [{from: 0.9}, 'printSize must be a number, {"from": 0.9, "to": 1.1} or {"sizes": [0.9, 1]}.'],
  ])('must not be %j', async (printSize, sentence) => {
    const solver = new StandIn(() => answer(1));
    const asked = sized(printSize as PrintSizes);
    await expect(solver.solve(asked)).rejects.toThrow(`options: ${sentence}`);
  });

  it('need a print of known size', async () => {
    const unscaled = {...sized(0.9), print: {...print, unscaled: true}};
    await expect(new StandIn(() => answer(1)).solve(unscaled)).rejects.toThrow(
      /size .* is unknown/,
    );
  });
});

describe('several turns of the print', () => {
  const turned = (printTurn: PrintTurns, more: Problem['options'] = {}): Problem =>
    problem({...(more as object), printTurn});

  it('are compared before the sizes, which have the best turn', async () => {
    const solver = new StandIn((width) => answer(Math.abs(width) < 3 ? 1 : 0));
    const result = await solver.solve(turned({turns: [45]}, {printSize: {sizes: [0.9]}}));
    const side = Math.SQRT1_2 * 4;
    expect(solver.asked.map(([width]) => width)).toEqual([
      4,
      expect.closeTo(side, 6),
      expect.closeTo(0.9 * side, 6),
    ]);
    expect(result.print).toEqual({...print, turnDeg: 45});
  });

  it('are left out with one that is no number of degrees', async () => {
    const asked = turned({turns: [45, 200]});
    await expect(new StandIn(() => answer(1)).solve(asked)).rejects.toThrow(
      'options: a turn of printTurn is 200, but must be a number from -180 to 180.',
    );
  });
});

describe('a longer search', () => {
  it('counts seams by the weights of the user', async () => {
    const all = new StandIn(() => answer(3));
    await all.solve(problem({effort: 'auto'}));
    expect(all.asked).toHaveLength(1);
    // makes a seam visible that does not match
    const weighted = new StandIn(() => answer(3));
    await weighted.solve(problem({effort: 'auto', weights: {0: 3}}));
    expect(weighted.asked).toHaveLength(5);
  });

  it('ends after four seeds without gain', async () => {
    const solver = new StandIn((_, seed) => answer(seed === 2 ? 2 : 1));
    const result = await solver.solve(problem({effort: 'auto'}));
    expect(result.metrics.seed).toBe(2);
    expect(solver.asked.map(([, seed]) => seed)).toEqual([1, 2, 3, 4, 5, 6]);
  });

  it('tries at most eight seeds, after the sizes, in the best of them', async () => {
    const solver = new StandIn((width, seed) => answer(width < 4 ? 1 : 0, 20 - seed));
    await solver.solve({...problem('{"effort":"auto","printSize":{"sizes":[0.9]}}'), seed: 4});
    expect(solver.asked).toEqual([
      [4, 4],
      ...[4, 5, 6, 7, 8, 9, 10, 11].map((seed) => [3.6, seed]),
    ]);
  });
});

it('the chosen problem is that of one solve, with size and seed', async () => {
  const asked = problem({effort: 'auto', printSize: {sizes: [0.9]}, maxChangeCm: 0.5});
  const solver = new StandIn((width, seed) => answer(width < 4 ? seed : 0));
  const result = await solver.solve(asked);
  const chosen = chosenProblem(asked, result);
  expect(chosen).toMatchObject({seed: 3, print: {w1: [3.6, 0], scale: 0.9}});
  expect(chosen.options).toEqual({maxChangeCm: 0.5});
  expect(await solver.solve(chosen)).toEqual(result);
});

it('answers without seam groups are compared by their mismatch', () => {
  const [one, other] = [1, 2].map((answerCost) => standingOf({metrics: {answerCost}}, undefined));
  expect(one && other && isBetter(one, other)).toBe(true);
});
