import {describe, expect, it} from 'vitest';

import {draftedSheet} from '@/cutting/drafted-sheet.js';
import {cutSheet} from '@/cutting/lay-sheet.js';
import {sheetDxf} from '@/cutting/out/sheet-dxf.js';
import type {CutSheet} from '@/cutting/cut-sheet.js';
import {sheetHpgl} from '@/cutting/out/sheet-hpgl.js';
import {readDxf} from '@/files/dxf/read-dxf.js';
import {hpglText} from '@/files/hpgl/hpgl.js';
import type {DraftedEdge, GarmentPiece} from '@/model/garment/garment-document.js';
import {panelMarks} from '@/model/garment/panel-marks.js';
import {lengthOf} from '@/model/geometry/polyline.js';
import {distance, type Point} from '@/model/geometry/vectors.js';
import type {Pattern} from '@/model/result/result.js';
import {documentOf} from '../../support/garments/documents.js';
import {plainPrint, squarePair, squarePiece} from '../../support/garments/two-squares.js';

const side = 30;
const box: readonly Point[] = [
  [0, 0],
  [side, 0],
  [side, side],
  [0, side],
];
const outline = box.map((from, k): DraftedEdge => ({points: [from, box[(k + 1) % 4] ?? from]}));

const drafted = (name: string, more: Partial<GarmentPiece> = {}): GarmentPiece => ({
  ...{name, mirroredFromInput: false, outline, holes: [], internalLines: []},
  ...more,
});

const garment = documentOf(
  [
    drafted('Vorderteil für Übergröße', {
      internalLines: [
        [
          [5, 5],
          [5, 15],
        ],
      ],
      drillHoles: [[10, 10]],
      quantity: 2,
    }),
    drafted('Перед'),
  ],
  {title: 'Tie', size: 'M'},
);

const pattern: Pattern = squarePair({
  pieces: garment.pieces.map(({name}, k) =>
    squarePiece(name, {
      ...{rest: box, shape: box},
      alignment: {angle: 0, translation: [k === 0 ? 0 : -side, 0]},
    }),
  ),
});

const sheet = cutSheet(
  pattern,
  {...plainPrint, title: 'Dots'},
  {title: 'Tie', size: 'M', panels: panelMarks(garment)},
  {allowanceCm: 1, units: 'cm'},
);

interface Entity {
  readonly type: string;
  readonly layer: string;
  readonly values: readonly (readonly [string, string])[];
}

/** Entities of every block. */
function blocksOf(dxf: string): ReadonlyMap<string, readonly Entity[]> {
  const lines = dxf.split('\r\n');
  const pairs = lines
    .slice(0, -1)
    .flatMap((code, k) => (k % 2 === 0 ? [[code.trim(), lines[k + 1] ?? ''] as const] : []));
  const blocks = new Map<string, Entity[]>();
  let current: Entity[] | undefined;
  let entity: {type: string; layer: string; values: [string, string][]} | undefined;
  for (const [code, value] of pairs) {
    if (code === '0') {
      if (value === 'ENDBLK') current = undefined;
      entity = {type: value, layer: '', values: []};
      current?.push(entity);
    } else if (code === '2' && entity?.type === 'BLOCK') blocks.set(value, (current = []));
    else if (code === '8' && entity) entity.layer = value;
    else entity?.values.push([code, value]);
  }
  return blocks;
}

const number = ({values}: Entity, code: string): number =>
  Number(values.find(([one]) => one === code)?.[1]);
const on = (entities: readonly Entity[] = [], layer: number, type: string): Entity[] =>
  entities.filter((one) => one.layer === String(layer) && one.type === type);
const texts = (entities: readonly Entity[] = []): string[] =>
  entities.flatMap(({type, values}) =>
    type === 'TEXT' ? values.flatMap(([code, value]) => (code === '1' ? [value] : [])) : [],
  );
/** Width and height of entities. [cm] */
const box2 = (entities: readonly Entity[]): number[] => {
  const xs = entities.map((one) => number(one, '10') / 10);
  const ys = entities.map((one) => number(one, '20') / 10);
  return [Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys)];
};

