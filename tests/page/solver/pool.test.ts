import type {Page} from 'playwright-core';
import {solve} from 'seamwise/node';
import {afterEach, beforeEach, describe, expect, it} from 'vitest';

import {caughtUp, workersLeft} from '../../support/page/waiting.js';
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
/** Number of workers started; a replaced one counts. */
let workers: number;

/** Opens the page on a simulated device with so many cores. */
async function open(cores: number): Promise<void> {
  page = await openPage();
  await page.evaluate((value) => {
    Object.defineProperty(navigator, 'hardwareConcurrency', {value});
  }, cores);
  workers = 0;
  page.on('worker', (worker) => (workers += isHelper(worker) ? 0 : 1));
}

beforeEach(() => open(2));
afterEach(() => page.close());

describe('the pool', () => {
  it(
    'starts a worker with its first job, and shares it among leases when it may have no more',
    {tags: ['thorough']},
    async () => {
      await page.evaluate(() => {
        lease();
      });
      expect(workers).toBe(0);
      const results = await page.evaluate(
        (problem) => Promise.all([1, 2, 3].map((seed) => lease().solver.solve({...problem, seed}))),
        strips,
      );
      expect(workers).toBe(1);
      for (const [k, result] of results.entries()) {
        expect(withoutTimes(result)).toBe(withoutTimes(await solve({...strips, seed: k + 1})));
      }
    },
  );

  it('starts a worker before it is asked anything, if somebody wants it warm', async () => {
    await page.evaluate(() => {
      lease().warm();
      lease().warm();
    });
    await expect.poll(() => workers).toBe(1);
    const result = await page.evaluate((problem) => lease().solver.solve(problem), strips);
    expect(workers).toBe(1);
    expect(withoutTimes(result)).toBe(withoutTimes(await solve(strips)));
  });

  it('leaves a core to the page, and has four workers at most', {tags: ['thorough']}, async () => {
    for (const [cores, most] of [
      [3, 2],
      [16, 4],
    ] as const) {
      await page.close();
      await open(cores);
      await page.evaluate(
        (garment) => Promise.all([1, 2, 3, 4, 5, 6].map(() => lease().solver.convert(garment))),
        strips.garment,
      );
      expect(workers).toBe(most);
    }
  });

  it('gives all calls of a lease to one worker', {tags: ['thorough']}, async () => {
    await page.close();
    await open(4);
    await page.evaluate(async ({garment}) => {
      const {solver} = lease();
      lease();
      for (let k = 0; k < 3; k += 1)
        await Promise.all([solver.convert(garment), solver.symmetries(garment)]);
    }, strips);
    expect(workers).toBe(1);
  });

  it(
    'drapes for all leases in one worker of their own, one after the other, and solves meanwhile',
    {tags: ['thorough']},
    async () => {
      await page.close();
      await open(16);
      const told = await page.evaluate(
        async ([large, small]) => {
          const leases = [lease(), lease(), lease()];
          const [first, second] = leases;
          if (!first || !second) throw new Error('there are three');
          const result = await first.solver.solve(large);
          const order: (number | string)[] = [];
          const leaving = new AbortController();
          const drapes = leases.map(({solver}, k) =>
            solver.drape(
              result,
              {},
              {
                ...(k === 1 && {signal: leaving.signal}),
                onProgress: () => {
                  if (order.at(-1) !== k) order.push(k);
                },
              },
            ),
          );
          leaving.abort('enough'); // it is waiting for its turn
          const solved = second.solver.solve(small).then(() => order.push('solved'));
          const ends = await Promise.allSettled(drapes);
          await solved;
          return {order, ends: ends.map(({status}) => status)};
        },
        [tee, strips] as const,
      );
      expect(told.ends).toEqual(['fulfilled', 'rejected', 'fulfilled']);
      expect(told.order.filter((one) => one !== 'solved' && one !== 0)).toEqual([2]);
      // the solve ended before the first drape
      expect(told.order.indexOf('solved')).toBeLessThan(told.order.indexOf(2));
      expect(workers).toBe(3); // for two leases and for drapes
      await page.evaluate(() =>
        lease()
          .solver.convert('{}')
          .catch(() => undefined),
      );
      expect(workers).toBe(4);
    },
  );

  it('keeps workers for other places apart', {tags: ['thorough']}, async () => {
    await page.evaluate(async ({garment}) => {
      await lease().solver.convert(garment);
      await lease({workerUrl: 'breaking.worker.ts'}).solver.convert(garment);
      await lease({workerUrl: './breaking.worker.ts'}).solver.convert(garment);
    }, strips);
    expect(workers).toBe(2);
  });
});

