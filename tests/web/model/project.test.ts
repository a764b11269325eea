import {FileError} from '@/model/base/versioned-file.js';
import {drawingTitle} from '@/model/garment/imported-drawing.js';
import {deflateRawSync} from 'node:zlib';

import {describe, expect, it} from 'vitest';

import type {Design} from '@/model/design/design.js';
import {LinkError, linkOf, readLink} from '@/model/documents/link.js';
import {sha256Of} from '@/model/documents/result-text.js';
import {isProject, readProject} from '@/model/documents/project.js';
import {writeProject} from '@/model/documents/write-project.js';
import {written} from '@/model/design/written-design.js';
import {fileNameOf, nameOf, shortened} from '@/model/documents/project-name.js';

const design: Design = {
  garment: {name: 'tee-m.json', text: '{"pattern": {}}', sample: {style: 'tee', size: 'm'}},
  print: {
    title: 'Ogee tulip, größer',
    group: 'cm',
    size: {width: 12, height: 9.25, angleDeg: 90},
    turnDeg: 90,
    oneWay: true,
    cell: 'rectangular',
    image: 'prints/cm-mist.svg',
    sample: {name: 'cm', colourway: 'Mist'},
  },
  symmetry: [
    {
      kind: 'piece',
      piece: 'front',
      axis: [
        [0, 0],
        [0, 40.5],
      ],
    },
    {kind: 'piece', piece: 'back', seams: [1, 7]},
    {kind: 'pair', pieces: ['sleeve_left', 'sleeve_right']},
  ],
  method: 'best',
  options: {
    maxChangeCm: 0.5,
    grain: {default: 'on', pieces: {front: {lock: 'free', toleranceDeg: 5}, back: 'bias'}},
    pins: {front: {angle: 0.1, translation: [1, -2]}},
    weights: {'3': 2},
    unmatched: [8, 9],
    plain: ['yoke'],
    locked: {front: true, back: [0, 3]},
    openEdges: 'free',
    matches: [
      {
        a: {
          piece: 'front',
          line: [
            [0, 0],
            [0, 4],
          ],
        },
        b: {piece: 'back', line: [[1, 0]]},
      },
    ],
  },
  seed: 7,
  fabric: 'denim',
};
/** A project in the form of its file. */
interface Fields {
  readonly design: Record<string, unknown>;
}

const view = {centre: [40, 60.5], scale: 7} as const;

/** The design with one of its fields replaced. */
function changed(path: string, value: unknown): string {
  const file = JSON.parse(writeProject(design)) as Record<string, unknown>;
  const names = path.split('.');
  const last = names.pop() ?? '';
  const holder = names.reduce<unknown>((at, name) => Reflect.get(Object(at) as object, name), file);
  Reflect.set(Object(holder) as object, last, value);
  return JSON.stringify(file);
}

function complaint(text: string): string {
  try {
    readProject(text, 'tee.seamwise.json');
  } catch (error) {
    if (error instanceof FileError) return error.message;
  }
  return 'none';
}

