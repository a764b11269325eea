import {describe, expect, it} from 'vitest';

import {edgeLine} from '@/model/garment/edge-curve.js';
import {readDrawing} from '@/files/read-drawing.js';
import {defaultChoices, garmentOf} from '@/files/to-garment.js';
import type {Drawing} from '@/model/garment/imported-drawing.js';
import {signedArea} from '@/model/geometry/polyline.js';
import {FileError} from '@/model/base/versioned-file.js';
import {
  bowedSquare,
  dxfOf,
  habits,
  polyline,
  segment,
  type Habits,
} from '../../support/files/dxf-habits.js';
import {at, toLine} from '../../support/plane.js';

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);
const read = (text: string): Drawing => readDrawing(bytesOf(text), 'bad.dxf');

/** The error for a file; empty for a readable one. */
function complaint(text: string): string {
  try {
    read(text);
  } catch (error) {
    if (error instanceof FileError) return error.message;
    throw error;
  }
  return '';
}

const square = bowedSquare('front', 60);
const good = dxfOf([square, bowedSquare('back', 50)], habits.browzwear);

/** A file with these blocks and entities. */
const file = (blocks: readonly string[], entities: readonly string[] = []): string =>
  [
    ['0', 'SECTION', '2', 'BLOCKS'],
    blocks,
    ['0', 'ENDSEC', '0', 'SECTION', '2', 'ENTITIES'],
    entities,
    ['0', 'ENDSEC', '0', 'EOF'],
  ]
    .flat()
    .join('\n');

const block = (name: string, ...content: readonly string[]): string[] => [
  ...['0', 'BLOCK', '8', '1', '2', name, '10', '0', '20', '0', ...content, '0', 'ENDBLK'],
];

const insert = (name: string): string[] => [
  '0',
  'INSERT',
  '8',
  '1',
  '2',
  name,
  '10',
  '0',
  '20',
  '0',
];

const box = (layer = '1'): string[] =>
  polyline(
    [
      [0, 0],
      [600, 0],
      [600, 600],
      [0, 600],
    ],
    layer,
    1,
  );

describe('a file that is damaged', () => {
  it.each([
    ['a word for a number of a group', good.replace('  8', 'abc'), "line 13, which has 'abc'"],
    [
      'an end in the middle of a pair',
      good.slice(0, good.indexOf('VERTEX') - 1),
      'where it ends too early',
    ],
    ['no number', good.replace(/-?\d+\.\d{6}/, 'NaN'), "has 'NaN' where a length belongs"],
    ['an empty number', good.replace(/-?\d+\.\d{6}/, ''), "has '' where a length belongs"],
    ['1e300', good.replace(/-?\d+\.\d{6}/, '1e300'), "has '1e300' where a length belongs"],
    [
      'a bulge of 1e9',
      file(block('A', ...box().join('|').replace('VERTEX|', 'VERTEX|42|1e9|').split('|'))),
      'where a length belongs',
    ],
    [
      'a bulge of 1e6',
      file(block('A', ...box().join('|').replace('VERTEX|', 'VERTEX|42|1e6|').split('|'))),
      'bulge 1000000',
    ],
    [
      'a spline without control points',
      file(block('A', ...box(), '0', 'SPLINE', '8', '8', '71', '3')),
      'where a SPLINE has no control points',
    ],
    [
      'a line without an end',
      file(block('A', ...box(), '0', 'LINE', '8', '8', '10', '1', '20', '1')),
      'where a LINE lacks a number',
    ],
  ])('with %s is refused', (_, text, part) => {
    expect(complaint(text)).toContain(part);
    expect(complaint(text)).toMatch(/^bad\.dxf [^\n]*\.$/);
  });

  it.each([
    ['LF alone', good.replaceAll('\r\n', '\n')],
    ['CR alone', good.replaceAll('\r\n', '\r')],
    ['a mark of UTF-8', `\ufeff${good}`],
    ['empty lines at its end', `${good}\r\n\r\n\r\n`],
    ['commas for points', good.replaceAll(/(-?\d+)\.(\d{6})/g, '$1,$2')],
    ['a comment', `999\r\nwritten by hand\r\n${good}`],
  ])('with %s reads as it should', (_, text) => {
    expect(read(text).pieces).toEqual(read(good).pieces);
  });

  it('reads as UTF-16, too', () => {
    const bytes = new Uint8Array(2 * good.length + 2);
    const view = new DataView(bytes.buffer);
    const marked = `\ufeff${good}`;
    for (let k = 0; k < marked.length; k++) view.setUint16(2 * k, marked.charCodeAt(k), true);
    expect(readDrawing(bytes, 'bad.dxf').pieces).toEqual(read(good).pieces);
  });
});

