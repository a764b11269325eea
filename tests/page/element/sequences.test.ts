/**
 * Random actions on elements at random times: the last state is shown, all promises settle, no
 * resources leak.
 */
import {order} from 'seamwise/node';
import type {Page} from 'playwright-core';
import {expect, it} from 'vitest';

import {twoStrips} from '../../support/garments/samples.js';
import {sample, tee, useElementPage, type ElementPage} from '../../support/page/element-page.js';
import {isHelper} from '../../support/page/solver-page.js';
import type {Sequence} from '../../support/pages/element/sequences.js';
import {cases} from '../../support/level.js';
import {workersLeft} from '../../support/page/waiting.js';

const openPage = useElementPage();

const heights = {s: 8, m: 10, l: 13};

async function openSmall(): Promise<ElementPage> {
  const open = await openPage({viewport: {width: 1200, height: 900}});
  for (const [size, height] of Object.entries(heights)) {
    await open.answer(`garments/strips-${size}.json`, (route) =>
      route.fulfill({json: twoStrips(height)}),
    );
  }
  await open.put('<main></main>');
  return open;
}

/** Runs these sequences, several at a time. */
const run = (page: Page, seeds: readonly number[]): Promise<readonly Sequence[]> =>
  page.evaluate(async (all) => {
    const holder = document.querySelector('main');
    if (!holder) throw new Error('It is gone.');
    const left = [...all];
    const done: Sequence[] = [];
    const work = async (): Promise<void> => {
      for (let seed = left.shift(); seed !== undefined; seed = left.shift()) {
        done.push(await sequence(seed, holder));
      }
    };
    await Promise.all([work(), work(), work(), work()]);
    return done;
  }, seeds);

/** Resources that the page holds after releasing all it can. */
async function held(page: Page): Promise<Record<string, number>> {
  const client = await page.context().newCDPSession(page);
  await client.send('Performance.enable');
  const card = await page.evaluate(() => heldByCard());
  await workersLeft(page, 0);
  for (let k = 0; k < 3; k++) await client.send('HeapProfiler.collectGarbage');
  const {metrics} = await client.send('Performance.getMetrics');
  await client.detach();
  const of = (name: string): number => metrics.find((one) => one.name === name)?.value ?? NaN;
  return {
    heap: of('JSHeapUsedSize'),
    nodes: of('Nodes'),
    listeners: of('JSEventListeners'),
    ...card,
    elements: await page.evaluate(() => document.querySelectorAll('seamwise-garment').length),
  };
}

const from = (seed: number, count: number): readonly number[] =>
  Array.from({length: count}, (_, k) => seed + k);

const wrongAmong = async (page: Page, seeds: readonly number[]): Promise<readonly Sequence[]> =>
  (await run(page, seeds)).filter((one) => one.wrong.length > 0);

it('shows the last state after random sequences', async () => {
  const {page} = await openSmall();
  expect(await wrongAmong(page, from(1, cases(10, 100)))).toEqual([]);
});

it('leaves nothing behind after random sequences', {tags: ['thorough']}, async () => {
  const {page} = await openSmall();
  const seeds = from(1, cases(10, 100));
  await run(page, seeds); // creates all one-time resources
  const before = await held(page);
  await run(page, seeds);
  const after = await held(page);
  for (const [name, value] of Object.entries(before)) {
    expect.soft(after[name], name).toBeLessThanOrEqual(1.1 * value);
  }
});

it(
  'can be ended at any moment: promises settle, the worker stays, the next answer is right',
  {tags: ['thorough']},
  async () => {
    const {put, page} = await openPage();
    await put('<main></main>');
    const [rounds, perRound] = [cases(2, 5), 12];
    const seen = await page.evaluate(
      async ([markup, rounds, perRound]) => {
        const main = document.querySelector('main');
        if (!main) throw new Error('It is gone.');
        const fresh = (k: number) => {
          main.innerHTML = markup;
          const element = main.querySelector('seamwise-garment');
          if (!element) throw new Error('It is gone.');
          element.size = k % 2 ? 'l' : 'm';
          return element;
        };
        const start = performance.now();
        await fresh(0).solve();
        const whole = performance.now() - start;
        const ends: string[] = [];
        const designs: string[] = [];
        const count = rounds * perRound;
        for (let k = 0; k < count; k++) {
          const element = fresh(k);
          const late = new AbortController();
          const abort = (): void => {
            late.abort();
          };
          // spread over a solve; the first moment precedes every answer, the last is after it
          if (k < count - 1) setTimeout(abort, (1.2 * whole * k) / count);
          ends.push(
            await element.solve({signal: late.signal}).then(
              () => 'answer',
              (error: unknown) => (error as Error).name,
            ),
          );
          abort();
          if (k % perRound !== perRound - 1) continue;
          await element.solve();
          designs.push(element.value);
        }
        return {ends, designs};
      },
      [tee, rounds, perRound] as const,
    );
    expect([...new Set(seen.ends)].sort()).toEqual(['AbortError', 'answer']);
    expect([seen.ends[0], seen.ends.at(-1)]).toEqual(['AbortError', 'answer']);
    expect(page.workers().filter((worker) => !isHelper(worker))).toHaveLength(1);
    const read = (url: string) =>
      Promise.resolve(Buffer.from(sample(url.slice(page.url().length))));
    expect(seen.designs).toHaveLength(rounds);
    for (const design of seen.designs) expect((await order(design, {read})).reproduced).toBe(true);
  },
);