describe('DXF of pieces to cut', () => {
  const dxf = sheetDxf(sheet, {date: new Date('2026-03-21T00:00:00Z')});
  const blocks = blocksOf(dxf);
  const [front, other] = [...blocks.values()];

  it('is of seven bits, without tables, with a block per piece', () => {
    expect(dxf).not.toMatch(/[^\r\n\u0020-\u007e]/);
    expect(dxf).not.toContain('TABLES');
    expect([...blocks.keys()]).toEqual(['Vorderteil_fur_Ubergrosse', 'piece_2']);
    expect(dxf.endsWith('  0\r\nEOF\r\n')).toBe(true);
  });

  it('has the cut line on layer 1, closed, in millimetres, and the sewn one on 14', () => {
    const boundary = on(front, 1, 'POLYLINE');
    expect(boundary).toHaveLength(1);
    expect(boundary.map((one) => number(one, '70'))).toEqual([1]);
    box2(on(front, 1, 'VERTEX')).forEach((length) => {
      expect(length).toBeCloseTo(side + 2, 3);
    });
    box2(on(front, 14, 'VERTEX')).forEach((length) => {
      expect(length).toBeCloseTo(side, 3);
    });
    expect(on(front, 84, 'VERTEX')).toHaveLength(on(front, 1, 'VERTEX').length);
    const asSewn = [...blocksOf(sheetDxf(sheet, {sewAsBoundary: true})).values()][0];
    box2(on(asSewn, 1, 'VERTEX')).forEach((length) => {
      expect(length).toBeCloseTo(side, 3);
    });
    box2(on(asSewn, 14, 'VERTEX')).forEach((length) => {
      expect(length).toBeCloseTo(side + 2, 3);
    });
  });

  it('marks corners on layer 2, of both lines', () => {
    expect(on(front, 2, 'POINT')).toHaveLength(8);
  });

  it('puts notches on the cut line, with their depth and the way into the piece', () => {
    const [notch] = on(front, 4, 'POINT');
    // the seam along the right side is 30 cm long
    expect(notch && number(notch, '30')).toBeCloseTo(4, 6);
    expect(notch && number(notch, '50')).toBeCloseTo(180, 6);
    const right = Math.max(...on(front, 1, 'VERTEX').map((one) => number(one, '10')));
    expect(notch && number(notch, '10')).toBeCloseTo(right, 3);
  });

  it('has lines of the print as lines, and drill holes as points: no polyline on those layers', () => {
    for (const layer of [9, 10, 7]) expect(on(front, layer, 'LINE')).toHaveLength(1);
    expect(on(front, 13, 'POINT')).toHaveLength(1);
    for (const layer of [5, 6, 7, 9, 10, 13]) expect(on(front, layer, 'POLYLINE')).toEqual([]);
    expect(on(front, 8, 'POLYLINE')).toHaveLength(1);
  });

  it('says what pieces are', () => {
    expect(texts(front)).toContain('Piece Name: Vorderteil fur Ubergrosse');
    expect(texts(front)).toContain('Quantity: 2,0');
    expect(texts(other)).toContain('Size: M');
    expect(dxf).toContain('Units: METRIC');
    expect(dxf).toContain('Creation Date: 21-03-2026');
  });

  it('has pieces of a garment without a print as drafted, curves to 0.02 mm', () => {
    const round: DraftedEdge = {
      points: [
        [side, 0],
        [side + 20, 10],
        [side + 20, 20],
        [side, side],
      ],
    };
    const curved = outline.map((edge, k) => (k === 1 ? round : edge));
    const made = draftedSheet(documentOf([drafted('front', {outline: curved})]), {
      ...{allowanceCm: 0, units: 'cm'},
    });
    const [entities] = [...blocksOf(sheetDxf(made)).values()];
    expect(on(entities, 14, 'POLYLINE')).toEqual([]);
    expect(on(entities, 2, 'POINT')).toHaveLength(4);
    const line = on(entities, 1, 'VERTEX').map((one): Point => [
      number(one, '10') / 10,
      number(one, '20') / 10,
    ]);
    const [left, low] = [0, 1].map((axis) => Math.min(...line.map((p) => p[axis] ?? 0)));
    // the middle of the curve, by de Casteljau: 3/8 of 10 + 3/8 of 20 + 1/8 of 30 up, 3/4 of 20
    // aside
    const middle: Point = [(left ?? 0) + side + 15, (low ?? 0) + 15];
    const nearest = [...line].sort((p, q) => distance(p, middle) - distance(q, middle)).slice(0, 2);
    for (const p of nearest) expect(Math.abs(p[0] - middle[0])).toBeLessThan(0.05);
    expect(Math.max(...nearest.map((p) => p[0]))).toBeGreaterThan(middle[0] - 0.002);
  });
});

describe('DXF of other formats', () => {
  const format = {style: 'astm', unit: 'in'} as const;
  const [front] = [...blocksOf(sheetDxf(sheet, format)).values()];

  it('is in inches, and says so', () => {
    box2(on(front, 1, 'VERTEX')).forEach((length) => {
      expect(length).toBeCloseTo((side + 2) / 25.4, 4);
    });
    expect(sheetDxf(sheet, format)).toContain('Units: ENGLISH');
  });

  it('has validation copies of all lines in ASTM', () => {
    for (const [layer, copy] of [
      [1, 84],
      [8, 85],
      [14, 87],
    ] as const) {
      expect(on(front, copy, 'VERTEX')).toHaveLength(on(front, layer, 'VERTEX').length);
    }
  });

  it('nests sizes as blocks of one piece name, without overlap', () => {
    const larger: CutSheet = {...sheet, size: 'XL'};
    const nest = sheetDxf(sheet, {otherSizes: [larger]});
    const names = ['Vorderteil_fur_Ubergrosse', 'piece_2'];
    expect([...blocksOf(nest).keys()]).toEqual(
      ['M', 'XL'].flatMap((size) => names.map((name) => `${name}_${size}`)),
    );
    const bytes = new TextEncoder().encode(nest);
    const heights = ['M', 'XL'].map((size) => {
      const {sizes, sampleSize, pieces} = readDxf(bytes, 'nest.dxf', {size});
      expect({sizes, sampleSize}).toEqual({sizes: ['M', 'XL'], sampleSize: 'M'});
      expect(pieces).toHaveLength(2);
      return pieces.flatMap(({cut = []}) => cut.map(({start: [, y]}) => y / 10));
    });
    expect(Math.max(...(heights[0] ?? []))).toBeLessThan(Math.min(...(heights[1] ?? [])));
  });
});

