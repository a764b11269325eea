import {mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import type {LayPlan} from 'seamwise/node';
import {afterAll, beforeAll, describe, expect, it} from 'vitest';

import {Shop} from '../../support/cli/batch.js';
import {planComplaints} from '../../support/marker/check-plan.js';
import {seamwise} from '../../support/cli/command-line.js';
import {writeProject} from '@/model/documents/write-project.js';
import type {SolveResult} from '@/model/result/result.js';
import {bareFabric} from '@/workbench/samples.js';
import {checks, twoStrips} from '../../support/garments/samples.js';

let folder = '';
const file = (name: string) => join(folder, name);
const marker = (...words: string[]) =>
  seamwise('marker', file('short.result.json'), '--print', file('checks.json'), ...words);
const read = (name: string): unknown => JSON.parse(readFileSync(file(name), 'utf8'));

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), 'seamwise-'));
  writeFileSync(file('checks.json'), JSON.stringify(checks));
  writeFileSync(file('waves.json'), JSON.stringify({...checks, group: 'p1'}));
  for (const [name, height] of [
    ['short', 20],
    ['long', 31],
  ] as const) {
    writeFileSync(file(`${name}.json`), JSON.stringify(twoStrips(height)));
    const words = ['--print', file('checks.json'), '--no-remedies'];
    const out = file(`${name}.result.json`);
    expect((await seamwise('align', file(`${name}.json`), ...words, '--out', out)).code).toBe(0);
  }
});

afterAll(() => {
  rmSync(folder, {recursive: true});
});

it('lays results as a plan, the same bytes each time, and says one line', async () => {
  const words = [file('long.result.json'), '--width', '36', '--copies', '2', '--allowance', '1'];
  words.push('--effort', '0.2');
  const {code, out, err} = await marker(...words, '--out', file('plan.json'));
  expect(code).toBe(0);
  expect(err).toMatch(/^(note: .*\n)*$/);
  expect(out).toMatch(
    /^\S+short\S+, \S+long\S+: 8 pieces on [\d.]+ cm of fabric 36 cm wide; [\d.]+ % of it used; (proven the shortest|[\d.]+ cm at the least); [\d.]+ cm without regard to the print\n$/,
  );
  const plan = read('plan.json') as LayPlan;
  const results = ['short', 'long'].map((name) => read(`${name}.result.json`) as SolveResult);
  expect(planComplaints(plan, results, {turns: () => 'half', copies: 2})).toEqual([]);
  expect(plan).toMatchObject({format: 'seamwise-layplan/1', widthCm: 36, selvedgeCm: 1});
  expect(plan.phases).toHaveLength(8);
  expect(plan.widths.map(({widthCm}) => widthCm)).toEqual([90, 110, 115, 140, 150, 160]);

  const again = await marker(...words, '--out', file('again.json'), '--json');
  expect(readFileSync(file('again.json'), 'utf8')).toBe(readFileSync(file('plan.json'), 'utf8'));
  const {lengthCm, boundCm} = plan;
  expect(JSON.parse(again.out)).toMatchObject({pieces: 8, lengthCm, boundCm, unplaced: []});
});

it('lays each result in its own number, with its share of the length', async () => {
  const words = [file('long.result.json'), '--width', '36', '--effort', '0.1', '--phase', '0'];
  const {out, err} = await marker(...words, '--copies', '2,1', '--out', file('counts.json'));
  expect(out).toContain(': 6 pieces on ');
  expect(err).toMatch(/short\.result\.json: 2 garments, 4 pieces, [\d.]+ cm of the length\./);
  const {placements, garments = [], lengthCm} = read('counts.json') as LayPlan;
  expect(placements.map(({result, copy}) => `${result}.${copy}`).sort()).toEqual([
    ...['0.0', '0.0', '0.1', '0.1', '1.0', '1.0'],
  ]);
  expect(garments.map(({copies, pieces}) => [copies, pieces])).toEqual([
    [2, 4],
    [1, 2],
  ]);
  const shares = garments.reduce((sum, one) => sum + one.lengthCm, 0);
  expect(shares).toBeCloseTo(lengthCm, 6);
  const wrong = await marker(...words, '--copies', '2,1,1');
  expect(wrong.code).toBe(2);
  expect(wrong.err).toContain('--copies has 3 numbers for 2 results; give one for all');
});

