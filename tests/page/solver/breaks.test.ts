import type {Page} from 'playwright-core';
import {solve} from 'seamwise/node';
import {afterEach, beforeEach, describe, expect, it} from 'vitest';

import {checks, twoStrips} from '../../support/garments/samples.js';
import {isHelper, jacket, useSolverPage, withoutTimes} from '../../support/page/solver-page.js';

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

describe('a worker that breaks', () => {
  it.each([
    ['throws', 'The solver broke: Uncaught Error: out of order.'],
    ['traps', 'The solver broke: unreachable.'],
    ['closes', 'The solver stopped answering; try again.'],
  ])(
    'and %s fails all that is pending; the next call gets another',
    {tags: ['thorough']},
    async (garment, message) => {
      const [failures, result] = await page.evaluate(
        async ([large, small, names]) => {
          const client = new Client({workerUrl: 'breaking.worker.ts'});
          const ends = await Promise.allSettled([
            client.solve(large, {names}),
            client.solve(large),
          ]);
          const failures = ends.map((end) => {
            const {name, code, message} = (end as PromiseRejectedResult).reason as {
              name: string;
              code: string;
              message: string;
            };
            return {name, code, message};
          });
          return [failures, await client.solve(small)] as const;
        },
        [jacket, strips, {garment}] as const,
      );
      const failure = {name: 'SolverError', code: 'internal', message};
      expect(failures).toEqual([failure, failure]);
      expect(withoutTimes(result)).toBe(withoutTimes(await solve(strips)));
      expect(workers).toBe(2);
      await expect.poll(() => page.workers().length, {timeout: 60_000}).toBe(1);
    },
  );

  it('and does not see a cancel is replaced, and what waited behind it solved', async () => {
    const [ended, result] = await page.evaluate(
      async ([large, small, names]) => {
        const client = new Client({workerUrl: 'breaking.worker.ts'});
        const controller = new AbortController();
        const hanging = new Promise((resolve) => {
          new BroadcastChannel('hangs').addEventListener('message', resolve);
        });
        const cancelled = client.solve(large, {names, signal: controller.signal});
        await hanging;
        const waiting = client.solve(small);
        controller.abort();
        const ended = await cancelled.catch((error: unknown) => (error as Error).name);
        return [ended, await waiting] as const;
      },
      [jacket, strips, {garment: 'hangs'}] as const,
    );
    expect(ended).toBe('AbortError');
    expect(withoutTimes(result)).toBe(withoutTimes(await solve(strips)));
    expect(workers).toBe(2);
    await expect.poll(() => page.workers().length, {timeout: 60_000}).toBe(1);
  });
});

describe('a solver that cannot start', () => {
  const elsewhere = 'http://127.0.0.1:9/worker.js';
  const nowhere = "could not be started from 'nowhere.js'";
  it.each([
    ['a script that is not there', {workerUrl: 'nowhere.js'}, 'worker-blocked', nowhere],
    ['a script from elsewhere', {workerUrl: elsewhere}, 'worker-blocked', elsewhere],
    ['another version', {workerUrl: 'stale.worker.ts'}, 'internal', 'different versions'],
    ['no .wasm file', {wasmUrl: 'nowhere.wasm'}, 'no-wasm', 'seamwise.wasm is served'],
  ])('fails every call with a sentence: %s', async (_, places, code, part) => {
    const failures = await page.evaluate(
      async ([problem, where]) => {
        const client = new Client(where);
        const failures: {code: string; message: string}[] = [];
        for (const attempt of [
          () => client.solve(problem),
          () => client.convert(problem.garment),
        ]) {
          const error: unknown = await attempt().catch((reason: unknown) => reason);
          const {code, message} = error as {code: string; message: string};
          failures.push({code, message});
        }
        return failures;
      },
      [strips, places] as const,
    );
    const escaped = part.replace(/[.]/g, '\\.');
    const message = expect.stringMatching(`^The .*${escaped}.*[^.]\\.$`) as string;
    expect(failures).toEqual([
      {code, message},
      {code, message},
    ]);
  });
});

describe('disposing', () => {
  it(
    'rejects what is pending and what comes, and ends the worker',
    {tags: ['thorough']},
    async () => {
      const codes = await page.evaluate(async (problem) => {
        const client = new Client();
        const pending = client.solve(problem, {
          onProgress: () => {
            client.dispose();
          },
        });
        const codes: unknown[] = [];
        codes.push(await pending.catch((error: unknown) => (error as {code: string}).code));
        codes.push(
          await client.solve(problem).catch((error: unknown) => (error as {code: string}).code),
        );
        return codes;
      }, jacket);
      expect(codes).toEqual(['cancelled', 'cancelled']);
      await expect.poll(() => page.workers()).toEqual([]);
    },
  );
});
