import {readFile} from 'node:fs/promises';
import {setFlagsFromString} from 'node:v8';
import {runInNewContext} from 'node:vm';

import {convert, memory, solve, symmetries, type Problem} from 'seamwise/node';
import {expect, it} from 'vitest';

import {SharedModule} from '@/solver/module/shared-module.js';
import {seamwise} from '@/solver/module/load.js';
import {problemTexts} from '@/solver/requests/requests.js';
import {Solver} from '@/solver/answers/solve.js';
import {cases} from '../../support/level.js';
import {checks, sample, twoStrips} from '../../support/garments/samples.js';

const many = cases(100, 1000);

const problem: Problem = {garment: twoStrips(2), print: checks};

setFlagsFromString('--expose-gc');
const collectGarbage = runInNewContext('gc') as () => void;

interface Usage {
  /** Size of the module's heap. [bytes] */
  readonly heap: number;
  /** Memory in use on that heap. [bytes] */
  readonly live: number;
  /** Memory that JavaScript still references. [bytes] */
  readonly script: number;
}

async function usage(ofModule: () => Promise<Omit<Usage, 'script'>>): Promise<Usage> {
  await new Promise((resolve) => setTimeout(resolve, 10)); // releases timers and listeners
  collectGarbage();
  return {...(await ofModule()), script: process.memoryUsage().heapUsed};
}

/** Repeats `attempt` after a warm-up, and expects both heaps to have their earlier sizes. */
async function expectFlat(
  count: number,
  attempt: (k: number) => unknown,
  ofModule: () => Promise<Omit<Usage, 'script'>> = memory,
): Promise<void> {
  for (let k = 0; k < count / 5; k++) await attempt(k);
  const before = await usage(ofModule);
  for (let k = 0; k < count; k++) await attempt(k);
  const after = await usage(ofModule);
  expect(after.heap).toBe(before.heap);
  // A leak would exceed these limits many times over; compiled scripts take some memory.
  expect(after.live - before.live).toBeLessThan(1000);
  expect(after.script - before.script).toBeLessThan(1_000_000);
}

/** Aborts at the report with that number; the first one comes before any work. */
async function abortedAt(report: number, garment = problem.garment): Promise<void> {
  const controller = new AbortController();
  let reports = 0;
  const onProgress = () => {
    if (reports++ === report) controller.abort();
  };
  await solve({...problem, garment}, {signal: controller.signal, onProgress}).catch(() => null);
}

it(`memory stays as it is over ${many} solves`, async () => {
  await expectFlat(many, () => solve(problem));
}, 600_000);

it(`memory stays as it is over ${many} solves that are aborted early, late or by a listener`, async () => {
  await expectFlat(many, (k) => {
    if (k % 4 < 3) return abortedAt(k % 4);
    const onPartial = () => {
      throw new Error('listener');
    };
    return solve(problem, {onPartial}).catch(() => null);
  });
}, 600_000);

it('memory stays as it is over solves of a whole garment that are aborted in the middle', async () => {
  const tee = sample('tee');
  await solve({...problem, garment: tee}); // creates all that is kept for the next solve
  await expectFlat(cases(12, 30), (k) => abortedAt(1 + (k % 6), tee));
}, 600_000);

it(`memory stays as it is over ${many} solvers that are disposed of half way`, async () => {
  const wasmBinary = await readFile(
    new URL('../../../web/src/solver/module/seamwise.wasm', import.meta.url),
  );
  const module = await new SharedModule(seamwise, () => wasmBinary).load();
  const texts = problemTexts({...problem, garment: twoStrips(10)});
  const attempt = (k: number) => {
    const solver = new Solver(module, texts);
    for (let step = 0; step < k % 5; step++) solver.advance(0.1);
    solver.delete();
  };
  await expectFlat(many, attempt, () =>
    Promise.resolve({heap: module.heapBytes(), live: module.liveBytes()}),
  );
}, 600_000);

it(`memory stays as it is over ${many} failures of every stage`, async () => {
  const piece = 'left';
  const broken: readonly Problem[] = [
    {...problem, garment: '{'},
    {...problem, garment: '{"pattern": {"panels": {}}}'},
    {...problem, print: '{"group": "p4m", "w1": [4, 0], "w2": [1, 4]}'},
    {...problem, options: '{"pins": {"left": {"angle": 0, "translation": [1, 2, 3]}}}'},
    {...problem, symmetry: {symmetries: [{kind: 'piece', piece: 'sleeve'}]}},
    {
      ...problem,
      print: {...checks, group: 'p4'},
      symmetry: {symmetries: [{kind: 'piece', piece}]},
    },
    {
      ...problem,
      symmetry: {symmetries: [{kind: 'piece', piece, axis: [[0, 0], [5, 1]]}]}, // prettier-ignore
    },
  ];
  let failed = 0;
  await expectFlat(many, async (k) => {
    const one = broken[k % broken.length] ?? problem;
    await solve(one).catch(() => failed++);
  });
  expect(failed).toBe(1.2 * many); // including those of the warm-up
}, 600_000);

it(`memory stays as it is over ${many} detected symmetries and conversions`, async () => {
  await expectFlat(many / 2, async () => {
    await symmetries(twoStrips(2));
    await convert(twoStrips(2));
  });
}, 600_000);
