import {
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  truncateSync,
  writeFileSync,
} from 'node:fs';
import {createServer} from 'node:http';
import type {AddressInfo} from 'node:net';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import type {OrderRecord} from 'seamwise/node';
import {afterAll, beforeAll, describe, expect, it} from 'vitest';

import {seamwise, seamwiseProcess} from '../../support/cli/command-line.js';
import {checks, twoStrips} from '../../support/garments/samples.js';

let folder = '';
const file = (name: string) => join(folder, name);

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'seamwise-'));
  writeFileSync(file('strips.json'), JSON.stringify(twoStrips()));
  writeFileSync(file('checks.json'), JSON.stringify(checks));
  writeFileSync(file('broken.json'), '{"pattern":');
  writeFileSync(file('huge.json'), '');
  truncateSync(file('huge.json'), 200_000_000);
  writeFileSync(file('empty.json'), '');
  const hollow = {pieces: [], seams: [], symmetries: [], print: checks, metrics: {}};
  writeFileSync(file('hollow.json'), JSON.stringify({format: 'seamwise-result/1', ...hollow}));
  mkdirSync(file('folder'));
});

afterAll(() => {
  rmSync(folder, {recursive: true});
});

const align = (...words: string[]) =>
  seamwise('align', file('strips.json'), '--print', file('checks.json'), ...words);

describe('align', () => {
  it('prints one line of figures, and no progress where nobody watches', async () => {
    const words = [file('strips.json'), '--print', file('checks.json')];
    const {code, out, err} = await seamwiseProcess('align', ...words);
    expect({code, err}).toEqual({code: 0, err: ''});
    expect(out.trimEnd().split('\n')).toHaveLength(1);
    expect(out).toContain('strips.json: 2 pieces, 1 seam, p4m, best, seed 1');
  });

  it('prints the figures as JSON', async () => {
    const {out} = await align('--json', '--seed', '5', '--method', 'ws19');
    expect(JSON.parse(out)).toMatchObject({group: 'p4m', method: 'ws19', seed: 5});
  });

  it('writes the result, byte for byte the same when it leaves out times', async () => {
    for (const name of ['a.json', 'b.json']) await align('--no-times', '--out', file(name));
    const [a, b] = [readFileSync(file('a.json'), 'utf8'), readFileSync(file('b.json'), 'utf8')];
    expect(a).toBe(b);
    expect(JSON.parse(a)).toMatchObject({format: 'seamwise-result/1', metrics: {method: 'best'}});
  });

  it('notes which grain it assumed, and nothing where none is needed', async () => {
    const task = ['align', file('strips.json'), '--print', file('checks.json'), '--json'];
    const free = await seamwise(...task);
    expect(free.err).toBe('');
    writeFileSync(file('on.json'), '{"grain": {"default": "on"}}');
    const {code, out} = await seamwise(...task, '--options', file('on.json'));
    expect(code).toBe(0);
    const {notes} = JSON.parse(out) as {notes: string[]};
    expect(notes.join()).toMatch(/has no grain line .* upwards as drawn: 'left', 'right'/);
    writeFileSync(
      file('said.json'),
      '{"grain": {"default": "on", "pieces": {"left": "across", "right": {"angleDeg": 0}}}}',
    );
    const said = await seamwise(...task, '--options', file('said.json'));
    expect((JSON.parse(said.out) as {notes: string[]}).notes.join()).toMatch(/as drawn: 'left';/);
  });

  it('leaves no drafts behind', async () => {
    await align('--out', file('c.json'));
    expect(readdirSync(folder).filter((name) => name.endsWith('.tmp'))).toEqual([]);
  });
});

