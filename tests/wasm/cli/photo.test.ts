import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {repeatOf} from '@/model/print/repeat.js';
import {printFromPixels} from 'seamwise/node';
import {afterAll, beforeAll, describe, expect, it} from 'vitest';

import {seamwise} from '../../support/cli/command-line.js';
import {sampleOf} from '../../support/level.js';
import {decoyCases} from '../../support/photo/decoy-cases.js';
import {jpegOf, pngOf, stored, withExif} from '../../support/photo/files.js';
import {judge, type PhotoAnswer, type PrintVectors} from '../../support/photo/judge.js';
import {floralCase} from '../../support/photo/print-cases.js';
import type {PhotoCase} from '../../support/photo/case.js';
import {cutTileCase, tileCase} from '../../support/photo/tile-cases.js';

const size = [720, 540] as const;
let folder = '';
let photographed: PhotoCase;
const file = (name: string) => join(folder, name);
const photo = (...words: string[]) => seamwise('photo', ...words);

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), 'seamwise-'));
  photographed = await floralCase({name: 'roses', level: 'normal', seed: 401, size}, 'pmg');
  const {pixels, truth} = photographed;
  const lying = await jpegOf(stored(pixels, 6), 90);
  writeFileSync(file('roses.jpg'), withExif(lying, 6, truth.f35 ?? 26));
});

afterAll(() => {
  rmSync(folder, {recursive: true});
});

describe('a photograph', () => {
  it('is a print of its lattice, group and size, beside a clean picture of its cell', async () => {
    const {truth} = photographed;
    if (!truth.homography) throw new Error('The case has a print.');
    const length = Math.hypot(...truth.w1);
    const words = ['--measure', `w1=10/${10 * length}`, '--out', file('made.json')];
    const {code, out, err} = await photo(file('roses.jpg'), ...words, '--json');
    expect({code, err}).toEqual({code: 0, err: ''});
    const answer = JSON.parse(out) as PhotoAnswer;
    const {print} = judge(truth, answer);
    expect(print).toMatchObject({primitive: true, exactGroup: true, falseClaim: false});
    expect(print?.latticeError).toBeLessThan(0.003);
    expect(print?.scaleError).toBeLessThan(0.006);
    expect(answer.confidence).not.toBe('uncertain');
    const written = JSON.parse(readFileSync(file('made.json'), 'utf8')) as PrintVectors;
    expect(written).toMatchObject({format: 'seamwise-print/1', group: 'pmg', image: 'made.png'});
    expect(written).toMatchObject({title: 'Roses'}); // the image's name
    expect(written).not.toHaveProperty('unscaled');
    for (const number of [...written.w1, ...written.w2]) {
      expect(String(number)).toMatch(/^-?\d+(\.\d{1,7})?$/);
    }
    const own = judge(truth, {...answer, w1: null, w2: null}, written).print;
    expect(Math.abs(own?.aspectError ?? 1)).toBeLessThan(0.005);
    expect(Math.abs(own?.angleError ?? 180)).toBeLessThan(0.3);
    expect(readFileSync(file('made.png')).subarray(1, 4).toString()).toBe('PNG');
  });

  it(
    'of a hexagonal lattice is as wide as on the page, and w1 is told beside',
    {tags: ['thorough']},
    async () => {
      const {pixels} = await floralCase(
        {name: 'stars', level: 'normal', seed: 8, size: [800, 640]},
        'p31m',
      );
      writeFileSync(file('stars.png'), await pngOf(pixels));
      const words = ['--measure', 'w1=10/80', '--out', file('read.json')];
      const {code, out, err} = await photo(file('stars.png'), ...words);
      expect({code, err}).toMatchObject({code: 0});
      expect(out).toContain('p31m, one repeat 8.00 x 13.86 cm, w1 8.00 and w2 8.00 cm (+-');
      // the directions show where to hold the tape measure
      expect(out).toMatch(
        /, w1 (down|up|to the (left|right))[a-z ]* and w2 [a-z ]+ on the picture,/,
      );
      expect(err).not.toContain('disagree');
      const apart = await photo(
        file('stars.png'),
        '--measure',
        'w1=10/80',
        '--measure',
        'w2=10/40',
      );
      expect(apart.err).toMatch(
        /The lengths disagree by 50 %: with 8\.00 cm along w1, .* 8\.0. cm along w2, not 4\.00 cm/,
      );
      const print = JSON.parse(readFileSync(file('read.json'), 'utf8')) as PrintVectors;
      const {size: repeat} = repeatOf({group: 'p31m', ...print});
      expect(repeat.width).toBeCloseTo(8, 6);
      expect(repeat.height).toBeCloseTo(8 * Math.sqrt(3), 6);
      const told = JSON.parse((await photo(file('stars.png'), ...words, '--json')).out) as object;
      expect(told).toMatchObject({size: {angleDeg: 90}});
    },
  );

  it('is one in proportion only while nobody has measured it', async () => {
    const {code, out} = await photo(file('roses.jpg'), '--out', file('loose.json'));
    expect(code).toBe(0);
    expect(out).toMatch(
      /roses\.jpg: pmg, size unknown \(measure it: --measure w1=REPEATS\/CM\), w1 [a-z ]+ and w2 [a-z ]+ on the picture, \d+ copies/,
    );
    expect(JSON.parse(readFileSync(file('loose.json'), 'utf8'))).toMatchObject({unscaled: true});
  });

  it('is read alike by the function, which can be stopped', async () => {
    const {pixels} = photographed;
    const {reading, tile, print} = await printFromPixels(pixels, {symmetrise: true});
    expect(reading.group).toBe('pmg');
    expect(tile.data).toHaveLength(4 * tile.width * tile.height);
    expect(print.unscaled).toBe(true);
    const signal = AbortSignal.timeout(30);
    await expect(printFromPixels(pixels, {}, {signal})).rejects.toThrow(/timeout/i);
  });
});

