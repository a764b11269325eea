/** Odd arguments of the solver's functions in a page. */
import type {Page} from 'playwright-core';
import {failureCodes, pageFailureCodes} from 'seamwise';
import {solve, type Problem} from 'seamwise/node';
import {beforeEach, expect, it} from 'vitest';

import {checks, twoStrips} from '../../support/garments/samples.js';
import {cases} from '../../support/level.js';
import {faultOf, oddValues, partsOf, withPart} from '../../support/odd-values.js';
import {useSolverPage} from '../../support/page/solver-page.js';

const codes = [...Object.keys(failureCodes), ...pageFailureCodes];
const openPage = useSolverPage();
let page: Page;

/** Functions of the solver with valid arguments, to which a signal is added. */
type Calls = Readonly<Record<string, readonly unknown[]>>;
let calls: Calls;

declare global {
  var oddOnes: {
    readonly values: Readonly<Record<string, unknown>>;
    readonly partsOf: typeof partsOf;
    readonly withPart: typeof withPart;
    readonly faultOf: typeof faultOf;
  };
}

const lattice = {homography: [16, 0, 0, 0, 16, 0, 0, 0, 1], lens: 0};
const shape = [
  [1, 0],
  [0, 1],
];
const square = [
  [0, 0],
  [5, 0],
  [5, 5],
  [0, 5],
];
const alignment = {angle: 0, translation: [0, 0]};

beforeEach(async () => {
  const garment = JSON.stringify(twoStrips());
  const print = {...checks} as Problem['print'];
  const problem = {garment, print, options: {maxChangeCm: 1}, method: 'best', seed: 1} as const;
  const result = await solve({garment, print});
  const picture = {width: 64, height: 64, data: {}};
  const piece = {
    ...{name: 'a', garment: 0, outline: square, alignment, turns: 'half', up: [0, 1]},
    ...{shifts: [], pin: {angle: 0, translation: [1, 1]}},
  };
  const marker = {
    ...{print: {group: 'p1', w1: [4, 0], w2: [0, 4]}, pieces: [piece], widthCm: 140},
    ...{selvedgeCm: 1, gapCm: 0.2, repeatTolerance: 0, nap: 'none', wholeRepeats: false},
    ...{ignoresPrint: false, phasesCm: [0], startCm: 0, flaws: [square], widthsCm: [100]},
    ...{alsoFree: false, effort: 0, seed: 1},
  };
  calls = {
    ...{solve: [problem, {}], prepare: [problem, {}], symmetries: [garment, {}]},
    ...{garment: [garment, {}], convert: [garment, {}], drape: [JSON.stringify(result), {}, {}]},
    mirror: [garment, {kind: 'piece', piece: 'left'}, {}],
    marker: [marker, {}],
    photo: [{picture, f35: 28, lattice, w1Measured: {repeats: 1, cm: 2}}, {}],
    photoTile: [{picture, map: lattice, shape, gains: [1, 1, 1], symmetrise: 'p1'}, {}],
    photoObject: [{picture, map: lattice, shape, object: 'card', at: [9, 9]}, {}],
  };
  page = await openPage();
  await page.evaluate(
    `globalThis.oddOnes = {values: (${String(oddValues)})(), partsOf: ${String(partsOf)}, withPart: ${String(withPart)}, faultOf: ${String(faultOf)}};
    ${String(partsOf)}; ${String(withPart)}; undefined;`, // odd values take seconds on the way back
  );
  return () => page.close();
});

it.each(['Client', 'InPage'] as const)('%s rejects odd arguments', async (kind) => {
  const faults = await page.evaluate(
    async ([name, all, known, stride]) => {
      const solver = new globalThis[name]();
      const found: string[] = [];
      let turn = 0;
      for (const [call, args] of Object.entries(all)) {
        const [first] = args as {picture?: {data: unknown}}[];
        if (first?.picture) first.picture.data = new Uint8ClampedArray(4 * 64 * 64).fill(99);
        for (const path of oddOnes.partsOf(args)) {
          for (const [label, value] of Object.entries(oddOnes.values)) {
            if (turn++ % stride !== 0) continue;
            const asked = oddOnes.withPart(args, path, value) as unknown[];
            const work = Reflect.get(solver, call) as (...args: unknown[]) => unknown;
            const fault = await oddOnes.faultOf(() => work.apply(solver, asked), known);
            if (fault) found.push(`${call}, ${path.join('.')} is ${label}: ${fault}`);
          }
        }
      }
      return found;
    },
    [kind, calls, codes, cases(41, 3)] as const,
  );
  expect(faults).toEqual([]);
});