describe('a project', () => {
  it('is read as it was written', () => {
    expect(readProject(writeProject(design, {view}), 'x')).toEqual({design, view});
    expect(readProject(writeProject(design), 'x')).toEqual({design});
    const title = 'Für Ada';
    expect(readProject(writeProject(design, {title}), 'x')).toEqual({design, title});
  });

  it('is written in the fields that it has always had, an usual seed left out', () => {
    const {symmetry, ...rest} = (JSON.parse(writeProject(design)) as Fields).design;
    expect(symmetry).toBeUndefined();
    expect(rest).toMatchObject({symmetries: design.symmetry, seed: 7});
    const plain = JSON.parse(writeProject({...design, symmetry: 'none', seed: 1})) as Fields;
    expect(plain.design).toMatchObject({symmetries: []});
    expect(plain.design).not.toHaveProperty('seed');
  });

  it.each(['auto', 'none'] as const)('keeps what is asked for where it is %s', (symmetry) => {
    const asking = {...design, symmetry};
    expect(readProject(writeProject(asking), 'x').design).toEqual(asking);
  });

  it('of an earlier page has no seed, and a list of no symmetries', () => {
    const file = JSON.parse(changed('design.symmetries', [])) as Fields;
    delete file.design.seed;
    const read = readProject(JSON.stringify(file), 'x').design;
    expect(read).toEqual({...design, symmetry: 'none', seed: 1});
  });

  it('may hold a garment and a picture of its own', () => {
    const own: Design = {
      ...design,
      garment: {name: 'mine.json', text: '{}'},
      print: {...design.print, image: 'data:image/png;base64,AAAA'},
    };
    expect(readProject(writeProject(own), 'x').design).toEqual(own);
  });

  it('keeps the garments on its fabric, and the fabric as delivered', () => {
    const {symmetry, method, options, seed} = design;
    const other = {name: 'mine.json', text: '{"a": 1}'};
    const stated = {group: 'p4m', size: design.print.size, turnDeg: 0, cell: 'primitive'} as const;
    const whole: Design = {
      ...design,
      print: {...design.print, delivered: {shrinkage: {warp: 3, weft: 1}, stated}},
      copies: 2,
      added: [{garment: other, symmetry, method, options, seed, copies: 3}],
    };
    expect(readProject(writeProject(whole), 'x').design).toEqual(whole);
    expect(
      complaint(JSON.stringify({...JSON.parse(writeProject({...whole, copies: 21}))})),
    ).toMatch(/is damaged: 'design.copies' must be a whole number from 1 to 20/);
  });

  it('tells its files from others', () => {
    expect(isProject(JSON.parse(writeProject(design)))).toBe(true);
    expect(isProject({format: 'seamwise-garment/1'})).toBe(false);
    expect(isProject(null)).toBe(false);
  });

  it('is refused with the name of the file when it is none', () => {
    expect(complaint('{')).toMatch(/^tee\.seamwise\.json is not JSON; /);
    expect(complaint('[]')).toMatch(/^tee\.seamwise\.json is no project; /);
    expect(complaint('{"format": "seamwise-garment/1"}')).toMatch(/is no project; /);
  });

  it('is refused when a newer page wrote it', () => {
    expect(complaint(changed('format', 'seamwise-project/2'))).toMatch(
      /was saved by a newer Seamwise \(project format 2, this one reads 1\); load the page again/,
    );
  });

  it.each([
    ['design', undefined],
    ['design.garment.text', ''],
    ['design.garment.name', 7],
    ['design.garment.sample.style', '../../etc'],
    ['design.print.group', 'p5'],
    ['design.print.size.width', 0],
    ['design.print.size.height', 'wide'],
    ['design.print.size.angleDeg', 180],
    ['design.print.turnDeg', null],
    ['design.print.oneWay', 'yes'],
    ['design.print.image', 'https://example.org/tile.png'],
    ['design.print.image', '//example.org/tile.png'],
    ['design.print.image', '../secret.png'],
    ['design.print.image', 'data:text/html,<script>'],
    ['design.symmetries', {}],
    ['design.symmetries.0.axis', [[0, 0]]],
    ['design.symmetries.2.pieces', ['one']],
    ['design.method', 'worst'],
    ['design.seed', -1],
    ['design.options.maxChangeCm', -1],
    ['design.options.grain.default', 'off'],
    ['design.options.unmatched', [1.5]],
    ['design.options.pins.front.angle', 'left'],
    ['title', ''],
    ['view', {centre: [0, 0], scale: 0}],
  ])('is refused when %s is %j', (path, value) => {
    const field = path.replace(/\.(\d)/, '[$1]').replace(/^view$/, 'view.scale');
    const message = complaint(changed(path, value));
    expect(message).toMatch(/^tee\.seamwise\.json is damaged: '.* must be .*; correct it/);
    expect(message).toContain(`'${field}`);
  });

  it('is refused when a number is beyond all bounds', () => {
    expect(complaint(writeProject(design).replace('9.25', '1e999'))).toContain(
      'design.print.size.height',
    );
  });

  it('leaves out what it does not know', () => {
    expect(readProject(changed('design.options.colour', 'red'), 'x').design).toEqual(design);
  });
});

describe('a link', () => {
  const own: Design = {
    ...design,
    garment: {name: 'größe.json', text: JSON.stringify({panels: 'x'.repeat(9000)})},
    print: {
      ...{title: 'Tulpen 茶', group: 'cm', size: {width: 12, height: 9.25, angleDeg: 90}},
      ...{turnDeg: 90, oneWay: true, cell: 'rectangular', image: 'data:image/png;base64,AAAA'},
    },
  };
  const {garment, print, symmetry, method, options, seed, fabric} = design;
  const {group, size, turnDeg, oneWay, cell, sample} = print;
  const samples = {
    garment: garment.sample,
    print: {group, size, turnDeg, oneWay, cell, sample},
    ...{symmetry, method, options, seed, ...(fabric && {fabric})},
  };

  it('holds all of a design of samples but the samples', async () => {
    const link = await linkOf(design, undefined, false);
    expect(link).toMatch(/^#project=[\w-]+$/);
    expect(link.length).toBeLessThan(1000);
    expect(await readLink(link)).toEqual({...samples, garment: {sample: garment.sample}});
  });

  it('leaves out added patterns that are no samples, unless they are the sender’s to share', async () => {
    const {symmetry, method, options, seed} = design;
    const mine = {name: 'mine.json', text: '{"a": 1}'};
    const other = {symmetry, method, options, seed, copies: 2};
    const whole: Design = {
      ...design,
      added: [
        {...other, garment: mine},
        {...other, garment: design.garment},
      ],
    };
    const garmentsIn = async (isMine: boolean) =>
      (await readLink(await linkOf(whole, undefined, isMine)))?.added?.map(({garment}) => garment);
    const {sample} = design.garment;
    expect(await garmentsIn(false)).toEqual([
      {name: 'mine.json', sha256: sha256Of(mine.text)},
      {sample},
    ]);
    expect(await garmentsIn(true)).toEqual([mine, {sample}]);
  });

  it('carries a garment, a print and a name of its own', async () => {
    const link = await linkOf(own, 'Für Ada', true);
    expect(link.length).toBeLessThan(1500);
    expect(await readLink(link)).toEqual({...own, title: 'Für Ada'});
  });

  it('names a garment that it leaves out by its file and the hash of its text', async () => {
    const {garment: left} = (await readLink(await linkOf(own, undefined, false))) ?? {};
    expect(left).toEqual({name: own.garment.name, sha256: sha256Of(own.garment.text)});
  });

  it('carries how a picture of one’s own repeats, and that picture alone, of which the other is made', async () => {
    const tile = {image: 'data:image/png;base64,BBBB', repeat: 'halfDrop', turnedDeg: 90} as const;
    const {image: made, ...shown} = own.print;
    const read = await readLink(
      await linkOf({...own, print: {...own.print, tile}}, undefined, true),
    );
    expect(read?.print).toEqual({...shown, tile});
    expect(read?.print).not.toHaveProperty('image', made);
  });

  it('carries the picture of a sample that was redrawn', async () => {
    const image = 'data:image/png;base64,AAAA';
    const read = await readLink(
      await linkOf({...design, print: {...print, image}}, undefined, true),
    );
    expect(read?.print).toEqual({title: print.title, group, size, turnDeg, oneWay, cell, image});
  });

  const plain = (value: unknown): string =>
    `#design=${Buffer.from(JSON.stringify(value)).toString('base64url')}`;

  it('that was made before links were deflated can still be read', async () => {
    const early = {...samples, symmetries: []};
    expect(await readLink(plain({...early, symmetry: undefined, seed: undefined}))).toEqual({
      ...samples,
      ...{garment: {sample: garment.sample}, symmetry: 'none', seed: 1},
    });
  });

  it.each(['', '#top', '#projects'])('is not meant by %j', async (fragment) => {
    expect(await readLink(fragment)).toBeUndefined();
  });

  const packed = (text: string | Buffer): string =>
    `#project=${deflateRawSync(text).toString('base64url')}`;
  const changed = (change: object): string => packed(JSON.stringify({...written(own), ...change}));

  it.each([
    ['no base64', '#design=%%%'],
    ['no base64 either', '#project=%%%'],
    ['nothing', '#project='],
    ['no deflated text', '#project=AAAA'],
    ['no UTF-8', packed(Buffer.from([0x22, 0xff, 0x22]))],
    ['no JSON', packed('{')],
    ['no design', packed('{"garment": 1}')],
    ['null', packed('null')],
    ['a plain null', plain(null)],
    ['a path for a style', plain({...written(samples), garment: {style: '../x', size: 'm'}})],
    ['a garment without a text', changed({garment: {name: 'x.json'}})],
    ['a picture of another host', changed({print: {...own.print, image: 'https://x.org/a.png'}})],
    ['a picture that is a sample’s', changed({print: {...own.print, image: 'prints/cm.svg'}})],
    ['an endless repeat', changed({print: {...own.print, size: {...size, width: 1e9}}})],
    ['an endless name', changed({title: 'x'.repeat(1000)})],
    ['endlessly much', `#project=${'A'.repeat(300_000)}`],
    ['a text that unfolds to endlessly much', packed(' '.repeat(20_000_000))],
  ])('is refused when it holds %s', async (_, fragment) => {
    await expect(readLink(fragment)).rejects.toThrow(LinkError);
  });

  it('is refused when it was cut anywhere', async () => {
    const link = await linkOf(own, undefined, true);
    for (let length = '#project='.length; length < link.length; length += 7) {
      await expect(readLink(link.slice(0, length))).rejects.toThrow(LinkError);
    }
  });
});

describe('the name of a project', () => {
  it('is that of its garment’s file, or of a sample and its size', () => {
    expect(nameOf({name: 'Jacke_v2.json'})).toBe('Jacke_v2');
    expect(nameOf({name: 'hoody.seamwise.json'})).toBe('hoody');
    expect(nameOf(design.garment)).toBe('Tee, M');
    const sample = {style: 'six-gore-skirt', size: 'xs'};
    expect(nameOf({name: 'six-gore-skirt-xs.json', sample})).toBe('Six gore skirt, XS');
  });

  it('makes a file’s name on any system', () => {
    expect(fileNameOf('Für Ada: 1/2 "rot"')).toBe('Für Ada 1 2 rot');
    expect(fileNameOf('..')).toBe('garment');
    expect(fileNameOf('')).toBe('garment');
  });
});

describe('the name of a drawing', () => {
  it.each([
    ['tee-m.gerber.dxf', 'tee-m.gerber.dxf', 'tee-m'],
    ['Summer tee', 'tee.dxf', 'Summer tee'],
    ['Blouse No. 5', 'blouse.dxf', 'Blouse No. 5'],
    ['dress_pencil_specifi', 'in/dress_pencil_specification.clo.dxf', 'dress_pencil_specification'],
    ['dress', 'dress_pencil.dxf', 'dress'],
  ])('%s in %s is %s', (stated, file, title) => {
    expect(drawingTitle(stated, file)).toBe(title);
  });

  it('ends in an ellipsis where it is too long', () => {
    expect(shortened('Summer tee', 10)).toBe('Summer tee');
    expect(shortened('Summer tees', 10)).toBe('Summer te…');
  });
});