describe('bad input exits with 2 and one sentence that names it', () => {
  const cases: Record<string, () => [words: string[], named: string]> = {
    'no command': () => [[], 'command'],
    'an unknown command': () => [['alling'], 'alling'],
    'no garment': () => [['align', '--print', file('checks.json')], 'garment'],
    'no print': () => [['align', file('strips.json')], '--print'],
    'a missing file': () => [
      ['align', file('none.json'), '--print', file('checks.json')],
      'none.json',
    ],
    'a directory': () => [['align', file('folder'), '--print', file('checks.json')], 'folder'],
    'a huge file': () => [
      ['align', file('huge.json'), '--print', file('checks.json')],
      'huge.json',
    ],
    'a broken file': () => [
      ['align', file('broken.json'), '--print', file('checks.json')],
      'broken.json',
    ],
    'an empty options file': () => [
      [
        'align',
        file('strips.json'),
        '--print',
        file('checks.json'),
        '--options',
        file('empty.json'),
      ],
      'empty.json',
    ],
    'a print that is none': () => [
      ['align', file('strips.json'), '--print', file('strips.json')],
      'strips.json',
    ],
    'an unknown flag': () => [['align', 'a', '--print', 'b', '--fast'], '--fast'],
    'an unknown method': () => [['align', 'a', '--print', 'b', '--method', 'x'], '--method'],
    'a negative seed': () => [['align', 'a', '--print', 'b', '--seed', '-1'], '--seed'],
    'a missing symmetry file': () => [
      ['align', file('strips.json'), '--print', file('checks.json'), '--symmetry', file('s.json')],
      's.json',
    ],
    'a result in a folder that is not there': () => [
      ['align', file('strips.json'), '--print', file('checks.json'), '--out', file('no/r.json')],
      `there is no folder ${file('no')}; create it`,
    ],
    'a garment in a folder that is not there': () => [
      ['convert', file('strips.json'), '--out', file('no/g.json')],
      `there is no folder ${file('no')}; create it`,
    ],
    'a result on top of what is read': () => [
      ['align', file('strips.json'), '--print', file('checks.json'), '--out', file('strips.json')],
      'strips.json is read and would be overwritten',
    ],
    'a picture for a print': () => [
      ['align', file('strips.json'), '--print', file('checks.png')],
      'checks.png is a picture',
    ],
    'a picture that would hold another format': () => [
      ['draw', file('strips.json'), '--print', file('checks.json'), '--out', file('a.png')],
      'a file ending in .svg',
    ],
    'a result without pieces': () => [
      ['draw', file('hollow.json'), '--print', file('checks.json')],
      'hollow.json is not a whole result file',
    ],
    'an order of what is no design': () => [['order', file('strips.json')], 'strips.json is no'],
    'an order that is not there': () => [['order', file('none.json')], 'none.json'],
    'an allowance that is none': () => [
      ['order', file('d.json'), '--svg', file('c.svg'), '--allowance', '-1'],
      '--allowance',
    ],
    'a width without a record': () => [['order', 'd.json', '--width', '140'], '--record FILE.json'],
    'an allowance around nothing': () => [['order', 'd.json', '--allowance', '1'], '--svg'],
    'two files under one name': () => [
      ['order', 'd.json', '--out', file('c.svg'), '--svg', file('c.svg')],
      'name two',
    ],
    'a design on top of the result': () => [
      [
        ...['align', file('strips.json'), '--print', file('checks.json')],
        ...['--out', file('r.json'), '--design', file('r.json')],
      ],
      'name two',
    ],
    'a result on top of a directory': () => [
      ['align', file('strips.json'), '--print', file('checks.json'), '--out', file('folder')],
      'folder',
    ],
  };

  it.each(Object.keys(cases))('%s', async (name) => {
    const [words, named] = cases[name]?.() ?? [[], ''];
    const {code, out, err} = await seamwise(...words);
    expect({code, out}).toEqual({code: 2, out: ''});
    expect(err.trimEnd().split('\n')).toHaveLength(1);
    expect(err).toContain(named);
  });
});

it('explains itself', async () => {
  const {code, out} = await seamwise('--help');
  expect(code).toBe(0);
  expect(out).toContain('seamwise align GARMENT.json [GARMENT.json ...] --print PRINT.json');
  const {out: own} = await seamwise('convert', '--help');
  expect(own).toMatch(/^seamwise convert GARMENT\.json/);
  expect(own).not.toContain('seamwise align');
});

it('lists the symmetries of a garment in a form that align takes', async () => {
  const {code} = await seamwise('symmetries', file('strips.json'), '--out', file('found.json'));
  expect(code).toBe(0);
  expect((await align('--symmetry', file('found.json'))).code).toBe(0);
});

it('ends as a process with the same code and sentence', async () => {
  for (const words of [['alling'], ['order', file('none.json')], ['--version']]) {
    expect(await seamwiseProcess(...words)).toEqual(await seamwise(...words));
  }
});

it("converts a garment to the project's own format", async () => {
  const {out} = await seamwise('convert', file('strips.json'));
  expect(JSON.parse(out)).toMatchObject({format: 'seamwise-garment/1'});
});

it('says its version', async () => {
  const {code, out} = await seamwise('--version');
  expect(code).toBe(0);
  expect(out).toMatch(/^\d+\.\d+\.\d+\n$/);
});