describe('blocks', () => {
  it('may not be inserted in themselves', () => {
    const text = file(
      [...block('A', ...box(), ...insert('B')), ...block('B', ...insert('A'))],
      insert('A'),
    );
    expect(complaint(text)).toMatch(/block '[AB]' that is inserted in itself/);
  });

  it('that are missing are told of, and others opened', () => {
    const {pieces, notes} = read(file(block('A', ...box()), [...insert('A'), ...insert('gone')]));
    expect(pieces).toHaveLength(1);
    expect(notes.join()).toContain("'gone'");
  });

  it('hold others with their offset, scale and turn, four deep', () => {
    const nested = ['B', 'C', 'D', 'E'].flatMap((name, k, names) =>
      block(name, ...(names[k + 1] ? insert(names[k + 1] ?? '') : box('8'))),
    );
    const placed = [
      '0',
      'INSERT',
      '8',
      '1',
      '2',
      'B',
      '10',
      '50',
      '20',
      '0',
      '41',
      '0.5',
      '42',
      '0.5',
      '50',
      '90',
    ];
    const {pieces} = read(file([...block('A', ...box(), ...placed), ...nested], insert('A')));
    expect(pieces).toHaveLength(1);
    expect(pieces[0]?.internalLines[0]?.[1]?.map(Math.round)).toEqual([50, 300]);
  });

  it('deeper than that are left out and told of', () => {
    const names = ['B', 'C', 'D', 'E', 'F', 'G'];
    const nested = names.flatMap((name, k) =>
      block(name, ...(names[k + 1] ? insert(names[k + 1] ?? '') : box('8'))),
    );
    const {pieces, notes} = read(
      file([...block('A', ...box(), ...insert('B')), ...nested], insert('A')),
    );
    expect(pieces[0]?.internalLines).toHaveLength(0);
    expect(notes.join()).toContain('four levels');
  });

  it('that hold others many times over are not followed', () => {
    const names = ['B', 'C', 'D', 'E', 'F'];
    const nested = names.flatMap((name, k) =>
      block(
        name,
        ...names
          .slice(k + 1, k + 2)
          .flatMap((inner) => Array<string[]>(60).fill(insert(inner)).flat()),
      ),
    );
    expect(complaint(file([...block('A', ...box(), ...insert('B')), ...nested]))).toContain(
      'without end',
    );
  });

  it('of one name are one piece each', () => {
    const {pieces} = read(
      file([...block('A', ...box()), ...block('A', ...box())], [...insert('A'), ...insert('A')]),
    );
    expect(pieces).toHaveLength(2);
  });

  it('by thousands are no garment', () => {
    const text = file(Array.from({length: 10_000}, (_, k) => block(`p${k}`, ...box())).flat());
    expect(complaint(text)).toContain('10000 pieces');
  });
});

describe('what no garment has', () => {
  const many = (count: number, one: readonly string[]): string[] =>
    Array<readonly string[]>(count).fill(one).flat();
  const vertex = ['0', 'VERTEX', '8', '1', '10', '1', '20', '1'];
  const notch = ['0', 'POINT', '8', '4', '10', '1', '20', '0'];
  const cornered = ['0', 'LWPOLYLINE', ...many(100_001, ['10', '1', '20', '1'])];

  it.each([
    [
      'points of an outline',
      file([], ['0', 'POLYLINE'].concat(many(20_001, vertex))),
      'more points',
    ],
    ['points of one line', file([], cornered), 'has no end'],
    ['lines', file([], many(200_001, notch)), '200000 lines and points'],
    ['notches', file(block('A', ...box(), ...many(1001, notch))), '1001 notches'],
  ])('by its %s is refused', (_, dxf, part) => {
    expect(complaint(dxf)).toContain(part);
  });
});

