/** The time until the worker is free again after a cancelled request. */
import type {Page} from 'playwright-core';
import {afterEach, beforeEach, expect, it} from 'vitest';

import {scallopedSkirt} from '../support/garments/scalloped-skirt.js';
import {jacket, useSolverPage} from '../support/page/solver-page.js';
import {checks, twoStrips} from '../support/garments/samples.js';

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
  ['read', gored, 'preparation', 0],
  ['searched for symmetries', gored, 'preparation', 0.01],
  ['meshed', gored, 'preparation', detected],
  ['laid on the print', gored, 'alignment', meshed],
  ['shaped', gored, 'deformation', meshed],
  ['laid on the print as a sample', jacket, 'alignment', 0.01],
] as const)(
  'a garment that is %s is dropped in a tenth of a second',
  async (_, large, phase, from) => {
    const {rejected, begun} = await page.evaluate(
      async ([large, small, phase, from]) => {
        const client = new Client();
        await client.solve(small); // the worker is ready
        const controller = new AbortController();
        let asked = NaN;
        await client
          .solve(large, {
            signal: controller.signal,
            onProgress: (progress) => {
              if (progress.phase !== phase || progress.fraction < from) return;
              asked = performance.now();
              controller.abort();
            },
          })
          .catch(() => undefined);
        const rejected = performance.now() - asked;
        let begun = NaN;
        await client.solve(small, {
          onProgress: () => {
            if (Number.isNaN(begun)) begun = performance.now() - asked;
          },
        });
        return {rejected, begun};
      },
      [large, strips, phase, from] as const,
    );
    expect(rejected).toBeLessThan(100);
    expect(begun).toBeLessThan(600); // 100 ms on an idle machine
  },
);

it('a search for symmetries is dropped in a tenth of a second', async () => {
  const [end, begun] = await page.evaluate(async ({garment}) => {
    const client = new Client();
    await client.convert(garment);
    const controller = new AbortController();
    const pending = client
      .symmetries(garment, {signal: controller.signal})
      .catch((error: unknown) => (error as Error).name);
    await new Promise((resolve) => setTimeout(resolve, 150));
    const asked = performance.now();
    controller.abort();
    const end = await pending;
    await client.convert('{').catch(() => undefined);
    return [end, performance.now() - asked] as const;
  }, gored);
  expect(end).toBe('AbortError');
  expect(begun).toBeLessThan(600);
});