describe('order', () => {
  const text = (name: string) => readFileSync(file(name), 'utf8');
  /** Stores a design, after a change of its text. */
  const store = async (name: string, change = (design: string) => design) => {
    const made = await align('--no-times', '--out', file('sold.json'), '--design', file(name));
    expect(made).toMatchObject({code: 0, err: ''});
    writeFileSync(file(name), change(text(name)));
  };

  it('writes the very bytes that were sold, and the pieces to cut', async () => {
    await store('d.json');
    const [out, svg] = [file('made.json'), file('cut.svg')];
    const done = await seamwise('order', file('d.json'), '--out', out, '--svg', svg, '--json');
    expect(done).toMatchObject({code: 0, err: ''});
    expect(JSON.parse(done.out)).toMatchObject({reproduced: true, differenceCm: 0, group: 'p4m'});
    expect(text('made.json')).toBe(text('sold.json'));
    expect(text('cut.svg')).toContain('Solid: cut. Dashed: sew, 1 cm inside, 3 cm at hems.');
    expect(text('cut.svg')).not.toContain('NOT AS IT WAS SOLD');
  });

  it('writes a record for the cart and the workshop', async () => {
    await store('d.json');
    const record = ['--record', file('record.json'), '--width', '140', '--selvedge', '2'];
    expect(await seamwise('order', file('d.json'), ...record)).toMatchObject({code: 0, err: ''});
    const {visibleSeams, cloth, thumbnail, ...rest} = JSON.parse(
      text('record.json'),
    ) as OrderRecord;
    expect(rest).toMatchObject({format: 'seamwise-order/1', reproduced: true, pieces: 2});
    expect(visibleSeams).toEqual({matched: 1, of: 1});
    expect(cloth?.widthCm).toBe(140);
    expect(cloth?.lengthCm).toBeGreaterThan(10);
    expect(thumbnail.match(/<g aria-label/g)).toHaveLength(2);
  });

  it('counts relative URLs from --base when it is given', async () => {
    await store('far.json');
    mkdirSync(file('far'));
    writeFileSync(file('far/d.json'), text('far.json'));
    expect(await seamwise('order', file('far/d.json'))).toMatchObject({code: 2, out: ''});
    const {code, out} = await seamwise('order', file('far/d.json'), '--base', folder);
    expect({code, out: out.trimEnd().split('; ').at(-1)}).toEqual({
      code: 0,
      out: 'reproduced true',
    });
  });

  it('says so, and what to do, when the answer is not the one that was sold', async () => {
    const older = (design: string) =>
      design
        .replace(/"result": "\w+"/, `"result": "${'0'.repeat(64)}"`)
        .replace(/"solver": "[^"]+"/, '"solver": "0.0.7"');
    await store('old.json', older);
    const outputs = ['--out', file('new.json'), '--svg', file('new.svg')];
    const {code, out, err} = await seamwiseProcess('order', file('old.json'), ...outputs);
    expect({code, out: out.trimEnd().split('; ').at(-1)}).toEqual({
      code: 3,
      out: 'reproduced false',
    });
    expect(err).toMatch(/^note: the answer differs from the one that was sold, .* 0\.000 cm /);
    expect(err).toContain('(npm install seamwise-0.0.7@file:seamwise-0.0.7.tgz)');
    expect(text('new.json')).toBe(text('sold.json').replace('{', '{"reproduced":false,'));
    // the file for cutting must show it, too
    expect(text('new.svg')).toContain('>NOT AS IT WAS SOLD</text>');
    const drawn = await seamwise('draw', file('new.json'), '--print', file('checks.json'));
    expect(drawn.out).toContain('>NOT AS IT WAS SOLD</text>');
  });

  it('takes design, garment, print and picture from the web', async () => {
    const image = '<svg xmlns="http://www.w3.org/2000/svg"><title>the night</title></svg>';
    const ways = {...checks, colourways: [{name: 'Night', image: 'night.svg'}]};
    writeFileSync(file('shop.json'), JSON.stringify(ways));
    const [strips, print] = [file('strips.json'), file('shop.json')];
    await seamwise('align', strips, '--print', print, '--design', file('web.json'));
    const design = text('web.json').replace('shop.json",', '$&"colourway": "night",');
    const shelf: Record<string, string> = {
      '/web.json': design,
      '/night.svg': image,
      '/strips.json': text('strips.json'),
      '/shop.json': text('shop.json'),
    };
    const server = createServer(({url = ''}, response) => response.end(shelf[url]));
    await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
    const base = `http://127.0.0.1:${String((server.address() as AddressInfo).port)}`;
    try {
      const done = await seamwise('order', `${base}/web.json`, '--svg', file('night.svg'));
      expect(done).toMatchObject({code: 0, err: ''});
      expect(done.out).toContain('; reproduced true');
    } finally {
      server.close();
    }
    expect(text('night.svg')).toContain(encodeURIComponent('<title>the night</title>'));
  });

  it('reads what a design names where it lies itself, or where one stands, and nowhere else', async () => {
    await store('near.json', (design) => design.replace('strips.json', '/etc/hostname'));
    const {code, err} = await seamwise('order', file('near.json'));
    expect(code).toBe(2);
    expect(err).toContain('/etc/hostname lies outside of ');
  });

  it('draws nothing from a garment that was changed since', async () => {
    await store('d.json', (design) => design.replace(/(?<="sha256": ")\w{4}/, '0000'));
    const {code, out, err} = await seamwise('order', file('d.json'), '--out', file('none.json'));
    expect({code, out}).toEqual({code: 2, out: ''});
    expect(err).toMatch(/strips\.json is not the file that .* was made with, .*; put the earlier/);
    expect(readdirSync(folder)).not.toContain('none.json');
  });
});
