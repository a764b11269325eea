import {describe, expect, it} from 'vitest';

import type {Design} from '../../web/src/model/design.js';
import {linkOf, readLink} from '../../web/src/model/link.js';
import {FileError, isProject, readProject, writeProject} from '../../web/src/model/project.js';

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
  symmetries: [
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
};
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
  });

  it('may hold a garment and a picture of its own', () => {
    const own: Design = {
      ...design,
      garment: {name: 'mine.json', text: '{}'},
      print: {...design.print, image: 'data:image/png;base64,AAAA'},
    };
    expect(readProject(writeProject(own), 'x').design).toEqual(own);
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
    ['design.options.maxChangeCm', -1],
    ['design.options.grain.default', 'off'],
    ['design.options.unmatched', [1.5]],
    ['design.options.pins.front.angle', 'left'],
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
  const link = linkOf(design) ?? '';

  it('holds all of a design of samples but the samples', () => {
    expect(link).toMatch(/^#design=[\w-]+$/);
    const {garment, print, symmetries, method, options} = design;
    const {group, size, turnDeg, oneWay, cell, sample} = print;
    expect(readLink(link)).toEqual({
      garment: garment.sample,
      print: {group, size, turnDeg, oneWay, cell, sample},
      ...{symmetries, method, options},
    });
  });

  it('keeps words of any language', () => {
    const print = {...design.print, sample: {name: 'cm', colourway: 'Größe 茶'}};
    expect(readLink(linkOf({...design, print}) ?? '')?.print.sample.colourway).toBe('Größe 茶');
  });

  it('is not made of files of the user', () => {
    const garment = {name: 'mine.json', text: '{}'};
    expect(linkOf({...design, garment})).toBeUndefined();
    const {title, image, group, size, turnDeg, oneWay, cell} = design.print;
    const print = {title, image, group, size, turnDeg, oneWay, cell};
    expect(linkOf({...design, print})).toBeUndefined();
  });

  const withText = (text: string): string => `#design=${Buffer.from(text).toString('base64url')}`;

  it.each([
    ['nothing', ''],
    ['another fragment', '#top'],
    ['no base64', '#design=%%%'],
    ['half a link', link.slice(0, link.length / 2)],
    ['no UTF-8', `#design=${Buffer.from([0x22, 0xff, 0x22]).toString('base64url')}`],
    ['no design', withText('{"garment": 1}')],
    ['null', withText('null')],
    [
      'a path for a style',
      withText(JSON.stringify({...readLink(link), garment: {style: '../x', size: 'm'}})),
    ],
    ['endlessly much', `#design=${'A'.repeat(300_000)}`],
  ])('is undefined of %s', (_, fragment) => {
    expect(readLink(fragment)).toBeUndefined();
  });
});
