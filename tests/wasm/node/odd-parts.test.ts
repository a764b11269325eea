/** Odd parts of documents and settings, at any depth: functions of `seamwise/node` reject them. */
import * as node from 'seamwise/node';
import {failureCodes, pageFailureCodes} from 'seamwise';
import {beforeAll, expect, it} from 'vitest';

import {checks, twoStrips} from '../../support/garments/samples.js';
import {cases} from '../../support/level.js';
import {faultOf, oddValues, partsOf, withPart} from '../../support/odd-values.js';

const codes = [...Object.keys(failureCodes), ...pageFailureCodes];
const odd = Object.entries(oddValues());

const garment = twoStrips();
const print = {
  ...{...checks, image: 'checks.svg', title: 'Checks', scale: 1, turnDeg: 0, oneWay: false},
  fabric: {usableWidthCm: 140, shrinkage: {warp: 0, weft: 0}},
};
const axis = [
  [2.5, 0],
  [2.5, 10],
];
const symmetry = {symmetries: [{kind: 'piece', piece: 'left', axis}]};
const options = {
  ...{maxChangeCm: 1, edgeLengthCm: 1, weights: {0: 0.5}, unmatched: [], plain: [], matches: []},
  grain: {default: 'free', toleranceDeg: 0, pieces: {left: 'on'}},
};
const problem = {garment, print, symmetry, options, method: 'best', seed: 1};
const data = new Uint8Array(4 * 64 * 64).map((_, k) => ((k >> 4) % 2 ? 255 : 40));
const pixels = {width: 64, height: 64, data};
const lattice = {homography: [1, 0, 0, 0, 1, 0, 0, 0, 1], lens: 0};
const facts = {
  ...{f35: 28, w1Measured: {repeats: 1, cm: 2}, lattice, flatten: 0.5},
  between: {from: [0, 0], to: [9, 0], cm: 4},
};

type Call = (...args: never[]) => unknown;
let quick: readonly (readonly [name: string, call: Call, args: readonly unknown[]])[];
let slow: typeof quick;

beforeAll(async () => {
  const result = await node.solve({garment, print: checks});
  const document = await node.readGarment(garment);
  const plan = await node.marker([result], {widthCm: 140, effort: 0});
  const design = {garment: {url: 'a', sha256: ''}, print: {url: 'b', sha256: ''}};
  const drawn = async (...args: Parameters<typeof node.layPlanFiles>) => {
    const files = await node.layPlanFiles(...args);
    return [await files.pdf(10), files.dxf({})];
  };
  quick = [
    ...([
      ['readGarment', node.readGarment, [garment]],
      ['mirror', node.mirror, [garment, symmetry.symmetries[0]]],
      ['convert', node.convert, [garment]],
      ['seamSuggestions', node.seamSuggestions, [garment]],
      ['garmentFile', node.garmentFile, [document]],
      ['printOfResult', node.printOfResult, [result.print, print]],
      ['chosenProblem', node.chosenProblem, [problem, result]],
      ['printRepeat', node.printRepeat, [print]],
      ['layPlanText', node.layPlanText, [plan]],
      ['writeStoredDesign', node.writeStoredDesign, [design]],
    ] as const),
  ];
  slow = [
    ['prepare', node.prepare, [problem]],
    ['solve', node.solve, [problem]],
    ['cut', node.cut, [result, {print, garment: document}]],
    ['marker', node.marker, [[result], {widthCm: 140, effort: 0}]],
    ['layPlanFiles', drawn, [plan, {print}]],
    ['remedies', node.remedies, [problem, result]],
    ['designOf', node.designOf, [{...design, alignments: {}}, result]],
    ['printFromPixels', node.printFromPixels, [pixels, facts]],
    ['drape', node.drape, [result, {fabric: 'poplin', body: {heightCm: 170}}]],
  ];
});

/** Tries each part with every `stride`-th odd value, another one for each part. */
async function faultsIn(calls: typeof quick, stride: number): Promise<readonly string[]> {
  const faults: string[] = [];
  let turn = 0;
  for (const [name, call, args] of calls) {
    for (const path of partsOf(args)) {
      for (const [label, value] of odd) {
        if (turn++ % stride !== 0) continue;
        const asked = withPart(args, path, value) as never[];
        const fault = await faultOf(() => call(...asked), codes);
        if (fault) faults.push(`${name}, ${path.join('.')} is ${label}: ${fault}`);
      }
    }
  }
  expect(turn / stride).toBeGreaterThan(100);
  return faults;
}

it('are rejected with a code and a sentence, or are harmless', async () => {
  expect(await faultsIn(quick, cases(5, 1))).toEqual([]);
});

it('are rejected by functions that compute', {timeout: 600_000}, async () => {
  expect(await faultsIn(slow, cases(59, 7))).toEqual([]);
});