/** The pen's lines by frame, and the size of the frames. [cm] */
function framesOf(plt: string) {
  const [, length = NaN] = /PS(\d+);/.exec(plt) ?? [];
  const lines = plt
    .split('FR;')
    .map((frame) =>
      [...frame.matchAll(/PU;PA(.*?)PU;/g)].map(([, line = '']) =>
        [...line.matchAll(/(-?\d+),(-?\d+)/g)].map(([, x, y]): Point => [
          Number(x) / 400,
          Number(y) / 400,
        ]),
      ),
    );
  return {length: Number(length) / 400, lines};
}

describe('HP-GL of a long plot', () => {
  const zigzag = Array.from({length: 12}, (_, k): Point => [k % 2 === 0 ? 0 : 120, 20 * k]);
  const plt = hpglText([{pen: 2, strokes: [{points: zigzag, isClosed: false}]}]);
  const {length, lines} = framesOf(plt);

  it('has frames along x, within the range of plotters', () => {
    expect(lines).toHaveLength(3);
    expect(length).toBe(80);
    for (const [x, y] of lines.flat(2)) {
      expect(x >= 0 && x <= length).toBe(true);
      expect(Math.abs(400 * y)).toBeLessThanOrEqual(32767);
    }
  });

  it('joins its frames to the same line, turned and not mirrored', () => {
    const joined = lines.flatMap((frame, k) =>
      frame.flatMap((line) => line.map(([x, y]): Point => [x + k * length, y])),
    );
    for (const [k, [x, y]] of zigzag.entries()) {
      const at: Point = [y, 60 - x];
      expect([k, Math.min(...joined.map((p) => distance(p, at)))]).toEqual([
        k,
        expect.closeTo(0, 2),
      ]);
    }
    const drawn = lines.flat().reduce((sum, line) => sum + lengthOf(line), 0);
    expect(drawn).toBeCloseTo(lengthOf(zigzag), 1);
  });

  it('is refused if it is too wide for any plotter', () => {
    const points: readonly Point[] = [
      [0, 0],
      [170, 180],
    ];
    expect(() => hpglText([{pen: 1, strokes: [{points, isClosed: true}]}])).toThrow(
      /170\.0 x 180\.0 cm, but HP-GL reaches 163\.8 cm/,
    );
  });
});

describe('files for cutters of a result that is not the sold one', () => {
  const mark = 'NOT AS IT WAS SOLD';

  it('say so on layer 15 of every piece in DXF, and beside the sheet', () => {
    const warnings = sheetDxf(sheet, {mark}).split('NOT AS IT WAS SOLD').length - 1;
    expect(warnings).toBe(sheet.pieces.length + 1);
    expect(sheetDxf(sheet, {mark})).toMatch(/TEXT\r?\n *8\r?\n15\r?\n[^T]*NOT AS IT WAS SOLD/);
  });

  it('say so by a label on every piece in HP-GL', () => {
    const labels = sheetHpgl(sheet, mark).split('LBNOT AS IT WAS SOLD\u0003').length - 1;
    expect(labels).toBe(sheet.pieces.length);
  });
});

describe('HP-GL of pieces to cut', () => {
  const plt = sheetHpgl(sheet);

  it('draws with pen 2 first and cuts with pen 1, 40 units a millimetre', () => {
    expect(plt.startsWith('IN;\nSP2;')).toBe(true);
    const cut = plt
      .slice(plt.indexOf('SP1;'))
      .split('\n')
      .filter((one) => one.startsWith('PU;PA'));
    expect(cut).toHaveLength(2);
    const points = [...(cut[0] ?? '').matchAll(/PA(-?\d+),(-?\d+);/g)].map(([, x, y]) => [
      Number(x),
      Number(y),
    ]);
    const xs = points.map(([x = 0]) => x);
    expect(Math.max(...xs) - Math.min(...xs)).toBe(400 * (side + 2));
    expect(points[0]).toEqual(points.at(-1));
    expect(plt.endsWith('SP0;\n')).toBe(true);
  });
});