it('lays the garments of a project, each in its number of copies', async () => {
  const garment = (name: string) => ({name, text: readFileSync(file(name), 'utf8')});
  const decided = {symmetry: 'none', method: 'best', options: {}, seed: 1} as const;
  const project = writeProject({
    ...decided,
    garment: garment('short.json'),
    print: {...bareFabric, group: checks.group, size: {width: 4, height: 4, angleDeg: 90}},
    added: [{...decided, garment: garment('long.json'), copies: 2}],
  });
  writeFileSync(file('family.json'), project);
  const words = [
    '--print',
    file('checks.json'),
    '--width',
    '36',
    '--effort',
    '0.1',
    '--phase',
    '0',
  ];
  const {err, code} = await seamwise('marker', file('family.json'), ...words);
  expect(code).toBe(0);
  expect(err).toMatch(/family\.json, short\.json: 1 garment, 2 pieces, /);
  expect(err).toMatch(/family\.json, long\.json: 2 garments, 4 pieces, /);
});

it('refuses one print in two sizes, naming garments and sizes', async () => {
  const [cloth, out] = [file('checks.json'), file('small.result.json')];
  const asked = ['--print', cloth, '--no-remedies', '--print-size', '0.95', '--out', out];
  expect((await seamwise('align', file('long.json'), ...asked)).code).toBe(0);
  const {code, err} = await marker(out, '--width', '36');
  expect(code).toBe(2);
  expect(err).toMatch(
    /One fabric has one size of the print, .*short\.result\.json on 4 x 4 cm, .*small\.result\.json on 3\.8 x 3\.8 cm; align all/,
  );
});

it('takes what is known of the cloth', async () => {
  writeFileSync(file('flaws.json'), '[[[10, 0], [20, 0], [20, 15]]]');
  const words = [
    '--width',
    '40',
    '--selvedge',
    '0',
    '--gap',
    '0',
    '--phase',
    '1.5',
    '--start',
    '2',
  ];
  const told = ['--flaws', file('flaws.json'), '--nap', 'one-way', '--seed', '5', '--effort', '0'];
  const {code} = await marker(...words, ...told, '--out', file('told.json'));
  expect(code).toBe(0);
  const plan = read('told.json') as LayPlan;
  expect(plan).toMatchObject({selvedgeCm: 0, gapCm: 0, printOrigin: [1.5, expect.closeTo(2, 9)]});
  expect(plan.phases).toEqual([{phaseCm: 1.5, lengthCm: plan.lengthCm}]);

  const plies = await marker(
    '--width',
    '40',
    '--plies',
    '2',
    '--phase=0',
    '--shift=component',
    '--json',
  );
  const {lengthCm} = JSON.parse(plies.out) as LayPlan;
  expect(lengthCm % 4).toBeCloseTo(0, 9);
  const free = await marker('--width', '40', '--free', '--json', '--hem', '2', '--phase', 'any');
  expect(JSON.parse(free.out)).toMatchObject({printOrigin: null, phases: []});
});

