import type {Browser, Page} from 'playwright-core';
import {solve} from 'seamwise/node';
import {afterAll, afterEach, beforeAll, beforeEach, describe, expect, it} from 'vitest';

import {openBrowser, serveBuilt, strictPolicy} from '../../support/page/browser.js';
import {checks, twoStrips} from '../../support/garments/samples.js';
import {tee, useSolverPage, withoutTimes} from '../../support/page/solver-page.js';
import {caughtUp} from '../../support/page/waiting.js';

const strips = {garment: JSON.stringify(twoStrips()), print: checks};

/** Answers to the tee and to the strips in Node. */
let inNode: readonly string[];
beforeAll(async () => {
  inNode = await Promise.all([tee, strips].map(async (one) => withoutTimes(await solve(one))));
});

/** Leases solvers with these workers' addresses, starts several solves at once and then another. */
function solveWhile(page: Page, places: object) {
  return page.evaluate(
    async ([where, large, small]) => {
      const heard: {code: string; message: string}[] = [];
      const onBlocked = ({code, message}: {code: string; message: string}) => {
        heard.push({code, message});
      };
      const {solver} = lease({...where, onBlocked});
      const patterns: number[] = [];
      const results = await Promise.all([
        solver.solve(large, {onPattern: ({pieces}) => patterns.push(pieces.length)}),
        solver.solve(small),
      ]);
      results.push(await solver.solve(small));
      return {heard, patterns, results};
    },
    [places, tee, strips] as const,
  );
}

function expectSolved(
  {heard, patterns, results}: Awaited<ReturnType<typeof solveWhile>>,
  reason: RegExp,
): void {
  const message = expect.stringMatching(reason) as string;
  expect(heard).toEqual([{code: 'worker-blocked', message}]);
  expect(patterns).toEqual([4]);
  const [large, small] = inNode;
  expect(results.map(withoutTimes)).toEqual([large, small, small]);
}

describe('where a worker cannot be had, a lease solves all the same and says so once', () => {
  const openPage = useSolverPage();
  let page: Page;
  beforeEach(async () => {
    page = await openPage();
  });
  afterEach(() => page.close());

  it.each([
    ['its script is not there', {workerUrl: 'nowhere.js'}, /'nowhere\.js'; serve this script/],
    [
      'its script is elsewhere',
      {workerUrl: 'http://127.0.0.1:9/w.js'},
      /\(.+\); serve this script/,
    ],
    [
      'its script is another',
      {workerUrl: 'silent.worker.ts', loadingPatience: 1000},
      /\(nothing is heard of it for [\d.]+ s\)/,
    ],
  ])('%s', async (_, places, reason) => {
    expectSolved(await solveWhile(page, places), reason);
    await expect.poll(() => page.workers()).toEqual([]);
  });

  it('also for leases that come later, which try again only once all others are released', async () => {
    let asked = 0;
    page.on('request', (request) => (asked += Number(request.url().endsWith('nowhere.js'))));
    await page.clock.install();
    const heard = await page.evaluate(async (garment) => {
      Object.defineProperty(navigator, 'hardwareConcurrency', {value: 5});
      const heard: string[] = [];
      const leases = ['first', 'second'].map((name) =>
        lease({workerUrl: 'nowhere.js', onBlocked: () => heard.push(name)}),
      );
      for (const {solver} of leases) await solver.convert(garment);
      leases.push(lease({workerUrl: 'nowhere.js', onBlocked: () => heard.push('third')}));
      await leases[2]?.solver.convert(garment);
      for (const {release} of leases) release();
      return heard;
    }, strips.garment);
    expect(heard).toEqual(['first', 'second', 'third']);
    await caughtUp(page);
    expect(asked).toBe(2); // the first two started before the failure was known
    await page.clock.fastForward(6000); // no leases for a while
    await page.evaluate(
      (garment) => lease({workerUrl: 'nowhere.js'}).solver.convert(garment),
      strips.garment,
    );
    await caughtUp(page);
    expect(asked).toBe(3);
  });

  it('and cancels what is released', {tags: ['thorough']}, async () => {
    const codes = await page.evaluate(async (problem) => {
      const {solver, release} = lease({workerUrl: 'nowhere.js'});
      const codeOf = (error: unknown) => (error as {code: string}).code;
      const solving = [
        solver.solve(problem, {onProgress: release}).catch(codeOf),
        solver.solve(problem).catch(codeOf),
      ];
      return Promise.all(solving);
    }, tee);
    expect(codes).toEqual(['cancelled', 'cancelled']);
  });
});

describe('a module that is missing', () => {
  const openPage = useSolverPage();

  it('is another failure than a worker that is, with its own remedy', async () => {
    const page = await openPage();
    const failures = await page.evaluate(async (problem) => {
      const heard: string[] = [];
      const onBlocked = () => heard.push('blocked');
      const {solver} = lease({wasmUrl: 'nowhere.wasm', onBlocked});
      const ends = await Promise.allSettled([
        solver.solve(problem),
        solver.convert(problem.garment),
      ]);
      const failures = ends.map((end) => {
        const {code, message} = (end as PromiseRejectedResult).reason as Error & {code: string};
        return {code, message};
      });
      return {failures, heard};
    }, strips);
    const message = expect.stringMatching(/: .*; .*seamwise\.wasm is served.*\.$/) as string;
    const failure = {code: 'no-wasm', message};
    expect(failures).toEqual({failures: [failure, failure], heard: []});
    await page.close();
  });

  it('says so in a browser without WebAssembly', async () => {
    const page = await openPage();
    const failure = await page.evaluate(async (problem) => {
      Reflect.deleteProperty(globalThis, 'WebAssembly');
      return new InPage().solve(problem).catch((error: unknown) => {
        const {code, message} = error as Error & {code: string};
        return {code, message};
      });
    }, strips);
    const message = expect.stringContaining('this browser runs no WebAssembly') as string;
    expect(failure).toEqual({code: 'no-wasm', message});
    await page.close();
  });
});

describe("a page's policy", () => {
  let browser: Browser;
  beforeAll(async () => {
    browser = await openBrowser();
  });
  afterAll(() => browser.close());

  async function withPolicy(policy: string, check: (page: Page) => Promise<void>): Promise<void> {
    const served = await serveBuilt('solver', policy);
    const page = await browser.newPage();
    try {
      await page.goto(served.url);
      await page.waitForFunction(() => 'Client' in globalThis);
      await check(page);
    } finally {
      await page.close();
      await served.close();
    }
  }

  it('may forbid workers', async () => {
    const policy = strictPolicy.replace("worker-src 'self'", "worker-src 'none'");
    await withPolicy(policy, async (page) => {
      expectSolved(await solveWhile(page, {}), /worker-src 'self'\.$/);
      await expect.poll(() => page.workers()).toEqual([]);
    });
  });

  it('may forbid WebAssembly', async () => {
    const policy = strictPolicy.replace(" 'wasm-unsafe-eval'", '');
    await withPolicy(policy, async (page) => {
      const failures = await page.evaluate(async (problem) => {
        const failures: unknown[] = [];
        for (const solver of [lease().solver, new InPage()]) {
          const failure: unknown = await solver.solve(problem).catch((error: unknown) => {
            const {code, message} = error as Error & {code: string};
            return {code, message};
          });
          failures.push(failure);
        }
        return failures;
      }, strips);
      const message = expect.stringContaining("script-src 'wasm-unsafe-eval'.") as string;
      const failure = {code: 'no-wasm', message};
      expect(failures).toEqual([failure, failure]);
    });
  });
});
