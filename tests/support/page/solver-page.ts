/** The page of the solver, opened in a browser: code that its tests share. */
import {readFileSync} from 'node:fs';

import type {Browser, Page, Worker} from 'playwright-core';
import type {Problem, SolveResult} from 'seamwise/node';
import {afterAll, beforeAll, vi} from 'vitest';

import {openBrowser, sourcesOf} from './browser.js';

const sample = (file: string) =>
  readFileSync(new URL(`../../../public/${file}.json`, import.meta.url), 'utf8');

export const tee: Problem = {garment: sample('garments/tee-m'), print: sample('prints/p4m')};

/** A problem that takes seconds. */
export const jacket: Problem = {
  garment: sample('garments/patchwork-jacket-m'),
  print: sample('prints/p4m'),
};

/** Returns whether it is a worker's helper. */
export const isHelper = (worker: Worker): boolean => worker.url().endsWith('#helper');

/** The parts of a result that equal runs share, as text. */
export function withoutTimes(result: SolveResult): string {
  const milliseconds = {alignment: 0, deformation: 0, total: 0};
  return JSON.stringify({...result, metrics: {...result.metrics, milliseconds}});
}

/**
 * Opens the browser once for a test file. @returns a function that opens the page in a fresh state
 */
export function useSolverPage(): () => Promise<Page> {
  vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything
  let browser: Browser | undefined;
  beforeAll(async () => {
    browser = await openBrowser();
  });
  afterAll(() => browser?.close());
  return async () => {
    if (!browser) throw new Error('The browser is not open yet.');
    const page = await browser.newPage();
    await page.goto(sourcesOf('solver'));
    await page.waitForFunction(() => 'Client' in globalThis);
    return page;
  };
}