describe('releasing', () => {
  it(
    'ends a worker that nobody has leased for some seconds, not one that is leased again',
    {tags: ['thorough']},
    async () => {
      await page.clock.install();
      const second = await page.evaluateHandle(async ({garment}) => {
        const first = lease();
        await first.solver.convert(garment);
        first.release();
        const second = lease();
        await second.solver.convert(garment);
        return second;
      }, strips);
      await page.clock.fastForward(60_000);
      await caughtUp(page);
      const kept = page.workers().filter((worker) => !isHelper(worker));
      expect([workers, kept.length]).toEqual([1, 1]);
      await second.evaluate(({release}) => {
        release();
      });
      await page.clock.fastForward(6000);
      await workersLeft(page, 0);
      const result = await page.evaluate((problem) => lease().solver.solve(problem), strips);
      expect(withoutTimes(result)).toBe(withoutTimes(await solve(strips)));
      expect(workers).toBe(2);
    },
  );

  it(
    'cancels what is pending of the lease, and disturbs no other lease',
    {tags: ['thorough']},
    async () => {
      const [ends, others] = await page.evaluate(
        async ([large, other]) => {
          const [leaving, staying] = [lease(), lease()];
          const codeOf = (error: unknown) => (error as {code: string}).code;
          const others = [1, 2, 3].map((seed) => staying.solver.solve({...other, seed}));
          const ends = [
            leaving.solver.solve(large, {onProgress: leaving.release}).catch(codeOf),
            leaving.solver.solve(large).catch(codeOf),
            leaving.solver.symmetries('{').catch(codeOf),
          ];
          const settled = await Promise.all(ends);
          settled.push(await leaving.solver.solve(other).catch(codeOf));
          leaving.release();
          return [settled, await Promise.all(others)] as const;
        },
        [jacket, tee] as const,
      );
      expect(ends).toEqual(['cancelled', 'cancelled', 'notJson', 'cancelled']);
      expect(workers).toBe(1);
      for (const [k, result] of others.entries()) {
        expect(withoutTimes(result)).toBe(withoutTimes(await solve({...tee, seed: k + 1})));
      }
    },
  );

  it(
    'does not end a worker that is deaf for a while, and at work for another lease',
    {tags: ['thorough']},
    async () => {
      const [ended, result] = await page.evaluate(async (problem) => {
        const places = {workerUrl: 'breaking.worker.ts'};
        const [leaving, staying] = [lease(places), lease(places)];
        const deaf = new Promise((resolve) => {
          new BroadcastChannel('hangs').addEventListener('message', resolve);
        });
        let result: Promise<unknown> | undefined;
        await new Promise<void>((resolve) => {
          const onProgress = () => {
            resolve();
          };
          result = staying.solver.solve(problem, {onProgress});
        });
        const ended = leaving.solver
          .solve(problem, {names: {garment: 'pauses'}})
          .catch((error: unknown) => (error as {code: string}).code);
        await deaf;
        leaving.release();
        return [await ended, (await result) as Awaited<ReturnType<typeof staying.solver.solve>>];
      }, jacket);
      expect(ended).toBe('cancelled');
      expect(withoutTimes(result)).toBe(withoutTimes(await solve(jacket)));
      expect(workers).toBe(1);
    },
  );
});

describe('aborting', () => {
  it(
    'settles every call at any moment, and the next solve is right',
    {tags: ['thorough']},
    async () => {
      const [reasons, result] = await page.evaluate(async (problem) => {
        const {solver} = lease();
        const reasons: unknown[] = [];
        for (const delay of [0, 1, 10, 30, 60, 100, 150, 250]) {
          const controller = new AbortController();
          const {signal} = controller;
          const ends = [
            solver.solve(problem, {signal}),
            solver.solve(problem, {signal}),
            solver.solve(problem, {signal}), // waits for its turn
          ];
          setTimeout(() => {
            controller.abort('enough');
          }, delay);
          for (const end of await Promise.allSettled(ends)) {
            reasons.push(end.status === 'rejected' ? end.reason : 'solved');
          }
        }
        return [reasons, await solver.solve(problem)] as const;
      }, jacket);
      expect(reasons).toEqual(Array(24).fill('enough'));
      expect(withoutTimes(result)).toBe(withoutTimes(await solve(jacket)));
      expect(workers).toBe(1);
    },
  );
});

describe('a worker that breaks', () => {
  it(
    'takes only its own jobs with it, and the next call of any lease works',
    {tags: ['thorough']},
    async () => {
      await page.close();
      await open(3);
      const [broken, whole, next] = await page.evaluate(
        async ([large, small]) => {
          const places = {workerUrl: 'breaking.worker.ts'};
          const [first, second, third] = [lease(places), lease(places), lease(places)];
          const codeOf = (error: unknown) => (error as {code: string}).code;
          const whole = second.solver.solve(large);
          const broken = await Promise.all([
            first.solver.solve(large, {names: {garment: 'throws'}}).catch(codeOf),
            third.solver.solve(large).catch(codeOf), // at the same time as the first
          ]);
          const next = await Promise.all(
            [first, second, third].map(({solver}) => solver.solve(small)),
          );
          return [broken, await whole, next] as const;
        },
        [jacket, strips] as const,
      );
      expect(broken).toEqual(['internal', 'internal']);
      expect(withoutTimes(whole)).toBe(withoutTimes(await solve(jacket)));
      const expected = withoutTimes(await solve(strips));
      expect(next.map(withoutTimes)).toEqual([expected, expected, expected]);
      expect(workers).toBe(3);
    },
  );
});
