/**
 * A print of unknown size is aligned, but neither cut, laid out nor ordered; the message gives the
 * remedy.
 */
import {mkdtempSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {designOf, order, problemOfStored, sha256Of, solve, type FiledDesign} from 'seamwise/node';
import {afterAll, beforeAll, expect, it} from 'vitest';

import {seamwise} from '../../support/cli/command-line.js';
import {checks, twoStrips} from '../../support/garments/samples.js';

let folder = '';
const file = (name: string) => join(folder, name);
const garment = JSON.stringify(twoStrips(20));
const print = JSON.stringify({...checks, title: 'Meadow', unscaled: true});

const refusal =
  /^seamwise: The size of the print 'Meadow' is unknown, so that nothing can be cut by it; measure a repeat, and give its w1 and w2 in cm, without 'unscaled'\.\n$/;

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'seamwise-'));
  writeFileSync(file('strips.json'), garment);
  writeFileSync(file('meadow.json'), print);
});

afterAll(() => {
  rmSync(folder, {recursive: true});
});

it('is refused by the command line before anything is written', async () => {
  const words = ['--print', file('meadow.json')];
  const result = file('result.json');
  const aligned = await seamwise('align', file('strips.json'), ...words, '--out', result);
  expect(aligned.code).toBe(0);
  const before = readdirSync(folder);
  const cut = await seamwise('cut', result, ...words, '--pdf', file('cut.pdf'));
  expect(cut).toMatchObject({code: 2, out: ''});
  expect(cut.err).toMatch(refusal);
  const laid = await seamwise(
    'marker',
    result,
    ...words,
    '--width',
    '140',
    '--out',
    file('p.json'),
  );
  expect(laid).toMatchObject({code: 2, out: ''});
  expect(laid.err).toMatch(refusal);
  expect(readdirSync(folder)).toEqual(before);
});

it('is refused by an order before anything is solved', async () => {
  const shelf = new Map([
    ['strips.json', garment],
    ['meadow.json', print],
  ]);
  const chosen: FiledDesign = {
    garment: {url: 'strips.json', sha256: sha256Of(garment)},
    print: {url: 'meadow.json', sha256: sha256Of(print)},
    ...{symmetry: 'auto', method: 'best', options: {}, seed: 3},
  };
  const result = await solve(problemOfStored(chosen, {garment, print}));
  const stored = designOf(chosen, result);
  const design = JSON.stringify({format: 'seamwise-design/1', ...stored});
  const read = (url: string) => Promise.resolve(new TextEncoder().encode(shelf.get(url)));
  await expect(order(design, {read})).rejects.toMatchObject({
    code: 'unscaled',
    message: expect.stringMatching(
      /^The size of the print 'Meadow' is unknown.*measure a repeat.*\.$/,
    ) as string,
  });
});
