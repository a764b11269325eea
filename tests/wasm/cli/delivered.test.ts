/** Fabric as delivered, from `align` to all commands that take its result. */
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import type {LayPlan, SheetMap, SolveResult} from 'seamwise/node';
import {afterAll, beforeAll, describe, expect, it} from 'vitest';

import {boxOf} from '@/model/geometry/polyline.js';
import type {Point} from '@/model/geometry/vectors.js';
import {seamwise} from '../../support/cli/command-line.js';
import {twoStrips} from '../../support/garments/samples.js';

let folder = '';
const file = (name: string): string => join(folder, name);
const read = (name: string): unknown => JSON.parse(readFileSync(file(name), 'utf8'));
const print = {group: 'p4m', w1: [4, 0], w2: [0, 4]};
/** Strips on grain, so that the warp runs along them. */
const onGrain = {grain: {default: 'on'}};

const align = (out: string, ...flags: string[]) =>
  seamwise(
    ...['align', file('strips.json'), '--print', file('print.json')],
    ...['--no-remedies', '--symmetry', 'none', '--options', file('options.json')],
    ...['--out', file(out), ...flags],
  );

const heightOf = (rings: readonly (readonly Point[])[]): number => {
  const {low, high} = boxOf(rings.flat());
  return high[1] - low[1];
};

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), 'seamwise-'));
  writeFileSync(file('strips.json'), JSON.stringify(twoStrips(20)));
  writeFileSync(file('print.json'), JSON.stringify(print));
  writeFileSync(file('options.json'), JSON.stringify(onGrain));
  const {code} = await align('r.json', '--shrinkage', '5,2', '--measured', '4.2x4');
  expect(code).toBe(0);
});

afterAll(() => {
  rmSync(folder, {recursive: true});
});

it('solves on the print after the wash, and keeps the fabric in the result', () => {
  const {print: solved} = read('r.json') as SolveResult;
  expect(solved).toMatchObject({
    group: 'pmm',
    w1: [expect.closeTo(4.2 * 0.98, 8), 0],
    w2: [0, expect.closeTo(4 * 0.95, 8)],
    delivered: {shrinkage: {warp: 5, weft: 2}, measured: {across: 4.2, up: 4}},
  });
  expect(read('r.json')).toMatchObject({
    design: {print: {delivered: {stated: {group: 'p4m', size: {width: 4}}}}},
  });
});

it('cuts pieces that measure right after the wash, in the print as it measures before', async () => {
  const [result, cloth] = [file('r.json'), file('print.json')];
  const given = [result, '--print', cloth, '--map', file('map.json'), '--svg', file('cut.svg')];
  expect((await seamwise('cut', ...given)).code).toBe(0);
  const {pieces} = read('map.json') as SheetMap;
  const solved = (read('r.json') as SolveResult).pieces;
  for (const [k, {sew, place}] of pieces.entries()) {
    expect(Math.abs(Math.sin(place.angle))).toBeLessThan(1e-9);
    const own = solved[k];
    const outline =
      own?.outline.flatMap((v): Point[] => (own.shape[v] ? [own.shape[v]] : [])) ?? [];
    expect(heightOf([sew as Point[]])).toBeCloseTo(heightOf([outline]) / 0.95, 3);
  }
  const words = ['marker', result, '--print', cloth, '--width', '40', '--out', file('plan.json')];
  expect((await seamwise(...words, '--effort', '0.1', '--phase', '0')).code).toBe(0);
  const plan = read('plan.json') as LayPlan;
  expect(plan.print.w1[0]).toBeCloseTo(4.2, 8);
  expect(plan.print.w2[1]).toBeCloseTo(4, 8);
  const free = await align('plain.json');
  expect(free.code).toBe(0);
  const [cut] = plan.placements;
  // 20 cm, enlarged, with the allowances of 1 and 3 cm, enlarged alike
  expect(heightOf([cut?.cut ?? []])).toBeGreaterThan(20 / 0.95 + 2);
});

describe('refuses in one sentence', () => {
  it.each<[string, string[], string]>([
    [
      'a repeat that is none',
      ['--measured', '9x4'],
      'The repeat measures 9 cm across, but 4 cm are',
    ],
    ['values in words', ['--shrinkage', 'much'], "--shrinkage is 'much', but must be two numbers"],
    ['shrinkage of all', ['--shrinkage', '100,0'], "--shrinkage is '100,0', but must be two"],
    [
      'other sizes of a print that is measured',
      ['--measured', '4.1x4', '--print-size', '0.95'],
      'The repeat was measured on fabric that is printed already',
    ],
  ])('%s', async (_, flags, sentence) => {
    const {code, err} = await align('none.json', ...flags);
    expect([code, err]).toEqual([2, expect.stringContaining(sentence)]);
  });

  it('a print file with other fabric than the result, or than the flags', async () => {
    const shrinking = {...print, fabric: {shrinkage: {warp: 3, weft: 0}}};
    writeFileSync(file('shrinking.json'), JSON.stringify(shrinking));
    const given = ['--print', file('shrinking.json')];
    const cut = await seamwise('cut', file('r.json'), ...given, '--svg', file('none.svg'));
    expect(cut.err).toContain('shrinkage of 3 % along the warp and 0 % along the weft, but the');
    const words = [file('strips.json'), ...given, '--shrinkage', '4,0'];
    const aligned = await seamwise('align', ...words, '--no-remedies');
    expect(aligned.err).toContain('--shrinkage contradicts the shrinkage of the fabric in');
  });
});
