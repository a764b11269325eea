import {mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {validateBytes} from 'gltf-validator';
import {afterAll, beforeAll, describe, expect, it} from 'vitest';

import type {DrapeFile, GarmentCodeSpecification} from 'seamwise/node';
import {Shop} from '../../support/cli/batch.js';
import {seamwise} from '../../support/cli/command-line.js';
import {readGlb} from '../../support/drape/read-glb.js';
import {checks, shortSkirt, twoStrips} from '../../support/garments/samples.js';

const prints = fileURLToPath(new URL('../../../public/prints/', import.meta.url));
const print = join(prints, 'p4m.json');

let folder = '';
const file = (name: string) => join(folder, name);
const drape = (...words: string[]) => seamwise('drape', file('skirt.result.json'), ...words);

/** A garment without seams, which hangs nowhere. */
const unsewn = (garment: GarmentCodeSpecification): object => ({
  ...garment,
  pattern: {...garment.pattern, stitches: []},
});

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), 'seamwise-'));
  writeFileSync(file('skirt.json'), shortSkirt(44.5));
  const words = ['--print', print, '--no-remedies', '--out', file('skirt.result.json')];
  await seamwise('align', file('skirt.json'), ...words);
});

afterAll(() => {
  rmSync(folder, {recursive: true});
});

it('writes what is worn as a file and as GLB, with figures in one line', async () => {
  const words = ['--print', print, '--colourway', 'night', '--fabric', 'jersey', '--size', 'L'];
  const outputs = (name: string) => ['--out', file(`${name}.json`), '--glb', file(`${name}.glb`)];
  const {code, out, err} = await drape(...words, ...outputs('one'), '--no-times', '--form');
  expect(code).toBe(0);
  expect(err).toMatch(/^(note: .*\n)*$/); // jersey is slow
  expect(out).toMatch(/^\S+: 2 pieces of jersey, \d+ triangles; .*; 0 crossings; 0 ms\n$/);
  const written = JSON.parse(readFileSync(file('one.json'), 'utf8')) as DrapeFile;
  expect(written).toMatchObject({
    ...{format: 'seamwise-drape/1', units: 'cm', effort: 1, contactOffset: 0.12},
    ...{fabric: {name: 'jersey'}, form: {body: {bust: 104}}, metrics: {milliseconds: 0}},
  });

  const glb = readFileSync(file('one.glb'));
  const {issues} = await validateBytes(new Uint8Array(glb));
  expect(issues).toMatchObject({numErrors: 0, numWarnings: 0});
  const {json, bytesOf} = readGlb(glb);
  expect(json.extras).toMatchObject({garment: 'Skirt', print: {title: 'Majolica'}});
  const raster = readFileSync(join(prints, 'p4m-night.png'));
  expect(raster.equals(bytesOf(json.images?.[0]?.bufferView ?? -1))).toBe(true);

  const again = await drape(...words, ...outputs('two'), '--no-times', '--form', '--json');
  expect(JSON.parse(again.out)).toMatchObject({fabric: 'jersey', milliseconds: 0});
  for (const ending of ['json', 'glb']) {
    const [one, two] = ['one', 'two'].map((name) => readFileSync(file(`${name}.${ending}`)));
    expect(one && two?.equals(one)).toBe(true); // toEqual takes seconds
  }
});

