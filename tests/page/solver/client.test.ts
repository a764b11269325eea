import type {Page} from 'playwright-core';
import {convert, mirror, prepare, solve, symmetries, type Symmetry} from 'seamwise/node';
import {afterEach, beforeEach, describe, expect, it} from 'vitest';

import type {FromThread} from '@/solver/threads/thread.js';
import {checks, twoStrips} from '../../support/garments/samples.js';
import {
  isHelper,
  jacket,
  tee,
  useSolverPage,
  withoutTimes,
} from '../../support/page/solver-page.js';

const strips = {garment: JSON.stringify(twoStrips()), print: checks};
const openPage = useSolverPage();
let page: Page;
/** Number of workers started, without helpers; a replaced one counts. */
let workers: number;

beforeEach(async () => {
  page = await openPage();
  workers = 0;
  page.on('worker', (worker) => (workers += isHelper(worker) ? 0 : 1));
});

afterEach(() => page.close());

describe('the client', () => {
  it('gives the same bytes as the solver in Node', async () => {
    const result = await page.evaluate((problem) => new Client().solve(problem), tee);
    expect(withoutTimes(result)).toBe(withoutTimes(await solve(tee)));
  });

  it('finds the same symmetries and converts to the same text as in Node', async () => {
    const garment = tee.garment as string;
    const found = await page.evaluate(async (text) => {
      const client = new Client();
      return Promise.all([client.symmetries(text), client.convert(text)]);
    }, garment);
    expect(found).toEqual([await symmetries(garment), await convert(garment)]);
  });

  it('prepares a pattern and measures a symmetry as Node does', async () => {
    const asked: Symmetry = {kind: 'pair', pieces: ['front', 'back']};
    const answers = await page.evaluate(
      async ([problem, symmetry]) => {
        const client = new Client();
        const pattern = client.prepare(problem);
        return Promise.all([pattern, client.mirror(problem.garment, symmetry)]);
      },
      [tee, asked] as const,
    );
    expect(answers).toEqual([await prepare(tee), await mirror(tee.garment, asked)]);
  });

  it('shows the pattern once, as soon as it is prepared', async () => {
    const told = await page.evaluate(async (problem) => {
      const told: unknown[] = [];
      await new Client().solve(problem, {
        onPattern: (pattern) => told.push(pattern),
        onProgress: ({phase}) => told.push(phase),
        onPartial: () => told.push('partial'),
      });
      return told;
    }, strips);
    const prepared = told.findIndex((step) => step !== 'preparation');
    expect(prepared).toBeGreaterThan(0);
    expect(told[prepared]).toEqual(await prepare(strips));
    expect(new Set(told.slice(prepared + 1))).toEqual(
      new Set(['alignment', 'deformation', 'partial']),
    );
  });

  it('takes objects and bytes, and leaves them to their owner', async () => {
    const [result, length] = await page.evaluate(async (problem) => {
      const bytes = new TextEncoder().encode(problem.garment);
      const solved = await new Client().solve({...problem, garment: bytes as unknown as string});
      return [solved, bytes.byteLength] as const;
    }, strips);
    expect(withoutTimes(result)).toBe(withoutTimes(await solve(strips)));
    expect(length).toBe(strips.garment.length);
  });

  it('reports progress that never falls and ends at 1, and alignments of every piece', async () => {
    const {fractions, phases, partials} = await page.evaluate(async (problem) => {
      const fractions: number[] = [];
      const phases = new Set<string>();
      const partials: number[][] = [];
      await new Client().solve(problem, {
        onProgress: ({phase, fraction}) => {
          fractions.push(fraction);
          phases.add(phase);
        },
        onPartial: (alignments) => partials.push([...alignments]),
      });
      return {fractions, phases: [...phases], partials};
    }, tee);
    expect(fractions).toEqual([...fractions].sort((a, b) => a - b));
    expect(fractions[0]).toBe(0);
    expect(fractions.at(-1)).toBe(1);
    expect(phases).toEqual(['preparation', 'alignment', 'deformation']);
    expect(partials.length).toBeGreaterThan(0);
    expect(partials.length).toBeLessThan(fractions.length); // there are none during preparation
    expect(partials.every((alignments) => alignments.length === 12)).toBe(true);
    expect(partials.flat().every(Number.isFinite)).toBe(true);
  });

  it('lets a small solve end while a large one goes on, in the same worker', async () => {
    const order = await page.evaluate(
      async ([large, small]) => {
        const client = new Client();
        const order: string[] = [];
        await Promise.all([
          client.solve(large).then(() => order.push('large')),
          client.solve(small).then(() => order.push('small')),
        ]);
        return order;
      },
      [jacket, strips] as const,
    );
    expect(order).toEqual(['small', 'large']);
    expect(workers).toBe(1);
  });
});

