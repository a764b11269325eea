import {readFile} from 'node:fs/promises';

import {convert, solve} from 'seamwise/node';
import {expect, it} from 'vitest';

import {SharedModule} from '@/solver/load.js';
import {LocalSolver} from '@/solver/local.js';
import {warmUpProblems} from '@/solver/warm-up.js';
import {twoStrips} from './garments.js';

const module = await readFile(
  new URL('../../web/src/solver/module/seamwise.wasm', import.meta.url),
);
const garment = JSON.stringify(twoStrips());

it('says that the module is missing, what to do, and tries again with the next call', async () => {
  const found = [new TextEncoder().encode('not found'), module];
  const solver = new LocalSolver(() => ({wasmBinary: found.shift() ?? module}));
  await expect(solver.convert(garment, 'garment')).rejects.toMatchObject({
    name: 'SolverError',
    code: 'no-wasm',
    message: expect.stringMatching(/^The solver could not be loaded: .*; .*[^.]\.$/) as string,
  });
  expect(await solver.convert(garment, 'garment')).toBe(await convert(garment));
});

it('does not wait for a module that nobody wants any more', async () => {
  const never = new LocalSolver(() => new Promise(() => undefined));
  const signal = AbortSignal.timeout(20);
  await expect(never.convert(garment, 'garment', signal)).rejects.toThrow(/timeout/);
  await expect(never.convert(garment, 'garment', signal)).rejects.toBe(signal.reason);
});

it('gives up a module that does not come, and says so', async () => {
  const never: object = {instantiateWasm: () => ({})}; // as where a host sends nothing
  await expect(new SharedModule(() => never, 50).load()).rejects.toThrow(
    'seamwise.wasm has not come within 0.05 s',
  );
  const solver = new LocalSolver(() => never, {patience: 50});
  await expect(solver.convert(garment, 'garment')).rejects.toMatchObject({
    code: 'no-wasm',
    message: expect.stringMatching(/within 0\.05 s; check the connection.*[^.]\.$/) as string,
  });
});

it('takes a solver that is to be warm through all its stages', async () => {
  const results = await Promise.all(warmUpProblems.map((problem) => solve(problem)));
  expect(results.map(({symmetries}) => symmetries.length)).toEqual([1, 4, 4]);
  const reshaped = results.filter(({metrics}) => metrics.factorisations > 0);
  expect(reshaped).toHaveLength(1); // the others match as they lie
  for (const {metrics} of reshaped) expect(metrics.fit).toBeLessThan(metrics.fitAligned);
});