describe('an outline', () => {
  const gapped = (from: number): string =>
    file(
      block(
        'A',
        ...['0', 'TEXT', '8', '1', '10', '0', '20', '0', '1', 'Piece Name: yoke'],
        ...polyline(
          [
            [0, from],
            [0, 600],
            [600, 600],
            [600, 0],
            [0, 0],
          ],
          '1',
          0,
        ),
      ),
    );

  it('that is open is told with its gap and the place', () => {
    expect(complaint(gapped(12.34))).toBe(
      "bad.dxf has a piece 'yoke' whose outline is open: 12.3 mm are missing between (0.0, 1.2) and (0.0, 0.0) cm; close it and export it again.",
    );
  });

  it('that is open by a hair is closed', () => {
    expect(read(gapped(0.1)).pieces).toHaveLength(1);
  });

  it('has to be there', () => {
    expect(complaint(file([]))).toContain('no closed outline');
    expect(
      complaint(
        file(
          [],
          segment(
            [
              [0, 0],
              [9, 9],
            ],
            '1',
          ),
        ),
      ),
    ).toContain('no closed outline');
  });
});

describe('sizes and units', () => {
  const nest: Habits = habits.gerber;

  it('takes the sample size, or the one that is asked for', () => {
    const text = bytesOf(dxfOf([square], nest));
    expect(readDrawing(text, 'nest.dxf')).toMatchObject({size: '36', sizes: ['34', '36', '38']});
    const large = readDrawing(text, 'nest.dxf', {size: '38'});
    expect(large.pieces).toHaveLength(1);
    expect(large.pieces[0]).toMatchObject({size: '38', quantity: {asDrawn: 1, mirrored: 0}});
  });

  it('names the sizes where there is no such', () => {
    const text = bytesOf(dxfOf([square], nest));
    expect(() => readDrawing(text, 'nest.dxf', {size: 'XL'})).toThrow(
      "nest.dxf has no size 'XL'; it has 34, 36, 38.",
    );
  });

  it.each([
    ['mm', 10, ['Units: METRIC'], true],
    ['cm', 1, ['Units: METRIC'], true],
    ['inch', 1 / 2.54, ['Units: ENGLISH'], true],
    ['mm', 10, [], true],
    ['cm', 1, [], false], // it fits a body in inches, too
    ['inch', 0.01, ['Units: ENGLISH'], false],
  ] as const)('tells %s at %d units a cm and %j', (unit, perCm, style, isSure) => {
    const {unit: guess} = read(
      dxfOf([square], {...habits.clo, perCm, style: [...style, 'Author: X']}),
    );
    expect(guess).toMatchObject({unit, isSure});
  });

  it('believes whoever opens it', () => {
    expect(readDrawing(bytesOf(good), 'x.dxf', {units: 'inch'}).unit).toMatchObject({
      unit: 'inch',
      isSure: true,
    });
  });
});

describe('pieces', () => {
  it('that are cut in pairs have a mirror image', () => {
    const {pieces, symmetries} = garment(dxfOf([{...square, quantity: '1,1'}], habits.clo));
    expect(pieces.map(({name}) => name)).toEqual(['front', 'front 2']);
    expect(symmetries).toEqual([{kind: 'pair', pieces: ['front', 'front 2']}]);
  });

  it('that are too small, or of lining, are left out and told of', () => {
    const lining = {...bowedSquare('pocket bag', 20), more: text('Material: LINING')};
    const drawing = read(dxfOf([square, lining, bowedSquare('loop', 1.5)], habits.clo));
    const {pieces, notes} = defaultChoices(drawing);
    expect(pieces.map(({take}) => take)).toEqual([true, false, false]);
    expect(notes).toEqual([
      "Piece 'pocket bag' is left out: its material is LINING.",
      "Piece 'loop' is left out: it has 2.5 cm2.",
    ]);
  });

  it('of one name are told apart', () => {
    const {pieces} = garment(dxfOf([square, {...square}], {...habits.clo, blocks: 'alike'}));
    expect(pieces.map(({name}) => name)).toEqual(['front', 'front 2']);
  });
});

const text = (words: string): string[] => ['0', 'TEXT', '8', '1', '10', '0', '20', '0', '1', words];

function garment(dxf: string) {
  const drawing = read(dxf);
  return garmentOf(drawing, defaultChoices(drawing));
}

