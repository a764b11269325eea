/** Effects of the flags of `align` on the answer, and the output of `draw`. */
import {copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

import type {Metrics, Remedy, SolveResult} from 'seamwise/node';
import {afterAll, beforeAll, describe, expect, it} from 'vitest';

import {seamwise} from '../../support/cli/command-line.js';
import {sampleOf} from '../../support/level.js';

const shipped = (path: string): string =>
  fileURLToPath(new URL(`../../../public/${path}`, import.meta.url));
let folder = '';
const file = (name: string): string => join(folder, name);
const print = shipped('prints/pmm.json');

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'seamwise-'));
  writeFileSync(file('on.json'), '{"grain": {"default": "on"}}');
});

afterAll(() => {
  rmSync(folder, {recursive: true});
});

const aligned = async (garment: string, ...flags: string[]) => {
  const words = ['align', shipped(`garments/${garment}.json`), '--print', print, '--json'];
  const {code, out, err} = await seamwise(...words, ...flags);
  expect({code, err}).toEqual({code: 0, err: ''});
  return JSON.parse(out) as Metrics & {readonly remedies?: readonly Remedy[]};
};
const written = (name: string): SolveResult & {readonly remedies?: unknown} =>
  JSON.parse(readFileSync(file(name), 'utf8')) as SolveResult;

describe('align', () => {
  it('keeps every outline with --max-change 0, and still places', async () => {
    const free = await aligned('tee-m', '--no-remedies');
    const {maxMovedCm, fit, localCm} = await aligned(
      ...(['tee-m', '--max-change', '0', '--no-remedies', '--out', file('placed.json')] as const),
    );
    expect(free.maxMovedCm).toBeGreaterThan(0.1);
    expect(maxMovedCm).toBeLessThan(1e-6);
    expect(fit).toBeGreaterThan(free.fit);
    expect(localCm?.final).toBeLessThan(localCm?.drafted ?? NaN);
    for (const {rest, shape} of written('placed.json').pieces)
      rest.forEach(([x, y], v) => {
        const [atX = NaN, atY = NaN] = shape[v] ?? [];
        expect(Math.hypot(atX - x, atY - y)).toBeLessThan(1e-6);
      });
  });

  it.each(sampleOf(1, ['tee-m', 'princess-dress-m']))(
    'is never worse for --effort 3, with %s',
    async (garment) => {
      const once = await aligned(garment, '--no-remedies');
      const longer = await aligned(garment, '--no-remedies', '--effort', '3');
      expect(longer.answerCost).toBeLessThanOrEqual(once.answerCost ?? NaN);
    },
  );

  it('says how far the print misses, and which grain stands behind that where the file states none', async () => {
    const figures = async (name: string, ...flags: string[]): Promise<string> => {
      const words = ['align', name, '--print', print, '--no-remedies', ...flags];
      const {code, out} = await seamwise(...words);
      expect(code).toBe(0);
      return out;
    };
    const tee = shipped('garments/tee-m.json');
    expect(await figures(tee)).toMatch(
      /; \d+ of \d+ visible seams match; on average the print misses by [\d.]+ mm at the seams, at the worst by [\d.]+ mm; before [\d.]+ mm; /,
    );
    const {pattern, ...rest} = JSON.parse(readFileSync(tee, 'utf8')) as {
      pattern: {panels: Record<string, {grain?: unknown}>};
    };
    for (const panel of Object.values(pattern.panels)) delete panel.grain;
    writeFileSync(file('grainless.json'), JSON.stringify({pattern, ...rest}));
    const assumed = 'mm with the grain upwards as drawn, for the file states none';
    expect(await figures(file('grainless.json'))).toContain(`${assumed};`);
    const [front = '', ...others] = Object.keys(pattern.panels);
    const said = Object.fromEntries(others.map((name) => [name, {angleDeg: 90}]));
    writeFileSync(file('said.json'), JSON.stringify({grain: {pieces: said}}));
    expect(front).not.toBe('');
    expect(await figures(file('grainless.json'), '--options', file('said.json'))).toContain(
      `${assumed} for 1 piece;`,
    );
  });

  it('looks for remedies, unless --no-remedies is given', async () => {
    const flags = ['--options', file('on.json'), '--out', file('skirt.json')] as const;
    const {remedies} = await aligned('gathered-skirt-m', ...flags);
    expect(remedies).toMatchObject([{kind: 'ungather'}]);
    expect(written('skirt.json').remedies).toEqual(remedies);
    const without = await aligned('gathered-skirt-m', ...flags, '--no-remedies');
    expect(without.remedies).toBeUndefined();
    expect(written('skirt.json').remedies).toBeUndefined();
    expect(without.fit).toBe((await aligned('gathered-skirt-m', ...flags)).fit);
  });
});

describe('draw', () => {
  beforeAll(async () => {
    await aligned('tee-m', '--no-remedies', '--out', file('named.json'));
    copyFileSync(file('named.json'), file('answer_2.json'));
    // a result without its design has keys for names, and no title
    await aligned('tee-m', '--no-remedies', '--no-times', '--out', file('bare.json'));
    copyFileSync(file('bare.json'), file('bare_answer.json'));
  });

  const drawn = async (result: string, ...flags: string[]): Promise<string> => {
    const {code, out, err} = await seamwise('draw', file(result), '--print', print, ...flags);
    expect({code, err}).toEqual({code: 0, err: ''});
    return out;
  };

  it('calls the pieces by their names, chosen ones before those of the garment’s file', async () => {
    const svg = await drawn('named.json');
    expect(svg).toContain('>Sleeve left<');
    expect(svg).not.toContain('sleeve_left');
    const result = written('named.json') as unknown as {design: object};
    const design = {...result.design, names: {sleeve_left: 'Heart side', front: 3}};
    writeFileSync(file('chosen.json'), JSON.stringify({...result, design}));
    const chosen = await drawn('chosen.json');
    expect(chosen).toContain('>Heart side<');
    expect(chosen).toContain('>Front<');
    expect(await drawn('bare.json')).toContain('>Sleeve left<');
    writeFileSync(file('odd.json'), JSON.stringify({...result, design: {garment: {text: 'no'}}}));
    expect(await drawn('odd.json')).toContain('>Sleeve left<');
  });

  it('is titled by the garment, and by its own file where it knows none', async () => {
    expect(await drawn('answer_2.json')).toContain('<title>Tee</title>');
    expect(await drawn('answer_2.json', '--title', 'Mine')).toContain('<title>Mine</title>');
    expect(await drawn('bare_answer.json')).toContain('<title>Bare answer</title>');
  });

  it('draws the cloth only, without lines and names over it', async () => {
    const [full, bare] = [await drawn('named.json'), await drawn('named.json', '--cloth-only')];
    expect(full).toContain('symmetry axis');
    expect(bare).not.toMatch(/symmetry axis|>Front<|stroke-opacity/);
    expect(bare).toContain('aria-label="Front"'); // for screen readers
  });
});
