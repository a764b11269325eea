/** Cancelling in the middle of a garment of some thousand edges, at every stage of a solve. */
import type {Page} from 'playwright-core';
import {solve} from 'seamwise/node';
import {afterEach, beforeEach, expect, it} from 'vitest';

import type {FromThread} from '@/solver/threads/thread.js';
import {scallopedSkirt} from '../../support/garments/scalloped-skirt.js';
import {checks, twoStrips} from '../../support/garments/samples.js';
import {useSolverPage, withoutTimes} from '../../support/page/solver-page.js';

const strips = {garment: twoStrips(), print: checks};
const gored = {garment: JSON.stringify(scallopedSkirt(6, 1200)), print: checks};

const openPage = useSolverPage();
let page: Page;

beforeEach(async () => {
  page = await openPage();
});

afterEach(() => page.close());

/** Progress when symmetries are known, and when the garment is meshed. */
const [detected, meshed] = [0.105, 0.15];

it.each([
  ['read', 'preparation', 0],
  ['searched for symmetries', 'preparation', 0.01],
  ['meshed', 'preparation', detected],
  ['laid on the print', 'alignment', meshed],
  ['shaped', 'deformation', meshed],
] as const)('a garment may be given up while it is %s', async (_, phase, from) => {
  const [end, ends, dropped, next] = await page.evaluate(
    async ([large, small, phase, from]) => {
      const ends: string[] = [];
      let drop: (how: string) => void;
      const dropped = new Promise<string>((resolve) => {
        drop = resolve;
      });
      globalThis.Worker = class extends Worker {
        constructor(url: string | URL, options?: WorkerOptions) {
          super(url, options);
          this.addEventListener('message', ({data}: MessageEvent<FromThread>) => {
            if (data.kind !== 'done' && data.kind !== 'failed') return;
            if (data.job !== 2) return;
            drop(data.kind === 'done' ? 'done' : data.failure.code);
          });
        }

        /** The client replaces a worker that is in the middle of a long step. */
        override terminate(): void {
          super.terminate();
          drop('ended');
        }
      };
      const client = new Client();
      await client.solve(small); // the worker is ready
      const controller = new AbortController();
      const solved = client.solve(large, {
        signal: controller.signal,
        onProgress: (progress) => {
          if (progress.phase !== phase || progress.fraction < from) return;
          controller.abort();
          // the page does not wait for the worker
          setTimeout(() => ends.push('next task'));
        },
      });
      const end = await solved.then(
        () => 'solved',
        (error: unknown) => {
          ends.push('rejected');
          return (error as Error).name;
        },
      );
      return [end, ends, await dropped, await client.solve(small)] as const;
    },
    [gored, strips, phase, from] as const,
  );
  expect(end).toBe('AbortError');
  expect(ends).toEqual(['rejected', 'next task']);
  expect(dropped).toMatch(/^(cancelled|ended)$/);
  expect(withoutTimes(next)).toBe(withoutTimes(await solve(strips)));
});

it(
  'a garment that was given up at any stage is solved the next time as if it were the first',
  {tags: ['thorough']},
  async () => {
    const results = await page.evaluate(async (problem) => {
      const client = new Client();
      for (const stop of [0, 0.01, 0.105, 0.2, 0.9]) {
        const controller = new AbortController();
        const onProgress = ({fraction}: {fraction: number}) => {
          if (fraction >= stop) controller.abort();
        };
        await client.solve(problem, {signal: controller.signal, onProgress}).catch(() => undefined);
      }
      const [again, fresh] = [await client.solve(problem), await new Client().solve(problem)];
      return [again, fresh];
    }, gored);
    const [again, fresh] = results.map(withoutTimes);
    expect(again).toBe(fresh);
  },
);

it('symmetries may be given up while they are looked for', {tags: ['thorough']}, async () => {
  const [end, kind] = await page.evaluate(async ({garment}) => {
    const client = new Client();
    await client.convert(garment);
    const controller = new AbortController();
    const pending = client
      .symmetries(garment, {signal: controller.signal})
      .catch((error: unknown) => (error as Error).name);
    await client.convert('{').catch(() => undefined); // returns after the search has begun
    controller.abort();
    return [await pending, typeof (await client.convert(garment))] as const;
  }, gored);
  expect([end, kind]).toEqual(['AbortError', 'string']);
});