describe('cancelling', () => {
  it('rejects in the same task in the middle of a solve, and the worker goes on answering', async () => {
    const [name, tasks, result] = await page.evaluate(
      async ([large, small]) => {
        const client = new Client();
        const controller = new AbortController();
        let tasks = NaN;
        const name = await client
          .solve(large, {
            signal: controller.signal,
            onProgress: ({fraction}) => {
              if (fraction === 0 || controller.signal.aborted) return;
              tasks = 0;
              controller.abort();
              setTimeout(() => (tasks += 1));
            },
          })
          .catch((error: unknown) => (error as Error).name);
        return [name, tasks, await client.solve(small)] as const;
      },
      [jacket, strips] as const,
    );
    expect([name, tasks]).toEqual(['AbortError', 0]);
    expect(withoutTimes(result)).toBe(withoutTimes(await solve(strips)));
    expect(workers).toBe(1);
  });

  it('reaches the worker, which drops the job and takes no time from others for it', async () => {
    const ends = await page.evaluate(
      async ([large, small]) => {
        const ends: unknown[] = [];
        globalThis.Worker = class extends Worker {
          constructor(url: string | URL, options?: WorkerOptions) {
            super(url, options);
            this.addEventListener('message', ({data}: MessageEvent<FromThread>) => {
              if (data.kind === 'done') ends.push([data.job, 'done']);
              if (data.kind === 'failed') ends.push([data.job, data.failure.code]);
            });
          }
        };
        const client = new Client();
        const controller = new AbortController();
        const onProgress = () => {
          controller.abort();
        };
        const cancelled = client.solve(large, {signal: controller.signal, onProgress});
        await cancelled.catch(() => null);
        await client.solve(small);
        return ends;
      },
      [jacket, tee] as const,
    );
    expect(ends).toEqual([
      [1, 'cancelled'],
      [2, 'done'],
    ]);
  });

  it("rejects with the signal's own reason, also when it has fired before", async () => {
    const reasons = await page.evaluate(async (problem) => {
      const client = new Client();
      const early = client.solve(problem, {signal: AbortSignal.abort('too early')});
      const controller = new AbortController();
      const late = client.symmetries(problem.garment, {signal: controller.signal});
      controller.abort('too late');
      return (await Promise.allSettled([early, late])).map((end) =>
        end.status === 'rejected' ? (end.reason as string) : '',
      );
    }, strips);
    expect(reasons).toEqual(['too early', 'too late']);
  });

  it('comes of a listener that throws, with what it threw', async () => {
    const [message, format] = await page.evaluate(async (problem) => {
      const client = new Client();
      const onPartial = () => {
        throw new Error('listener');
      };
      const message = await client
        .solve(problem, {onPartial})
        .catch((error: unknown) => (error as Error).message);
      return [message, (await client.solve(problem)).format];
    }, strips);
    expect([message, format]).toEqual(['listener', 'seamwise-result/1']);
  });
});

describe('bad input', () => {
  it.each([
    ['that the page sees itself', {...strips, seed: 1.5}, 'options'],
    ['that the worker finds', {...strips, garment: '{"pattern": {"panels": {}}}'}, 'noPanels'],
  ])('%s gives the same failure as in Node, names included', async (_, problem, code) => {
    const names = {garment: 'my skirt.json'};
    const failure = await page.evaluate(
      ([bad, hooks]) =>
        new Client()
          .solve(bad, hooks)
          .catch((error: unknown) => ({...(error as object), message: (error as Error).message})),
      [problem, {names}] as const,
    );
    const inNode = await solve(problem, {names}).catch((error: unknown) => error as Error);
    expect(failure).toMatchObject({name: 'SolverError', code, piece: null, seam: null});
    expect(failure).toMatchObject({message: (inNode as Error).message});
  });
});
