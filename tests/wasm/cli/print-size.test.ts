/** Prints in another size, from `align` to all commands that take its result. */
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import type {SolveResult} from 'seamwise/node';
import {afterAll, beforeAll, expect, it} from 'vitest';

import {seamwise} from '../../support/cli/command-line.js';
import {twoStrips} from '../../support/garments/samples.js';

let folder = '';
const file = (name: string): string => join(folder, name);
const print = {group: 'p1', w1: [4, 0], w2: [0, 4]};

const run = async (...words: string[]): Promise<string> => {
  const {code, out, err} = await seamwise(...words);
  expect({code, err}).toEqual({code: 0, err: ''});
  return out;
};
const align = (...flags: string[]): Promise<string> =>
  run(
    'align',
    file('strips.json'),
    '--print',
    file('print.json'),
    ...['--no-remedies', '--symmetry', 'none'],
    ...flags,
  );
const read = (name: string): unknown => JSON.parse(readFileSync(file(name), 'utf8'));

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'seamwise-'));
  writeFileSync(file('strips.json'), JSON.stringify(twoStrips()));
  writeFileSync(file('print.json'), JSON.stringify(print));
});

afterAll(() => {
  rmSync(folder, {recursive: true});
});

it('a result in another size goes with the print in its own', async () => {
  const line = await align('--print-size', '0.93', '--out', file('r.json'));
  expect(line).toContain('; print at 93 %; ');
  const {print: solved} = read('r.json') as SolveResult;
  expect(solved).toEqual({...print, w1: [3.72, 0], w2: [0, 3.72], scale: 0.93});
  expect(read('r.json')).toMatchObject({design: {print: {size: {width: 3.72}}, options: {}}});

  const [result, ...cloth] = [file('r.json'), '--print', file('print.json')];
  await run('cut', result, ...cloth, '--map', file('map.json'));
  expect(await run('draw', result, ...cloth)).toContain('3.7 × 3.7 cm');
  await run('marker', result, ...cloth, '--width', '30', '--out', file('plan.json'));
  expect(read('plan.json')).toMatchObject({print: {w1: [3.72, 0]}});

  writeFileSync(file('other.json'), JSON.stringify({...print, w1: [5, 0]}));
  const {code, err} = await seamwise('cut', result, '--print', file('other.json'));
  expect(code).toBe(2);
  expect(err).toContain('was solved for another group or repeat');
});

it('its design is ordered, byte for byte, with the chosen size and seed', async () => {
  const flags = ['--print-size', '0.9,1.1', '--effort', 'auto', '--design', file('design.json')];
  await align(...flags, '--no-times', '--out', file('sold.json'));
  const {print: size, options} = read('design.json') as Record<string, unknown>;
  const {print: solved, metrics} = read('sold.json') as SolveResult;
  expect(options).toEqual({});
  expect(size).toHaveProperty(solved.scale === undefined ? 'url' : 'size');
  await run('order', file('design.json'), '--out', file('made.json'));
  expect(readFileSync(file('made.json'))).toEqual(readFileSync(file('sold.json')));
  const again = ['--print-size', String(solved.scale ?? 1), '--seed', String(metrics.seed)];
  await align(...again, '--no-times', '--out', file('again.json'));
  expect(readFileSync(file('again.json'))).toEqual(readFileSync(file('sold.json')));
});

it('a turn is chosen and ordered like a size, and the result goes with the print as it is', async () => {
  const flags = ['--print-turn', '45', '--print-size', '0.93', '--design', file('turned.json')];
  const line = await align(...flags, '--no-times', '--out', file('t.json'));
  expect(line).toContain('; print at 93 %; print turned by 45 degrees; ');
  expect(read('t.json')).toMatchObject({print: {scale: 0.93, turnDeg: 45}});
  expect(read('turned.json')).toMatchObject({print: {size: {width: 3.72}, turnDeg: 45}});
  await run('order', file('turned.json'), '--out', file('made.json'));
  expect(readFileSync(file('made.json'))).toEqual(readFileSync(file('t.json')));
  await run('draw', file('t.json'), '--print', file('print.json'));

  const {code, err} = await seamwise(
    ...['align', file('strips.json'), '--print', file('print.json'), '--print-turn', '0,200'],
  );
  expect(code).toBe(2);
  expect(err).toContain("--print-turn is '0,200', but must be degrees from -180 to 180");
});

it.each(['3', '0.9..', '1.1..0.9', '0.9..1..1.1', 'large', '1,,1.1'])(
  '--print-size %s is rejected',
  async (size) => {
    const words = ['align', file('strips.json'), '--print', file('print.json')];
    const {code, err} = await seamwise(...words, '--print-size', size);
    expect(code).toBe(2);
    expect(err).toContain(`--print-size is '${size}', but must be a number from 0.5 to 2, a range`);
  },
);

it('several garments get one size, in which most of their seams match', async () => {
  writeFileSync(file('long.json'), JSON.stringify(twoStrips(31)));
  const given = [file('strips.json'), file('long.json'), '--print', file('print.json')];
  const flags = ['--no-remedies', '--symmetry', 'none', '--print-size', '0.95,1.05'];
  const {code, err} = await seamwise(
    'align',
    ...given,
    ...flags,
    '--out',
    file('{garment}.r.json'),
  );
  expect([code, err]).toEqual([0, expect.stringMatching(/^note: Visible seams of all garments/)]);
  const scaleOf = (name: string) => (read(name) as SolveResult).print.scale ?? 1;
  expect(scaleOf('strips.r.json')).toBe(scaleOf('long.r.json'));
  const one = await seamwise('align', ...given, ...flags, '--out', file('one.json'));
  expect([one.code, one.err]).toEqual([
    2,
    expect.stringContaining('--out names one file for 2 garments; write {garment} in its name'),
  ]);
});
