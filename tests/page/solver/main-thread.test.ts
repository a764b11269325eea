import {fileURLToPath} from 'node:url';

import type {Page} from 'playwright-core';
import {mirror, prepare, solve, type Symmetry} from 'seamwise/node';
import {afterEach, beforeEach, expect, it} from 'vitest';

import {checks, twoStrips} from '../../support/garments/samples.js';
import {jacket, tee, useSolverPage, withoutTimes} from '../../support/page/solver-page.js';

const strips = {garment: JSON.stringify(twoStrips()), print: checks};
/** Address of the module; Vite serves files outside of its root like this. */
const moduleUrl = `/@fs${fileURLToPath(new URL('../../../web/src/solver/module/seamwise.wasm', import.meta.url))}`;
const openPage = useSolverPage();
let page: Page;

beforeEach(async () => {
  page = await openPage();
});

afterEach(() => page.close());

it("solves to the worker's bytes on the page's own thread", {tags: ['thorough']}, async () => {
  const [inPage, inWorker] = await page.evaluate(
    (problem) => Promise.all([new InPage().solve(problem), new Client().solve(problem)]),
    tee,
  );
  expect(withoutTimes(inPage)).toBe(withoutTimes(inWorker));
});

it('answers the other questions, too, with a .wasm file from where it is told', async () => {
  const asked: Symmetry = {kind: 'pair', pieces: ['front', 'back']};
  const answers = await page.evaluate(
    async ([problem, symmetry, whereItIs]) => {
      const [here, there] = [new InPage({wasmUrl: whereItIs}), new Client()];
      return Promise.all([
        here.prepare(problem),
        here.mirror(problem.garment, symmetry),
        here.symmetries(problem.garment),
        there.symmetries(problem.garment),
        here.convert(problem.garment),
        there.convert(problem.garment),
      ]);
    },
    [tee, asked, moduleUrl] as const,
  );
  const [prepared, mirrored, symmetries, alsoSymmetries, converted, alsoConverted] = answers;
  expect([prepared, mirrored]).toEqual([await prepare(tee), await mirror(tee.garment, asked)]);
  expect([symmetries, converted]).toEqual([alsoSymmetries, alsoConverted]);
});

it(
  'works in slices, and lets the page work between any two of them',
  {tags: ['thorough']},
  async () => {
    const between = await page.evaluate(async (problem) => {
      const solver = new InPage();
      await solver.solve(problem); // compiles the module, meshes the garment
      const {port1, port2} = new MessageChannel();
      let [tasks, reports] = [0, 0];
      port1.onmessage = () => (tasks += 1);
      const missed: number[] = [];
      const onProgress = () => {
        if (tasks < reports) missed.push(reports);
        reports += 1;
        port2.postMessage(null); // another task for the page
      };
      await solver.solve({...problem, seed: 2}, {onProgress});
      port1.close();
      return {reports, missed};
    }, tee);
    expect(between.reports).toBeGreaterThan(5);
    expect(between.missed).toEqual([]);
  },
);

it('is aborted between any two slices, and goes on answering', async () => {
  const [ends, result] = await page.evaluate(
    async ([large, small]) => {
      const solver = new InPage();
      const ends: [unknown, number][] = [];
      for (const slices of [0, 1, 2, 5, 10, 20]) {
        const controller = new AbortController();
        let [seen, aborted] = [0, 0];
        if (slices === 0) controller.abort('enough');
        const onProgress = () => {
          seen += 1;
          if (seen === slices) {
            setTimeout(() => {
              aborted = seen;
              controller.abort('enough');
            });
          }
        };
        const {signal} = controller;
        const reason: unknown = await solver
          .solve(large, {signal, onProgress})
          .catch((thrown: unknown) => thrown);
        ends.push([reason, seen - aborted]);
      }
      return [ends, await solver.solve(small)] as const;
    },
    [jacket, strips] as const,
  );
  expect(ends).toEqual(Array(6).fill(['enough', 0]));
  expect(withoutTimes(result)).toBe(withoutTimes(await solve(strips)));
});

it('can be aborted while the module is on its way', {tags: ['thorough']}, async () => {
  await page.route('**/*.wasm', () => undefined); // never responds
  const reason = await page.evaluate(async (problem) => {
    const signal = AbortSignal.timeout(100);
    return new InPage().solve(problem, {signal}).catch((thrown: unknown) => (thrown as Error).name);
  }, strips);
  expect(reason).toBe('TimeoutError');
});
