import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createServer} from 'node:http';
import type {AddressInfo} from 'node:net';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {afterAll, beforeAll, describe, expect, it} from 'vitest';

import {seamwise} from '../../support/cli/command-line.js';
import {checks, twoStrips} from '../../support/garments/samples.js';

let folder = '';
const file = (name: string) => join(folder, name);

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'seamwise-'));
  writeFileSync(file('strips.json'), JSON.stringify(twoStrips()));
  writeFileSync(file('checks.json'), JSON.stringify(checks));
});

afterAll(() => {
  rmSync(folder, {recursive: true});
});

const align = (...words: string[]) =>
  seamwise('align', file('strips.json'), '--print', file('checks.json'), ...words);

it('draws each stage of a solve with meshes, letters and cells', async () => {
  const words = ['dump', file('strips.json'), '--print', file('checks.json')];
  const {code, out} = await seamwise(...words, '--out', file('stages'));
  expect(code).toBe(0);
  const files = out.trimEnd().split('\n');
  expect(files.map((path) => path.replace(/.*\d-|\.svg$/g, ''))).toEqual(
    expect.arrayContaining(['drafted', 'search', 'placed', 'shaped']),
  );
  const mean = (picture: string): number =>
    Number(/mean mismatch ([\d.]+) mm/.exec(picture)?.[1] ?? NaN);
  const pictures = files.map((path) => readFileSync(path, 'utf8'));
  for (const picture of pictures) {
    expect(picture.match(/class="mesh" d="[^"]/g)).toHaveLength(2);
    expect(picture.match(/>A<\/text>/g)).toHaveLength(2);
    expect(picture).toContain('id="stage-fabric"');
  }
  expect(mean(pictures.at(-1) ?? '')).toBeLessThanOrEqual(mean(pictures[0] ?? ''));
  const nowhere = await seamwise(...words);
  expect(nowhere).toMatchObject({code: 2, err: 'seamwise: --out FOLDER is missing.\n'});
});

it('draws a print in each of its colourways, and in no other', async () => {
  const print = JSON.stringify({
    ...checks,
    image: 'data:image/png;base64,day',
    colourways: [
      {name: 'Day', image: 'data:image/png;base64,day'},
      {name: 'Night', image: 'data:image/png;base64,night'},
    ],
  });
  writeFileSync(file('ways.json'), print);
  await align('--out', file('ways-result.json'));
  const draw = (...words: string[]) =>
    seamwise('draw', file('ways-result.json'), '--print', file('ways.json'), ...words);
  expect((await draw('--colourway', 'night')).out).toContain('base64,night');
  const {code, err} = await draw('--colourway', 'Noon');
  expect(code).toBe(2);
  expect(err).toContain("no colourway 'Noon'; there are Day, Night");
});

it('puts a picture from the web into what it draws', async () => {
  const image = '<svg xmlns="http://www.w3.org/2000/svg"><title>far away</title></svg>';
  const server = createServer((_, response) => response.end(image));
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const {port} = server.address() as AddressInfo;
  const far = {...checks, image: `http://127.0.0.1:${String(port)}/cell.svg`};
  writeFileSync(file('far-image.json'), JSON.stringify(far));
  await align('--out', file('near-result.json'));
  const words = ['draw', file('near-result.json'), '--print', file('far-image.json')];
  try {
    const {code, out} = await seamwise(...words);
    expect(code).toBe(0);
    expect(out).not.toContain('127.0.0.1');
    expect(out).toContain(encodeURIComponent('<title>far away</title>'));
  } finally {
    server.close();
  }
  expect(await seamwise(...words)).toMatchObject({
    code: 2,
    err: expect.stringContaining('cell.svg cannot be fetched') as string,
  });
});

describe('a forged result', () => {
  type Forge = (result: Record<string, never>) => unknown;
  const forged: Record<string, readonly [Forge, string]> = {
    'with a symmetry of no kind': [
      (result) => ({...result, symmetries: [{kind: 'x'}]}),
      "'symmetries[0].kind' must be one of piece, pair",
    ],
    'with a symmetry of a piece that is not there': [
      (result) => ({
        ...result,
        symmetries: [{kind: 'piece', piece: 9, map: {angle: 0, translation: [0, 0]}, pairs: []}],
      }),
      "'symmetries[0].piece' must be a number below 2",
    ],
    'with a seam of nothing': [(result) => ({...result, seams: [{}]}), "'seams[0].a' must be"],
    'with text for figures': [(result) => ({...result, metrics: 'x'}), "'metrics' must be"],
    'with a name that is none': [
      (result) => ({...result, pieces: [{...(result.pieces?.[0] as object | undefined), name: 3}]}),
      "'pieces[0].name' must be text",
    ],
  };

  it.each(Object.entries(forged))('%s is refused with one sentence', async (_, [forge, words]) => {
    await align('--out', file('true.json'));
    const result = JSON.parse(readFileSync(file('true.json'), 'utf8')) as Record<string, never>;
    writeFileSync(file('forged.json'), JSON.stringify(forge(result)));
    const {code, err} = await seamwise('draw', file('forged.json'), '--print', file('checks.json'));
    expect({code, lines: err.trimEnd().split('\n').length}).toEqual({code: 2, lines: 1});
    expect(err).toContain(`forged.json is not a whole result file (seamwise-result/1): ${words}`);
  });
});

it('draws a result on its print, and on no other', async () => {
  await align('--out', file('drawn.json'));
  const picture = await seamwise('draw', file('drawn.json'), '--print', file('checks.json'));
  expect(picture).toMatchObject({code: 0, err: ''});
  expect(picture.out).toMatch(/^<svg[\s\S]*<\/svg>\s*$/);

  writeFileSync(file('wide.json'), JSON.stringify({...checks, w1: [5, 0], w2: [0, 5]}));
  const other = await seamwise('draw', file('drawn.json'), '--print', file('wide.json'));
  expect(other).toMatchObject({code: 2, out: ''});
});
