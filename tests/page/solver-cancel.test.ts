/** Cancelling in the midst of a garment of some thousand edges, at every stage of a solve. */
import type {Page} from 'playwright-core';
import {solve, type GarmentCodeSpecification, type Point} from 'seamwise/node';
import {afterEach, beforeEach, expect, it} from 'vitest';

import {checks, twoStrips} from '../wasm/garments.js';
import {useFixture, withoutTimes} from './fixture/open.js';

const strips = {garment: twoStrips(), print: checks};
const gored = {garment: JSON.stringify(scallopedSkirt(6, 1200)), print: checks};

/** A skirt of gores whose hems are scallops of many short edges each; its seams run against the grain. */
function scallopedSkirt(gores: number, edges: number): GarmentCodeSpecification {
  const hem = Array.from({length: edges}, (_, k): Point => {
    const x = (40 * k) / edges - 20;
    return [x, 1.2 * Math.abs(Math.sin((Math.PI * x) / 5)) ** 2];
  });
  const vertices: Point[] = [...hem, [20, 0], [11, 48], [-11, 50]];
  const gore = {
    vertices,
    edges: vertices.map((_, k) => ({endpoints: [k, (k + 1) % vertices.length] as const})),
  };
  const name = (k: number) => `gore ${String(k)}`;
  const numbers = [...Array(gores).keys()];
  return {
    pattern: {
      panels: Object.fromEntries(numbers.map((k) => [name(k), gore])),
      stitches: numbers.slice(1).map((k) => [
        {panel: name(k - 1), edge: edges},
        {panel: name(k), edge: edges + 2},
      ]),
    },
    properties: {curvature_coords: 'relative', units_in_meter: 100},
  };
}

const openPage = useFixture();
let page: Page;

beforeEach(async () => {
  page = await openPage();
});

afterEach(() => page.close());

/** Progress when symmetries are known, and when the garment is meshed. */
const [detected, meshed] = [0.105, 0.15];

it.each([
  ['read', 'preparation', 0],
  ['searched for symmetries', 'preparation', 0.01],
  ['meshed', 'preparation', detected],
  ['laid on the print', 'alignment', meshed],
  ['shaped', 'deformation', meshed],
] as const)('a garment may be given up while it is %s', async (_, phase, from) => {
  const [end, answered, begun, next] = await page.evaluate(
    async ([large, small, phase, from]) => {
      const client = new Client();
      await client.solve(small); // the worker is at hand
      const controller = new AbortController();
      let asked = NaN;
      const end = await client
        .solve(large, {
          signal: controller.signal,
          onProgress: (progress) => {
            if (progress.phase !== phase || progress.fraction < from) return;
            asked = performance.now();
            controller.abort();
          },
        })
        .then(
          () => 'solved',
          (error: unknown) => (error as Error).name,
        );
      const answered = performance.now() - asked;
      let begun = NaN;
      const next = await client.solve(small, {
        onProgress: () => {
          if (Number.isNaN(begun)) begun = performance.now() - asked;
        },
      });
      return [end, answered, begun, next] as const;
    },
    [gored, strips, phase, from] as const,
  );
  expect(end).toBe('AbortError');
  expect(answered).toBeLessThan(100);
  expect(begun).toBeLessThan(600); // 100 ms, were there nothing else to do for this machine
  expect(withoutTimes(next)).toBe(withoutTimes(await solve(strips)));
});

it('a garment that was given up at any stage is solved the next time as if it were the first', async () => {
  const results = await page.evaluate(async (problem) => {
    const client = new Client();
    for (const stop of [0, 0.01, 0.105, 0.2, 0.9]) {
      const controller = new AbortController();
      const onProgress = ({fraction}: {fraction: number}) => {
        if (fraction >= stop) controller.abort();
      };
      await client.solve(problem, {signal: controller.signal, onProgress}).catch(() => undefined);
    }
    const [again, fresh] = [await client.solve(problem), await new Client().solve(problem)];
    return [again, fresh];
  }, gored);
  const [again, fresh] = results.map(withoutTimes);
  expect(again).toBe(fresh);
});

it('symmetries may be given up while they are looked for', async () => {
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
