import {existsSync} from 'node:fs';
import {setTimeout as sleep} from 'node:timers/promises';

import * as fc from 'fast-check';
import {afterAll, beforeAll, expect, it} from 'vitest';

import {endlessJob, Shop, until} from '../../../support/cli/batch.js';
import {cases} from '../../../support/level.js';

let shop: Shop;
beforeAll(() => {
  shop = new Shop();
});
afterAll(() => {
  shop.remove();
});

const jobs = cases(60, 500);
const kills = cases(3, 20);
const threads = 2;

/** Moments of the kills: milliseconds after the start, or after the first result of the run. */
const moments = fc.sample(
  fc.record({afterResult: fc.boolean(), milliseconds: fc.integer({min: 0, max: 150})}),
  {seed: 12, numRuns: kills},
);

it('loses nothing and does nothing twice, whenever it is killed', async () => {
  const lines = Array.from({length: jobs}, (_, seed) => ({
    garment: 'strips-8.json',
    print: 'checks.json',
    seed,
  }));
  const wrong = {garment: 'checks.json', print: 'checks.json'};
  // the threads never finish these jobs, so each kill interrupts them
  const obstacles = Array.from({length: threads}, (_, seed) => ({...endlessJob, seed}));
  const middle = Math.floor(jobs / 2);
  shop.writeJobs('killed.ndjson', [
    ...lines.slice(0, middle),
    ...obstacles,
    ...lines.slice(middle),
    wrong,
  ]);
  shop.writeJobs('jobs.ndjson', [...lines, wrong]);
  const count = () => (existsSync(shop.at('out/results')) ? shop.results('out').length : 0);
  const words = ['batch', 'killed.ndjson', '--out', 'out', '--workers', String(threads)];
  for (const {afterResult, milliseconds} of moments) {
    const before = count();
    const batch = shop.start(words);
    // there are no further results once all threads run an endless job
    if (afterResult && before < middle / 2) await until(() => count() > before, batch);
    await sleep(milliseconds);
    batch.child.kill('SIGKILL');
    expect((await batch.end).code).toBe(null); // it was still running
  }
  const survived = count();
  expect(survived).toBeGreaterThan(0);
  expect(survived).toBeLessThan(jobs);

  expect(await shop.batch('jobs.ndjson', 'out')).toMatchObject({code: 1, err: ''});
  await shop.batch('jobs.ndjson', 'clean');
  const keys = shop.done('out').map(({key}) => key);
  expect(keys).toHaveLength(jobs + 1);
  expect(new Set(keys).size).toBe(jobs + 1);
  expect(shop.results('out')).toHaveLength(jobs);
  expect(shop.truth('out')).toEqual(shop.truth('clean'));
});
