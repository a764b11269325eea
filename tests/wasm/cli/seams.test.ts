import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {readGarment, seamSuggestions, type SeamSuggestions} from 'seamwise/node';
import {afterAll, beforeAll, describe, expect, it} from 'vitest';

import {seamwise} from '../../support/cli/command-line.js';
import {sample, twoStrips} from '../../support/garments/samples.js';

let folder = '';
const file = (name: string) => join(folder, name);
const tee = 'public/garments/tee-m.json';

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'seamwise-seams-'));
  writeFileSync(file('strips.json'), JSON.stringify(twoStrips()));
  writeFileSync(file('broken.json'), '{"pattern":');
});

afterAll(() => {
  rmSync(folder, {recursive: true});
});

const seams = (...words: string[]) => seamwise('seams', ...words);

describe('seams', () => {
  it('prints as JSON what the function finds, the same each time', async () => {
    const words = [tee, '--strip', '--confirm', '4', '--seed', '3', '--suggest', '--json'];
    const [one, again] = await Promise.all([seams(...words), seams(...words)]);
    expect({code: one.code, err: one.err}).toEqual({code: 0, err: ''});
    expect(again.out).toBe(one.out);
    const settings = {strip: true, confirm: 4, seed: 3};
    expect(JSON.parse(one.out)).toEqual(await seamSuggestions(sample('tee'), settings));
  });

  it('lists all edges but those of seams that are confirmed, with ten partners at most', async () => {
    const {pieces, seams: sewn} = await readGarment(sample('tee'));
    const edges = pieces.reduce((sum, {outline}) => sum + outline.length, 0);
    for (const confirm of [0, 3]) {
      const {out} = await seams(
        tee,
        '--strip',
        `--confirm=${String(confirm)}`,
        '--suggest',
        '--json',
      );
      const found = JSON.parse(out) as SeamSuggestions;
      expect(found.edges).toHaveLength(edges - 2 * confirm);
      for (const {partners} of found.edges) {
        expect(partners.length).toBeGreaterThan(0);
        expect(partners.length).toBeLessThanOrEqual(10);
        const ps = partners.map(({p}) => p);
        expect(ps).toEqual(ps.toSorted((a, b) => b - a));
      }
    }
    const {out} = await seams(tee, '--suggest', '--json');
    expect((JSON.parse(out) as SeamSuggestions).edges).toHaveLength(edges - 2 * sewn.length);
  });

  it('prints lines for people', async () => {
    const {code, out} = await seams(file('strips.json'), '--strip', '--suggest');
    expect(code).toBe(0);
    const lines = out.trimEnd().split('\n');
    expect(lines.some((line) => /^left 1: left 3 \(\d+ %\)/.test(line))).toBe(true);
    expect(lines.filter((line) => !line.startsWith('sure'))).toHaveLength(8);
  });

  it.each([
    [[tee], '--suggest is missing'],
    [['--suggest'], 'the garment file is missing'],
    [
      [tee, '--suggest', '--confirm', '3'],
      '--confirm says which seams --strip leaves; add --strip',
    ],
    [[tee, '--suggest', '--seed', '3'], '--seed says which seams --strip leaves; add --strip'],
    [
      [tee, '--suggest', '--strip', '--confirm', '-3'],
      "--confirm is '-3', but must be a whole number",
    ],
    [[tee, '--suggest', '--strip', '--confirm', '1.5'], "--confirm is '1.5', but must be"],
    [[tee, '--suggest', '--strip', '--confirm', '11'], "--confirm is '11', but there are 10 seams"],
    [[tee, '--suggest', '--strips'], "unknown flag '--strips'"],
  ])('exits with 2 for %j', async (words, sentence) => {
    const {code, out, err} = await seams(...words);
    expect({code, out}).toEqual({code: 2, out: ''});
    expect(err).toContain(sentence);
    expect(err.trimEnd().split('\n')).toHaveLength(1);
  });

  it('exits with 2 for files that are no garments, naming them', async () => {
    for (const name of ['broken.json', 'missing.json']) {
      const {code, err} = await seams(file(name), '--suggest');
      expect(code).toBe(2);
      expect(err).toContain(name);
      expect(err.trimEnd().split('\n')).toHaveLength(1);
    }
  });
});
