import {fileURLToPath} from 'node:url';

import type {Browser, Page} from 'playwright-core';
import {solve} from 'seamwise/node';
import {afterAll, beforeAll, expect, it, vi} from 'vitest';

import {openBrowser, serveBuilt, serveFiles, type Served} from '../../support/page/browser.js';
import {isHelper, jacket, tee, withoutTimes} from '../../support/page/solver-page.js';

vi.setConfig({testTimeout: 180_000});
let browser: Browser;

beforeAll(async () => {
  browser = await openBrowser();
});

afterAll(() => browser.close());

/**
 * Opens a path of the server, and fails on any violation of the policy or request to another
 * origin.
 */
async function withPage(served: Served, path: string, check: (page: Page) => Promise<void>) {
  const page = await browser.newPage();
  const complaints: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text());
  });
  page.on('request', (request) => {
    if (!request.url().startsWith(served.url)) complaints.push(request.url());
  });
  try {
    const answer = await page.goto(served.url + path);
    expect(answer?.headers()).toHaveProperty('content-security-policy');
    await check(page);
    expect(complaints).toEqual([]);
  } finally {
    await page.close();
    await served.close();
  }
}

it(
  'solves in a page that Vite has built, under a strict policy, with a worker to help the worker',
  {tags: ['thorough']},
  async () => {
    await withPage(await serveBuilt('solver'), '', async (page) => {
      await page.waitForFunction(() => 'Client' in globalThis);
      const solving = page.evaluate((problem) => new Client({}, () => 1).solve(problem), jacket);
      await expect.poll(() => page.workers().filter(isHelper), {timeout: 60_000}).toHaveLength(1);
      expect(withoutTimes(await solving)).toBe(withoutTimes(await solve(jacket)));
    });
  },
);

it('solves from the compiled files as they are, without a bundler', async () => {
  const dist = fileURLToPath(new URL('../../../dist', import.meta.url));
  await withPage(await serveFiles(dist), 'solver/page-solvers.js', async (page) => {
    await page.evaluate(
      "import('./page-solvers.js').then((all) => (globalThis.Client = all.SolverClient))",
    );
    const results = await page.evaluate(async (problem) => {
      const places = {workerUrl: 'solver.worker.js', wasmUrl: 'module/seamwise.wasm'};
      return Promise.all([new Client().solve(problem), new Client(places).solve(problem)]);
    }, tee);
    const expected = withoutTimes(await solve(tee));
    expect(results.map(withoutTimes)).toEqual([expected, expected]);
  });
});
