/** `repeat` on the command line. */
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {afterAll, beforeAll, expect, it} from 'vitest';

import {seamwise} from '../../support/cli/command-line.js';

let folder = '';
const file = (name: string): string => join(folder, name);

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'seamwise-'));
});
afterAll(() => {
  rmSync(folder, {recursive: true});
});

it('writes PNG with its printed size, and SVG in millimetres', async () => {
  const words = ['repeat', '--print', 'public/prints/p31m.json', '--size', '0.5'];
  const png = await seamwise(...words, '--dpi', '150', '--out', file('r.png'));
  expect(png).toMatchObject({code: 0});
  expect(png.out).toContain('9.53 x 5.50 cm, 563 x 325 pixels, 150 dpi');
  const bytes = readFileSync(file('r.png'));
  expect([bytes.readUInt32BE(16), bytes.readUInt32BE(20)]).toEqual([563, 325]);
  const at = bytes.indexOf('pHYs');
  expect(325 / bytes.readUInt32BE(at + 8)).toBeCloseTo(0.055, 5);
  await seamwise(...words, '--out', file('r.svg'));
  expect(readFileSync(file('r.svg'), 'utf8')).toContain('width="95.26mm" height="55mm"');
});

it('explains that a slanted print has no rectangle, and gives its cell as SVG', async () => {
  const print = {group: 'p1', w1: [6, 0], w2: [1.234, 4.321], image: 'cell.svg'};
  writeFileSync(file('slanted.json'), JSON.stringify(print));
  writeFileSync(file('cell.svg'), '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>');
  const words = ['repeat', '--print', file('slanted.json')];
  const png = await seamwise(...words, '--out', file('s.png'));
  expect(png).toMatchObject({code: 2});
  expect(png.err).toContain('No upright rectangle of at most twelve repeats tiles this print');
  const svg = await seamwise(...words, '--out', file('s.svg'));
  expect(svg).toMatchObject({code: 0});
  expect(readFileSync(file('s.svg'), 'utf8')).toContain('patternTransform');
});
