import {readFile} from 'node:fs/promises';

import {convert, solve} from 'seamwise/node';
import {expect, it} from 'vitest';

import {localAnswerer} from '@/solver/answer-table.js';
import {SharedModule} from '@/solver/module/shared-module.js';
import {seamwise} from '@/solver/module/load.js';
import {warmUpProblems} from '@/solver/warm-up.js';
import {twoStrips} from '../../support/garments/samples.js';

const module = await readFile(
  new URL('../../../web/src/solver/module/seamwise.wasm', import.meta.url),
);
const garment = JSON.stringify(twoStrips());
const request = {garment, name: 'garment'};

it('says that the module is missing, what to do, and tries again with the next call', async () => {
  const found = [new TextEncoder().encode('not found'), module];
  const solver = localAnswerer({sources: {seamwise: () => found.shift() ?? module}});
  await expect(solver.answer('convert', request, {})).rejects.toMatchObject({
    name: 'SolverError',
    code: 'no-wasm',
    message: expect.stringMatching(/^The solver could not be loaded: .*; .*[^.]\.$/) as string,
  });
  expect(await solver.answer('convert', request, {})).toBe(await convert(garment));
});

/** Simulates a host without a response. */
const never = {sources: {seamwise: () => new Promise<never>(() => undefined)}};

it('does not wait for a module that nobody wants any more', async () => {
  const solver = localAnswerer(never);
  const signal = AbortSignal.timeout(20);
  await expect(solver.answer('convert', request, {signal})).rejects.toThrow(/timeout/);
  await expect(solver.answer('convert', request, {signal})).rejects.toBe(signal.reason);
});

it('gives up a module that does not come, and says so', async () => {
  const shared = new SharedModule(seamwise, never.sources.seamwise, 50);
  await expect(shared.load()).rejects.toThrow('seamwise.wasm has not come within 0.05 s');
  const solver = localAnswerer({...never, patience: 50});
  await expect(solver.answer('convert', request, {})).rejects.toMatchObject({
    code: 'no-wasm',
    message: expect.stringMatching(/within 0\.05 s; check the connection.*[^.]\.$/) as string,
  });
});

it('takes a solver that is to be warm through all its stages', async () => {
  const results = await Promise.all(warmUpProblems.map((problem) => solve(problem)));
  expect(results.map(({symmetries}) => symmetries.length)).toEqual([1, 4, 4]);
  const reshaped = results.filter(({metrics}) => metrics.factorisations > 0);
  expect(reshaped).toHaveLength(1); // the others match as drafted
  for (const {metrics} of reshaped) expect(metrics.fit).toBeLessThan(metrics.fitAligned);
});