describe('says in one sentence', () => {
  it.each<[string, string[], string]>([
    ['that the width is missing', [], '--width CM, how wide the fabric is, is missing.'],
    ['that there is no fabric', ['--width', '0'], 'The fabric is 0 cm wide'],
    [
      'that a width is a number',
      ['--width', 'NaN'],
      "--width is 'NaN', but must be a length from 0 to 1000 cm.",
    ],
    ['that a width is none', ['--width', '2000'], 'a length from 0 to 1000 cm'],
    ['what selvedges leave', ['--width=3', '--selvedge=2'], 'Between selvedges of 2 cm nothing'],
    [
      'how far pieces keep apart',
      ['--width=90', '--gap=21'],
      "--gap is '21', but must be a length from 0 to 20 cm.",
    ],
    [
      'where a print starts',
      ['--width=90', '--phase=91'],
      'beyond the fabric, which is 90 cm wide',
    ],
    ['what a phase is', ['--width=90', '--phase=left'], "--phase is 'left'"],
    [
      'how many plies there are',
      ['--width=90', '--plies=0'],
      "--plies is '0', but must be a whole number from 1 to 1000.",
    ],
    ['how many copies there are', ['--width=90', '--copies=300'], "--copies is '300'"],
    [
      'that it is too much',
      ['--width=90', '--copies=100', 'LONG', 'LONG'],
      'There are 600 pieces, but at most 500',
    ],
    ['which naps there are', ['--width=90', '--nap=up'], 'must be one of none, garment, one-way.'],
    ['what may shift', ['--width=90', '--shift=all'], 'must be one of kept, component.'],
    ['which efforts there are', ['--width=90', '--effort=-1'], 'a number from 0 to 1000.'],
    [
      'that one garment is not two',
      ['--width=90', '--garment=x', 'LONG'],
      'there are several results',
    ],
    ['which file is not there', ['--width=90', '--flaws=none.json'], 'none.json cannot be read'],
    [
      'that what is read is not written',
      ['--width=90', '--out=RESULT'],
      'is read and would be overwritten',
    ],
    ['which piece is wider than the fabric', ['--width=8'], 'left'],
  ])('%s', async (_, words, sentence) => {
    const names: Readonly<Record<string, string[]>> = {
      LONG: [file('long.result.json')],
      '--out=RESULT': [`--out=${file('short.result.json')}`],
    };
    const {code, out, err} = await marker(...words.flatMap((word) => names[word] ?? [word]));
    expect({code, out}).toEqual({code: 2, out: ''});
    expect(err).toContain(sentence);
    expect(err.trimEnd().split('\n')).toHaveLength(1);
  });

  it('what is wrong with results and flaws', async () => {
    const words = ['--width', '90'];
    const waves = await seamwise(
      'marker',
      file('short.result.json'),
      '--print',
      file('waves.json'),
      ...words,
    );
    expect(waves).toMatchObject({
      code: 2,
      err: expect.stringContaining('another group or repeat') as string,
    });
    for (const [text, sentence] of [
      ['[[[0, 0], [1, 1]]]', 'Flaw 1 is no polygon'],
      ['[[[0, "x"]]]', "flaws.json is no list of flaws ('flaws[0][0][1]' must be a number"],
      ['[', 'is not complete JSON'],
    ] as const) {
      writeFileSync(file('flaws.json'), text);
      const {code, err} = await marker(...words, '--flaws', file('flaws.json'));
      expect(code).toBe(2);
      expect(err).toContain(sentence);
    }
    const result = read('short.result.json') as SolveResult;
    writeFileSync(file('odd.json'), JSON.stringify({...result, design: {options: {grain: 7}}}));
    const odd = await seamwise(
      'marker',
      file('odd.json'),
      '--print',
      file('checks.json'),
      ...words,
    );
    expect(odd.code).toBe(2);
    expect(odd.err).toContain(
      "odd.json is not a whole result file (seamwise-result/1): 'design.options.grain'",
    );
  });
});

it('has results tell of other placings where that is asked for', async () => {
  const words = ['align', file('long.json'), '--print', file('checks.json'), '--no-times'];
  expect((await seamwise(...words, '--out', file('usual.json'))).code).toBe(0);
  expect((await seamwise(...words, '--others', '--out', file('others.json'))).code).toBe(0);
  const {otherAlignments, ...usual} = read('others.json') as SolveResult;
  expect(usual).toEqual(read('usual.json'));
  for (const {pieces} of otherAlignments ?? []) expect(pieces).toHaveLength(2);
  expect(Array.isArray(otherAlignments)).toBe(true);
});

it('lays the jobs of a batch that ask for it, beside their results', async () => {
  const shop = new Shop();
  try {
    const job = {garment: 'strips-8.json', print: 'checks.json'};
    shop.writeJobs('jobs.ndjson', [
      {...job, marker: {width: 60, phase: 'any', free: false, nap: 'garment', copies: 2}},
      job,
      {...job, marker: {width: 6}},
      {...job, marker: {width: 60, phase: 'left'}},
      {...job, marker: {}},
    ]);
    const {code} = await shop.batch('jobs.ndjson', 'out');
    expect(code).toBe(1);
    const done = shop.done('out');
    const [laid, plain] = done.filter(({status}) => status === 'done');
    expect(laid?.sha256).toBe(plain?.sha256);
    expect(laid?.key).not.toBe(plain?.key);
    const messages = done.flatMap(({failure}) => failure?.message ?? []).join();
    expect(messages).toContain('left is 7.0 cm wide, more than the 4.0 cm');
    expect(messages).toContain("'marker.phase' must be 'any' or a length in cm");
    expect(messages).toContain("'marker.width' must be a number from 0 to 1000");
    const plans = readdirSync(shop.at('out', 'results')).filter((name) =>
      name.endsWith('.layplan.json'),
    );
    expect(plans).toHaveLength(1);
    expect([laid, plain].map((one) => `${one?.key ?? ''}.layplan.json`)).toContain(plans[0]);
    const plan = JSON.parse(shop.read('out', 'results', plans[0] ?? '')) as LayPlan;
    expect(plan.placements).toHaveLength(4);
  } finally {
    shop.remove();
  }
});