describe('half pieces', () => {
  /** The right half of a piece, its fold along y, drawn as one polyline clockwise. */
  const half = (foldAt: number): string =>
    dxfOf(
      [
        {
          ...square,
          name: 'back',
          more: segment(
            [
              [foldAt, -20],
              [foldAt, 700],
            ],
            '6',
          ),
        },
      ],
      habits.polypattern,
    );

  it('are unfolded along the fold, which they keep as their symmetry', () => {
    const {pieces, symmetries} = garment(half(0));
    const line = (pieces[0]?.outline ?? []).flatMap((edge) => edgeLine(edge, 128).slice(0, -1));
    const whole = signedArea(line);
    const drawn = 60 * 60 + (0.6 * 60 * 60) / 6;
    expect(whole / drawn).toBeCloseTo(2, 3);
    expect(symmetries).toEqual([
      {
        kind: 'piece',
        piece: 'back',
        axis: [
          [0, -2],
          [0, 70],
        ],
      },
    ]);
    for (const [x, y] of line) expect(toLine([-x, y], [...line, at(line, 0)])).toBeLessThan(1e-3);
  });

  it('have one edge across the fold where it runs on smoothly', () => {
    const {pieces} = garment(half(0));
    // hem and top continue across the fold: hem, two sides and the top, which has a corner at its
    // curve
    expect(pieces[0]?.outline.map(({points}) => points.length)).toContain(2);
    expect(pieces[0]?.outline).toHaveLength(5);
  });

  it('whose fold is elsewhere are taken as they are, and told of', () => {
    const drawing = read(half(300));
    expect(defaultChoices(drawing).notes.join()).toContain(
      "fold of piece 'back' is not on its outline",
    );
    expect(garment(half(300)).symmetries).toEqual([]);
  });
});

describe('a flat file', () => {
  const square = (x: number, y: number, side: number, layer = '0'): string[] =>
    polyline(
      [
        [x, y],
        [x + side, y],
        [x + side, y + side],
        [x, y + side],
      ],
      layer,
      1,
    );

  it('has a piece for each closed line, but neither for small ones nor for the sheet around all', () => {
    const drawn = [
      ...square(-10, -10, 1000),
      ...square(0, 0, 400),
      ...square(500, 0, 300),
      ...square(20, 20, 30),
    ];
    const {pieces} = read(file([], drawn));
    expect(pieces.map(({internalLines}) => internalLines.length)).toEqual([1, 0]);
  });

  it('may be drawn by segments, the first of which begins at no corner', () => {
    const around = [
      [300, 0],
      [600, 0],
      [600, 600],
      [0, 600],
      [0, 0],
      [300, 0],
    ] as const;
    const lines = around.slice(1).flatMap((to, k) => segment([around[k] ?? to, to], '0'));
    const {pieces} = garment(file([], lines));
    expect(pieces.map(({outline}) => outline.map(({points}) => points.length))).toEqual([
      [2, 2, 2, 2],
    ]);
  });

  it('is sewn along a line that runs around inside another', () => {
    const {pieces} = garment(file([], [...square(0, 0, 400), ...square(10, 10, 380)]));
    expect(pieces).toHaveLength(1);
    expect(pieces[0]?.outline.map(({allowance}) => allowance?.width)).toEqual([1, 1, 1, 1]);
  });
});

it('tells of two styles, and of grade rules that lie elsewhere', () => {
  const words = ['Style Name: A', 'Style Name: B', 'Grade Rule Table: WOMEN'].flatMap(text);
  const {notes} = read(file(block('A', ...box()), words));
  expect(notes.join()).toMatch(/2 styles, A, B.*WOMEN, which is not read/);
});

describe('a sew line', () => {
  it('is the outline, and the boundary the cut line, each edge with its own allowance', () => {
    const sewn = [
      [10, 30],
      [590, 30],
      [590, 590],
      [10, 590],
    ] as const;
    const {pieces} = garment(file(block('A', ...box(), ...polyline(sewn, '14', 1))));
    const [piece] = pieces;
    expect(piece?.cutLine).toHaveLength(4);
    expect(piece?.outline.map(({allowance}) => allowance?.width)).toEqual([3, 1, 1, 1]);
  });
});
