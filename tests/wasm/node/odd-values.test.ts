/** Public functions of `seamwise/node` reject odd arguments alike: with a code and one sentence. */
import * as node from 'seamwise/node';
import {failureCodes, pageFailureCodes, SolverError} from 'seamwise';
import {beforeAll, describe, expect, it} from 'vitest';

import {checks, twoStrips} from '../../support/garments/samples.js';
import {cases} from '../../support/level.js';
import {faultOf as faultIn, oddValues} from '../../support/odd-values.js';

const odd = Object.entries(oddValues());

/** A commit tries every third value, from another one on at each turn. */
const stride = cases(3, 1);
let turn = 0;
const oddOnes = (): typeof odd => {
  turn++;
  return odd.filter((_, k) => (k + turn) % stride === 0);
};
const codes = [...Object.keys(failureCodes), ...pageFailureCodes];

/** Returns what is wrong with the outcome of a call; empty for a value or a `SolverError`. */
const faultOf = (call: () => unknown): Promise<string> =>
  faultIn(async () => {
    try {
      await call();
    } catch (error) {
      if (error instanceof SolverError) throw error;
      throw new Error(`no SolverError, but ${String(error)}`, {cause: error});
    }
  }, codes);

const garment = twoStrips();
const print = {...checks};
const problem = {garment, print};
const pixels = {width: 8, height: 8, data: new Uint8Array(256)};

/** Valid arguments of each function, from which one at a time is replaced. */
type Arguments = readonly unknown[];
let calls: Readonly<Record<string, Arguments>> = {};
/** Functions of what other functions return, by their names in `calls`. */
let returned: Readonly<Record<string, (...args: never[]) => unknown>> = {};

beforeAll(async () => {
  const result = await node.solve(problem);
  const document = await node.readGarment(garment);
  const design = {garment: {url: 'a', sha256: ''}, print: {url: 'b', sha256: ''}};
  const solved = {...design, solver: '0.1.0', result: '', options: {}};
  const text = JSON.stringify(garment);
  const sold = {design: solved, garment: text, print, result, reproduced: true, differenceCm: 0};
  const plan = await node.marker([result], {widthCm: 140, effort: 0});
  const bytes = new TextEncoder().encode(text);
  const json = JSON.stringify(print);
  const sheet = await node.cut(result, {print});
  const files = await node.layPlanFiles(plan, {print});
  const {png} = await node.printRepeat(print);
  returned = {
    ...{'cut().pdf': sheet.pdf, 'cut().dxf': sheet.dxf, 'printRepeat().png': png},
    ...{'layPlanFiles().pdf': files.pdf, 'layPlanFiles().dxf': files.dxf},
  };
  calls = {
    ...{'cut().pdf': [[]], 'cut().dxf': [{}], 'printRepeat().png': [() => pixels, 72]},
    ...{'layPlanFiles().pdf': [10], 'layPlanFiles().dxf': [{}]},
    commonPrintSize: [[problem], 1, {}],
    ...{solve: [problem, {}], prepare: [problem, {}], remedies: [problem, result, {}]},
    ...{
      withReach: [problem, result, {}],
      order: ['{}', {}],
      orderRecord: [sold, {}],
      drape: [result, {}, {}],
    },
    ...{cut: [result, {print}], marker: [[result], {widthCm: 140, effort: 0}, {}]},
    ...{layPlanFiles: [plan, {print}], symmetries: [garment, 'name'], prove: [problem, {}]},
    ...{mirror: [garment, {kind: 'piece', piece: 'left'}, 'name'], readGarment: [garment, 'name']},
    ...{importGarment: [bytes, {}], seamSuggestions: [garment, {}, 'name']},
    ...{convert: [garment, {}], garmentDxf: [garment, {}], printRepeat: [print]},
    ...{printFromPixels: [pixels, {}, {}], memory: [], garmentFile: [document]},
    ...{printOfResult: [result.print, print], chosenProblem: [problem, result]},
    ...{problemOfStored: [design, {garment: '{}', print: json}], resultText: [result]},
    ...{sha256Of: ['text'], layPlanText: [plan], drapeFile: [result, {}], drapeText: [{}]},
    ...{cellPicture: [bytes], glb: [result, {}, print, {}], readStoredDesign: ['{}', 'name']},
    ...{writeStoredDesign: [{}], designOf: [{...design, alignments: {}}, result]},
    ...{changesOf: [{}, print], printOfStored: [design, json], printTextOf: [design, json]},
  };
});

const named = (name: string) =>
  (returned[name] ?? Reflect.get(node, name)) as (...args: Arguments) => unknown;

/** Fields of an argument that is an object, from the message about an unknown one. */
async function fieldsOf(name: string, args: Arguments, k: number): Promise<readonly string[]> {
  const asked = args.with(k, {...(args[k] as object), unknownField: 1});
  const message = await Promise.resolve()
    .then(() => named(name)(...asked))
    .then(String, (error: unknown) => (error as Error).message);
  return /has no field 'unknownField'; it has (.*)\.$/.exec(message)?.[1]?.split(', ') ?? [];
}

describe('an odd argument', () => {
  it('is tried for every function', () => {
    const own = Object.keys(calls).filter((name) => !(name in returned));
    expect(own.sort()).toEqual(
      Object.keys(node)
        .filter((name) => typeof named(name) === 'function' && !name.endsWith('Error'))
        .sort(),
    );
  });

  it('is rejected with a code and a sentence, or harmless', async () => {
    const faults: string[] = [];
    for (const [name, args] of Object.entries(calls)) {
      for (const k of args.keys()) {
        for (const [label, value] of oddOnes()) {
          const fault = await faultOf(() => named(name)(...args.with(k, value)));
          if (fault) faults.push(`${name}, argument ${k + 1} is ${label}: ${fault}`);
        }
      }
    }
    expect(faults).toEqual([]);
  });

  it('is rejected in documents', async () => {
    const faults: string[] = [];
    for (const name of ['garmentFile', 'layPlanText', 'writeStoredDesign', 'resultText']) {
      const [own] = calls[name] as readonly [object];
      for (const field of Object.keys(own)) {
        for (const [label, value] of oddOnes()) {
          const fault = await faultOf(() => named(name)({...own, [field]: value}));
          if (fault) faults.push(`${name}, ${field} is ${label}: ${fault}`);
        }
      }
    }
    expect(faults).toEqual([]);
  });

  it('is rejected in each field of settings and hooks', async () => {
    const faults: string[] = [];
    let tried = 0;
    for (const [name, args] of Object.entries(calls)) {
      for (const [k, own] of args.entries()) {
        if (typeof own !== 'object' || own === null) continue;
        for (const field of await fieldsOf(name, args, k)) {
          for (const [label, value] of oddOnes()) {
            tried++;
            const asked = args.with(k, {...own, [field]: value});
            const fault = await faultOf(() => named(name)(...asked));
            if (fault) faults.push(`${name}, ${field} is ${label}: ${fault}`);
          }
        }
      }
    }
    expect(faults).toEqual([]);
    expect(tried).toBeGreaterThan(1500 / stride);
  });
});
