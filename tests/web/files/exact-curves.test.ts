import {describe, expect, it} from 'vitest';

import {tracedLoop} from '@/files/base/bezier.js';
import {readDrawing} from '@/files/read-drawing.js';
import type {Drawing, DrawnPiece} from '@/model/garment/imported-drawing.js';
import type {Point} from '@/model/geometry/vectors.js';
import {boxOf, signedArea} from '@/model/geometry/polyline.js';
import {
  block,
  closedLine,
  drawnDxf,
  flap,
  insertion,
  millimetres,
  segments,
  text,
  type Entity,
} from '../../support/files/drawn-dxf.js';
import {at, greatest} from '../../support/plane.js';

const bytesOf = (content: string): Uint8Array => new TextEncoder().encode(content);
const read = (dxf: string): Drawing => readDrawing(bytesOf(dxf), 'plain.dxf');
const piece = (...entities: readonly Entity[]): DrawnPiece =>
  at(read(drawnDxf({entities})).pieces, 0);
const lineOf = ({sewn}: DrawnPiece): Point[] => tracedLoop(sewn, 1e-4);

/** Greatest difference from a circle. [mm] */
const offCircle = (line: readonly Point[], radius: number): number =>
  greatest(line.map(([x, y]) => Math.abs(Math.hypot(x, y) - radius)));

const spline = (
  degree: number,
  knots: readonly number[],
  controls: readonly Point[],
  weights: readonly number[] = [],
): Entity => [
  ...[0, 'SPLINE', 8, 0, 70, 0, 71, degree, 72, knots.length, 73, controls.length],
  ...knots.flatMap((knot) => [40, knot]),
  ...weights.flatMap((weight) => [41, weight]),
  ...controls.flatMap(([x, y]) => [10, x, 20, y]),
];

describe('curves of DXF', () => {
  it('are exact for a spline, whatever its number of knots', () => {
    const controls: Point[] = [
      [0, 0],
      [0, -1200],
      [1800, -1200],
      [1800, 0],
    ];
    const {sewn} = piece(
      spline(3, [0, 0, 0, 0, 1, 1, 1, 1], controls),
      ...segments([
        [1800, 0],
        [1800, 400],
        [0, 400],
        [0, 0],
      ]),
    );
    const curves = sewn.flatMap(({cubics}) => cubics);
    expect(curves).toHaveLength(4);
    expect(curves).toContainEqual([
      [0, -1200],
      [1800, -1200],
      [1800, 0],
    ]);
  });

  it('keep the radius of a rational spline', () => {
    const half = Math.SQRT1_2;
    const controls: Point[] = [
      ...([
        [1, 0],
        [1, 1],
        [0, 1],
        [-1, 1],
        [-1, 0],
      ] as const),
      ...([
        [-1, -1],
        [0, -1],
        [1, -1],
        [1, 0],
      ] as const),
    ].map(([x, y]) => [200 * x, 200 * y]);
    const circle = piece(
      spline(2, [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], controls, [
        ...[1, half, 1, half, 1, half, 1, half, 1],
      ]),
    );
    expect(offCircle(lineOf(circle), 200)).toBeLessThan(0.02);
  });

  it('keep the radius of arcs, of 1 m, too', () => {
    const circle = piece([0, 'CIRCLE', 8, 0, 10, 0, 20, 0, 40, 1000]);
    expect(offCircle(lineOf(circle), 1000)).toBeLessThan(0.02);
    const bulged = piece([
      0,
      'LWPOLYLINE',
      8,
      0,
      70,
      1,
      10,
      -500,
      20,
      0,
      42,
      1,
      10,
      500,
      20,
      0,
      42,
      1,
    ]);
    expect(offCircle(lineOf(bulged), 500)).toBeLessThan(0.02);
  });

  it('lie on the other side where an ellipse is seen from below', () => {
    const half = piece(
      [0, 'ELLIPSE', 8, 0, 10, 0, 20, 0, 11, 300, 21, 0, 230, -1, 40, 0.5, 41, 0, 42, Math.PI],
      ...segments([
        [-300, 0],
        [-300, 100],
        [300, 100],
        [300, 0],
      ]),
    );
    expect(Math.abs(signedArea(lineOf(half))) / 100).toBeCloseTo(600 + (Math.PI * 450) / 2, 0);
  });

  it('turn with an insertion that is seen from below', () => {
    const {pieces} = read(
      drawnDxf({
        blocks: [
          block(
            'A',
            closedLine([
              [0, 0],
              [400, 0],
              [400, 300],
              [100, 300],
              [0, 200],
            ]),
          ),
        ],
        entities: [insertion('A', [-1000, 0], [50, 90, 230, -1])],
      }),
    );
    const corners = at(pieces, 0).sewn.map(({start}) => start.map(Math.round));
    expect(corners).toContainEqual([1000, 400]);
    expect(corners).toContainEqual([1300, 100]);
    expect(corners).toContainEqual([1200, 0]);
  });
});

