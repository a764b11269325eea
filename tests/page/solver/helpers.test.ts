import {sampleOf} from '../../support/level.js';
/** Helpers: workers that a worker starts for its long tasks. */
import type {Page, Worker} from 'playwright-core';
import {solve} from 'seamwise/node';
import {afterEach, beforeEach, expect, it} from 'vitest';

import {isHelper, jacket, useSolverPage, withoutTimes} from '../../support/page/solver-page.js';

const openPage = useSolverPage();
let page: Page;
let helpers: Worker[];

beforeEach(async () => {
  page = await openPage();
  helpers = [];
  page.on('worker', (worker) => {
    if (isHelper(worker)) helpers.push(worker);
  });
});

afterEach(() => page.close());

it.each(sampleOf(2, [4, 1, 2]))(
  'are one less than %i cores, and make no difference to the result',
  {tags: ['thorough']},
  async (cores) => {
    const result = await page.evaluate(
      async ([problem, value]) => {
        Object.defineProperty(navigator, 'hardwareConcurrency', {value, configurable: true});
        return lease().solver.solve(problem);
      },
      [jacket, cores] as const,
    );
    expect(helpers).toHaveLength(cores - 1);
    expect(withoutTimes(result)).toBe(withoutTimes(await solve(jacket)));
  },
);

it('may break in the middle of a search', {tags: ['thorough']}, async () => {
  const solving = page.evaluate((problem) => new Client({}, () => 3).solve(problem), jacket);
  await expect.poll(() => helpers, {timeout: 60_000}).toHaveLength(3);
  await Promise.all(
    helpers.map((helper) =>
      helper.evaluate(() => {
        setTimeout(() => {
          self.close();
        }, 100);
      }),
    ),
  );
  expect(withoutTimes(await solving)).toBe(withoutTimes(await solve(jacket)));
});

it(
  'end with the worker that they help, and by themselves some seconds after the last solve',
  {tags: ['thorough']},
  async () => {
    const begin = () =>
      page.evaluate((problem) => {
        const client = new Client({}, () => 1);
        const abort = new AbortController();
        const cancelled = client.solve(problem, {signal: abort.signal}).catch(() => null);
        Object.assign(globalThis, {client, abort, cancelled});
      }, jacket);
    await begin();
    await expect.poll(() => helpers, {timeout: 60_000}).toHaveLength(1);
    await page.evaluate('client.dispose()');
    await expect.poll(() => page.workers(), {timeout: 2000}).toEqual([]);

    await begin();
    await expect.poll(() => helpers, {timeout: 60_000}).toHaveLength(2);
    await page.evaluate('abort.abort()');
    expect(page.workers()).toHaveLength(2);
    await expect.poll(() => page.workers().length, {timeout: 30_000}).toBe(1);
  },
);