it('takes a seamless picture as cells, and refuses one that is cut', async () => {
  const whole = await tileCase('tile', 'p4g', 2, 77);
  writeFileSync(file('tile.png'), await pngOf(whole.pixels));
  const {code, out} = await photo(file('tile.png'), '--tile', '--json');
  expect(code).toBe(0);
  expect(judge(whole.truth, JSON.parse(out) as PhotoAnswer).print).toMatchObject({
    exactGroup: true,
    falseClaim: false,
  });
  const cut = await cutTileCase('cut', 'cmm', 78);
  writeFileSync(file('cut.png'), await pngOf(cut.pixels));
  const refused = await photo(file('cut.png'), '--tile');
  expect(refused.code).toBe(2);
  expect(refused.err).toMatch(/^seamwise: \S+cut\.png: The picture's edges do not meet: /);
});

describe('what is no print', () => {
  it('is refused with one sentence', async () => {
    const decoys = decoyCases(900, size);
    for (const k of sampleOf(1, [8, 0])) {
      const decoy = await decoys[k]?.();
      if (!decoy) throw new Error('There is no such decoy.');
      writeFileSync(file('decoy.png'), await pngOf(decoy.pixels));
      const {code, out, err} = await photo(file('decoy.png'), '--json');
      if (code === 0) expect(JSON.parse(out)).toMatchObject({confidence: 'uncertain'});
      else expect(err).toMatch(/^seamwise: \S+decoy\.png: [^\n]+: [^\n]+\n$/);
      expect([0, 2]).toContain(code);
    }
  });

  it.each([
    ['text', 'words.txt', /words\.txt is no PNG, JPEG or WebP; save it as one of these\.\n$/],
    ['half a file', 'half.jpg', /half\.jpg is damaged; save it again\.\n$/],
    ['a missing one', 'none.png', /none\.png/],
  ])('%s', async (_, name, sentence) => {
    writeFileSync(file('words.txt'), 'cloth');
    writeFileSync(file('half.jpg'), readFileSync(file('roses.jpg')).subarray(0, 4000));
    const {code, err} = await photo(file(name));
    expect(code).toBe(2);
    expect(err).toMatch(sentence);
  });

  it.each([
    [['--measure', 'w3=10/98.5'], /--measure is 'w3=10\/98\.5', but must be w1 or w2/],
    [['--measure', 'w1=0/98.5'], /--measure is 'w1=0\/98\.5'/],
    [['--measure', 'w1=1/8', '--measure', 'w1=1/9'], /--measure gives one vector twice/],
    [['--between', '1,2,3=4'], /--between is '1,2,3=4', but must be two points/],
    [['--between', '5,5,5,5=4'], /--between is '5,5,5,5=4'/],
    [['--f35', 'wide'], /--f35 is 'wide', but must be a focal length/],
    [['--out', 'print.png'], /print\.png would hold JSON/],
  ])('flags: %j', async (words, sentence) => {
    const {code, err} = await photo(file('roses.jpg'), ...words);
    expect(code).toBe(2);
    expect(err).toMatch(sentence);
  });
});