describe('units of DXF', () => {
  const inches = 28;
  const sized = (header: Entity, units: number): Drawing =>
    read(
      drawnDxf({
        header,
        entities: [closedLine(flap(0, 0).map(([x, y]) => [(x * units) / 400, (y * units) / 400]))],
      }),
    );

  it.each<[string, Entity, number, string, boolean]>([
    ['$INSUNITS 2', [9, '$INSUNITS', 70, 2], inches / 12, 'inch', true],
    ['$INSUNITS 14', [9, '$INSUNITS', 70, 14], inches * 0.254, 'cm', true],
    ['$LUNITS 4', [9, '$LUNITS', 70, 4], inches, 'inch', false],
    ['$MEASUREMENT 0', [9, '$MEASUREMENT', 70, 0], inches, 'inch', false],
    [
      '$MEASUREMENT 0, and nobody could wear it',
      [9, '$MEASUREMENT', 70, 0],
      inches * 25.4,
      'mm',
      true,
    ],
  ])('are read from %s', (_, header, units, unit, isSure) => {
    const drawing = sized(header, units);
    expect(drawing.unit).toMatchObject({unit, isSure});
    const perCm = {inch: 2.54, cm: 1, mm: 0.1}[unit] ?? 0;
    const {low, high} = boxOf(lineOf(at(drawing.pieces, 0)));
    expect((high[0] - low[0]) * perCm).toBeCloseTo(inches * 2.54, 4);
  });
});

describe('characters of DXF', () => {
  const named = (name: Uint8Array, page: string): string => {
    const [before = '', after = ''] = drawnDxf({
      header: [9, '$DWGCODEPAGE', 3, page, ...millimetres],
      blocks: [block('A', closedLine(flap(0, 0), 1), text('Piece Name: @', [50, 50], 1))],
      entities: [insertion('A')],
    }).split('@');
    const bytes = Uint8Array.from([...bytesOf(before), ...name, ...bytesOf(after)]);
    return at(readDrawing(bytes, 'named.dxf').pieces, 0).name;
  };

  it.each([
    ['dos850', [0x8e, 0x72, 0x6d, 0x65, 0x6c], 'Ärmel'],
    ['DOS437', [0x9a, 0x62, 0x65, 0x72], 'Über'],
    ['ANSI_1253', [0xcc, 0xd0], 'ΜΠ'],
    ['ANSI_1257', [0x50, 0xf0], 'Pš'],
    ['ANSI_874', [0xe0, 0xca], 'เส'],
    ['iso8859-7', [0xcc, 0xd0], 'ΜΠ'],
  ])('are those of code page %s', (page, bytes, name) => {
    expect(named(Uint8Array.from(bytes), page)).toBe(name);
  });

  it.each([
    ['%%uBACK%%u', 'BACK'],
    ['A%%196B', 'AÄB'],
    ['Turn 90%%d', 'Turn 90°'],
    [String.raw`\LUpper\l sleeve`, 'Upper sleeve'],
    [String.raw`Side\~front`, 'Side front'],
  ])('lack the formatting of %s', (written, name) => {
    expect(named(bytesOf(written), 'ANSI_1252')).toBe(name);
  });
});