describe('says in one sentence', () => {
  it.each<[string, string[], string]>([
    ['that the print is missing', [], '--print PRINT.json is missing.'],
    ['that it draws no pictures', ['--print', print, '--png', 'x.png'], '--png needs a renderer'],
    ['what it would write', ['--print', print, '--glb', 'x.gltf'], 'name a file ending in .glb.'],
    ['which fabrics there are', ['--print', print, '--fabric', 'wool'], 'poplin, jersey, denim'],
    ['which efforts there are', ['--print', print, '--effort', '3'], 'must be one of 1, 2, 4.'],
    ['that a body has one size', ['--print', print, '--size=S', '--body=b'], 'give one.'],
    [
      'what belongs to a GLB file',
      ['--print', print, '--form'],
      '--form belongs to --glb FILE.glb',
    ],
    ['that outputs differ', ['--print', print, '--out=a.glb', '--glb=a.glb'], 'name two.'],
    ['that it is another print', ['--print', join(prints, 'p1.json')], 'another group or repeat'],
  ])('%s', async (_, words, sentence) => {
    const {code, out, err} = await drape(...words);
    expect({code, out}).toEqual({code: 2, out: ''});
    expect(err).toContain(sentence);
    expect(err.trimEnd().split('\n')).toHaveLength(1);
  });

  it('what is wrong with a picture, a body and a garment', async () => {
    const cloth = JSON.parse(readFileSync(print, 'utf8')) as object;
    writeFileSync(file('cell.svg'), '<svg xmlns="http://www.w3.org/2000/svg"/>');
    const vector = {...cloth, image: 'cell.svg', colourways: undefined};
    writeFileSync(file('vector.json'), JSON.stringify(vector));
    const drawn = await drape('--print', file('vector.json'), '--glb', file('x.glb'));
    expect(drawn.code).toBe(2);
    expect(drawn.err).toContain("cell.svg is neither; name one as 'raster' of a colourway");

    writeFileSync(file('body.json'), '{"bust": "wide"}');
    const wide = await drape('--print', print, '--body', file('body.json'));
    expect(wide.code).toBe(2);
    expect(wide.err).toContain('body.json');
    expect(wide.err).toContain('bust');

    writeFileSync(file('strips.json'), JSON.stringify(unsewn(twoStrips())));
    writeFileSync(file('checks.json'), JSON.stringify(checks));
    const words = ['--print', file('checks.json')];
    await seamwise('align', file('strips.json'), ...words, '--out', file('strips.result.json'));
    const strips = await seamwise('drape', file('strips.result.json'), ...words);
    expect(strips.code).toBe(2);
    expect(strips.err).toContain('strips.result.json');
    expect(strips.err).toContain("No seam joins piece 'right' to the others");
    expect(readdirSync(folder)).not.toContain('x.glb');
  });
});

it('drapes the jobs of a batch that ask for it, beside their results', async () => {
  const shop = new Shop();
  try {
    shop.write('skirt.json', shortSkirt());
    const job = {garment: 'skirt.json', print: 'checks.json'};
    shop.write('unsewn.json', JSON.stringify(unsewn(twoStrips())));
    shop.writeJobs('jobs.ndjson', [
      {...job, drape: true},
      job,
      {...job, garment: 'unsewn.json', drape: true},
      {...job, drape: 'yes'},
    ]);
    const {code} = await shop.batch('jobs.ndjson', 'out');
    expect(code).toBe(1);
    const done = shop.done('out');
    const [draped, plain] = done.filter(({status}) => status === 'done');
    expect(draped?.sha256).toBe(plain?.sha256);
    expect(draped?.key).not.toBe(plain?.key);
    const messages = done.flatMap(({failure}) => failure?.message ?? []);
    expect(messages.join()).toContain("'drape' must be true or false");
    expect(messages.join()).toContain('unsewn.json');
    const results = readdirSync(shop.at('out', 'results'));
    expect(results).toHaveLength(4);
    const key = results.find((name) => name.endsWith('.glb'))?.replace('.glb', '') ?? '';
    expect(results).toEqual(expect.arrayContaining([`${key}.json`, `${key}.drape.json`]));
    const {extras} = readGlb(readFileSync(shop.at('out', 'results', `${key}.glb`))).json;
    expect(extras).toMatchObject({garment: 'Skirt', sha256: draped?.sha256});
    const again = await shop.batch('jobs.ndjson', 'out', '--json');
    expect(JSON.parse(again.out)).toMatchObject({done: 2, failed: 2});
  } finally {
    shop.remove();
  }
});