describe('shapes of SVG', () => {
  const svg = (attributes: string, ...shapes: readonly string[]): Drawing =>
    readDrawing(
      bytesOf(`<svg xmlns="http://www.w3.org/2000/svg" ${attributes}>${shapes.join('')}</svg>`),
      'sheet.svg',
    );
  const sheet = 'width="1200mm" height="800mm" viewBox="0 0 1200 800"';
  const path = (d: string, more = 'fill="none" stroke="#000"'): string =>
    `<path d="${d}" ${more}/>`;
  const front = path('M650 50h400v500h-300z');
  const sizes = ({pieces}: Drawing): number[][] =>
    pieces.map((one) => {
      const {low, high} = boxOf(lineOf(one));
      return [high[0] - low[0], high[1] - low[1]].map((side) => Math.round(side));
    });

  it('may have sizes in per cent and in units', () => {
    const style = 'fill="none" stroke="#000"';
    expect(
      sizes(
        svg(
          sheet,
          `<rect x="5%" y="5%" width="25%" height="50%" ${style}/>`,
          `<rect x="600" y="40" width="4in" height="9in" ${style}/>`,
        ),
      ),
    ).toEqual([
      [300, 400],
      [384, 864],
    ]);
  });

  it('are stretched where the file says so', () => {
    const drawing = svg(
      'width="600mm" height="800mm" viewBox="0 0 600 400" preserveAspectRatio="none"',
      path('M50 50h400v200h-300z'),
    );
    expect(sizes(drawing)).toEqual([[400, 400]]);
  });

  it('are pieces only if they are painted', () => {
    const drawing = svg(
      sheet,
      front,
      path('M50 50h300v400h-300z', 'style="fill:none;stroke:none"'),
    );
    expect(sizes(drawing)).toEqual([[400, 500]]);
    expect(drawing.notes.join()).toContain('without stroke and fill');
  });

  it('have the pixels of their sheet of paper', () => {
    const side = (mm: number): number => (mm * 300) / 25.4;
    const drawing = svg(
      `viewBox="0 0 ${Math.round(side(1189))} ${Math.round(side(841))}"`,
      path(`M99 99h${side(400)}v${side(500)}h${-side(300)}z`),
    );
    expect(sizes(drawing)).toEqual([[400, 500]]);
  });

  it('of one path are holes by its fill rule', () => {
    const d = 'M50 50h400v500h-300z M250 200h100v150h-100z';
    const {pieces} = svg(sheet, path(d, 'fill="#ccc" fill-rule="evenodd"'));
    expect(pieces).toMatchObject([{holes: [expect.anything()]}]);
  });

  it('that are grids, or dashed and grey, are no pieces', () => {
    const cells = Array.from({length: 12}, (_, k) => path(`M${20 * k} 0h20v700h-20z`));
    const dashed = path(
      'M640 40h420v520h-420z',
      'fill="none" stroke="grey" stroke-dasharray="6,6"',
    );
    const drawing = svg(sheet, ...cells, front, dashed);
    expect(drawing.pieces.map(({doubt}) => doubt === undefined)).toEqual([true, false]);
    expect(drawing.notes).toContain('A grid of 12 closed lines is left out.');
  });
});

it('continues lines of OBJ after a backslash, and reads lines that end with CR', () => {
  const obj = [
    ...['v 0 0 0', 'v 0.4 0 0', 'v 0.4 0.6 0', 'v 0 0.6 0'],
    ...['vt 0 0', 'vt 0.4 0', 'vt 0.4 0.6', 'vt 0 0.6'],
    'f 1/1 2/2 \\',
    '3/3 4/4',
  ];
  for (const end of ['\n', '\r\n', '\r']) {
    expect(readDrawing(bytesOf(obj.join(end)), 'a.obj').pieces).toHaveLength(1);
  }
});
