/** Patterns as DXF in the styles of eight programs, all with the same pieces. */
import {cross, middle, minus, type Point} from '@/model/geometry/vectors.js';
import {signedArea} from '@/model/geometry/polyline.js';
import {alongLine, at} from '../plane.js';

/** A piece to write, in cm. */
export interface PatternPiece {
  readonly name: string;
  /** Each from corner to corner, dense enough to represent the curve. */
  readonly edges: readonly (readonly Point[])[];
  readonly notches?: readonly Point[];
  readonly grain?: readonly [Point, Point];
  /** Lines with text beside them, such as those of tucks. */
  readonly labelled?: readonly {
    readonly line: readonly [Point, Point];
    readonly text: string;
    /** Default 8, that of internal lines. */
    readonly layer?: string;
  }[];
  /** Further entities of the block, as pairs. */
  readonly more?: readonly string[];
  readonly quantity?: string;
}

export interface Habits {
  /** Units of the file in a cm. */
  readonly perCm: number;
  readonly header?: readonly string[];
  /** System text of the style; `capitals` writes its identifiers in upper case. */
  readonly style?: readonly string[];
  readonly capitals?: boolean;
  /**
   * Format of outlines: one polyline, flagged as closed or not, its start repeated or not; or many
   * lines.
   */
  readonly boundary: 'flagged' | 'repeated' | 'unflagged' | 'open' | 'segments' | 'light';
  readonly clockwise?: boolean;
  /** Steps of a curved edge; by default all its points. */
  readonly steps?: number;
  readonly turnPoints?: boolean;
  /** Layer 84: corners alone, or all points where layer 1 has key points. */
  readonly check?: 'corners' | 'dense';
  readonly notchLayer?: string;
  /** Names of the blocks: those of their pieces, all the same, or none. */
  readonly blocks: 'own' | 'alike' | 'none';
  /** True if blocks are drawn elsewhere and inserted at their place. */
  readonly isMoved?: boolean;
  /** Scale of each size; the one with 1 is the sample size. */
  readonly sizes?: Readonly<Record<string, number>>;
  readonly lineEnd?: string;
}

const metric = ['Units: METRIC', 'Sample Size: M'];

export const habits = {
  browzwear: {
    ...{perCm: 10, style: ['Author: Browzwear Solutions Pte Ltd', ...metric], capitals: true},
    ...{boundary: 'repeated', clockwise: true, turnPoints: true, blocks: 'own', isMoved: true},
  },
  clo: {
    ...{perCm: 1, style: ['Author: CLO Virtual Fashion Inc.', ...metric], capitals: true},
    ...{boundary: 'flagged', turnPoints: true, check: 'corners', blocks: 'own'},
  },
  flat: {
    ...{perCm: 10, header: ['9', '$INSUNITS', '70', '4'], boundary: 'light', blocks: 'none'},
    lineEnd: '\n',
  },
  gerber: {
    ...{
      perCm: 1 / 2.54,
      style: ['Author: GERBER TECHNOLOGY;AccuMark;10.0.1', 'Units: ENGLISH', 'Sample Size: 36'],
    },
    ...{boundary: 'open', clockwise: true, steps: 12, turnPoints: true, blocks: 'own'},
    sizes: {34: 0.97, 36: 1, 38: 1.03},
  },
  optitex: {
    ...{perCm: 1 / 2.54, header: ['9', '$INSUNITS', '70', '6']},
    ...{style: ['Author: Optitex', 'Units: ENGLISH', 'Sample Size: M']},
    ...{boundary: 'repeated', clockwise: true, turnPoints: true, blocks: 'own'},
  },
  polypattern: {
    ...{perCm: 10, style: ['Author: PolyPattern', 'Units: Metric', 'Sample Size: M']},
    ...{boundary: 'unflagged', turnPoints: true, blocks: 'own'},
  },
  richpeace: {
    ...{
      perCm: 1 / 2.54,
      style: ['Author: RICHPEACE TECHNOLOGY', 'Units: ENGLISH', 'Sample Size: M'],
    },
    ...{boundary: 'repeated', clockwise: true, steps: 8, turnPoints: true, notchLayer: '80'},
    blocks: 'own',
  },
  valentina: {perCm: 10, boundary: 'repeated', clockwise: true, blocks: 'alike', lineEnd: '\n'},
} as const satisfies Readonly<Record<string, Habits>>;

type Pairs = string[];

const pair = (code: number | string, value: number | string): [string, string] => [
  String(code).padStart(3),
  typeof value === 'number' ? value.toFixed(6) : value,
];

/** A file of these pieces. */
export function dxfOf(pieces: readonly PatternPiece[], how: Habits): string {
  const sizes = Object.entries(how.sizes ?? {M: 1});
  const blocks = pieces.flatMap((piece, k) =>
    sizes.map(([size, by]) => blockOf(piece, k, size, by, how)),
  );
  const flat = how.blocks === 'none';
  const lines: Pairs = [
    ...section('HEADER', how.header ?? []),
    ...(flat
      ? []
      : section(
          'BLOCKS',
          blocks.flatMap(({block}) => block),
        )),
    ...section(
      'ENTITIES',
      flat
        ? blocks.flatMap(({entities}) => entities)
        : [
            ...(how.style ?? []).flatMap((words) => text(spelt(words, how))),
            ...blocks.flatMap(({insert}) => insert),
          ],
    ),
    ...pair(0, 'EOF'),
  ];
  const end = how.lineEnd ?? '\r\n';
  return lines.join(end) + end;
}

const section = (name: string, content: readonly string[]): Pairs => [
  ...pair(0, 'SECTION'),
  ...pair(2, name),
  ...content,
  ...pair(0, 'ENDSEC'),
];

const text = (words: string, layer = '1', [x, y]: Point = [0, 0]): Pairs => [
  ...pair(0, 'TEXT'),
  ...pair(8, layer),
  ...pair(10, x),
  ...pair(20, y),
  ...pair(40, 1),
  ...pair(1, words),
];

const spelt = (words: string, {capitals}: Habits): string =>
  capitals ? words.replace(/^[^:]+/, (name) => name.toUpperCase()) : words;

interface Written {
  readonly block: Pairs;
  readonly insert: Pairs;
  readonly entities: Pairs;
}

function blockOf(
  {name, edges, notches = [], grain, labelled = [], more = [], quantity = '1'}: PatternPiece,
  number: number,
  size: string,
  by: number,
  how: Habits,
): Written {
  const offset: Point =
    how.isMoved && how.blocks !== 'none' ? [-137 * number, -55 * number] : [0, 0];
  const place = ([x, y]: Point): Point => [
    x * by * how.perCm + offset[0],
    y * by * how.perCm + offset[1],
  ];
  const isTurned = (how.clockwise ?? false) === signedArea(edges.flat()) > 0;
  const drawn = edges.map((edge) => edge.map(place));
  const turned = isTurned ? drawn.map((edge) => edge.toReversed()).toReversed() : drawn;
  const keyed = turned.map((edge) => (how.steps === undefined ? edge : keysOf(edge, how.steps)));
  const isSample = by === 1;
  const blockName = how.blocks === 'alike' ? 'DETAIL' : `${name}_${size}`;
  const words =
    how.style === undefined
      ? text(name, '15')
      : [
          ...text(spelt(`Piece Name: ${name}`, how)),
          ...text(spelt(`Size: ${size}`, how)),
          ...(isSample ? text(spelt(`Quantity: ${quantity}`, how)) : []),
        ];
  const entities = [
    ...boundaryOf(keyed, how),
    ...(how.check
      ? polyline(how.check === 'dense' ? ring(turned) : turned.map((edge) => at(edge, 0)), '84', 1)
      : []),
    ...(how.turnPoints && isSample ? keyed.flatMap((edge) => point(at(edge, 0), '2')) : []),
    ...(how.turnPoints && isSample
      ? keyed.flatMap((edge) => edge.slice(1, -1).flatMap((p) => point(p, '3')))
      : []),
    ...(isSample ? notches.flatMap((p) => point(place(p), how.notchLayer ?? '4')) : []),
    ...(grain && isSample ? segment([place(grain[0]), place(grain[1])], '7') : []),
    ...(isSample
      ? labelled.flatMap(({line: [from, to], text: words, layer = '8'}) => [
          ...segment([place(from), place(to)], layer),
          ...text(words, '8', place(middle(from, to))),
        ])
      : []),
  ];
  return {
    block: [
      ...pair(0, 'BLOCK'),
      ...pair(8, '1'),
      ...pair(2, blockName),
      ...pair(70, '0'),
      ...pair(10, 0),
      ...pair(20, 0),
      ...words,
      ...entities,
      ...more,
      ...pair(0, 'ENDBLK'),
    ],
    insert: [
      ...pair(0, 'INSERT'),
      ...pair(8, '1'),
      ...pair(2, blockName),
      ...pair(10, 0 - offset[0]),
      ...pair(20, 0 - offset[1]),
    ],
    entities: boundaryOf(keyed, how),
  };
}

/** Reduces a curve to key points; straight edges stay lines between two points. */
function keysOf(edge: readonly Point[], steps: number): Point[] {
  const [first, last] = [at(edge, 0), at(edge, -1)];
  const way = minus(last, first);
  const isStraight = edge.every(
    (p) => Math.abs(cross(way, minus(p, first))) < 1e-6 * Math.hypot(...way),
  );
  if (isStraight) return [first, last];
  const count = edge.length - 1;
  return Array.from({length: steps + 1}, (_, k) => at(edge, Math.round((k / steps) * count)));
}

const ring = (edges: readonly (readonly Point[])[]): Point[] =>
  edges.flatMap((edge) => edge.slice(0, -1));

function boundaryOf(edges: readonly (readonly Point[])[], {boundary}: Habits): Pairs {
  const loop = ring(edges);
  const closed = [...loop, at(loop, 0)];
  switch (boundary) {
    case 'flagged':
      return polyline(loop, '1', 1);
    case 'repeated':
      return polyline(closed, '1', 1);
    case 'unflagged':
      return polyline(closed, '1', 0);
    case 'open':
      return edges.flatMap((edge) => polyline(edge, '1', 0));
    case 'segments':
      return alongLine(closed).flatMap((ends) => segment(ends, '1'));
    case 'light':
      return [
        ...pair(0, 'LWPOLYLINE'),
        ...pair(100, 'AcDbEntity'),
        ...pair(8, '0'),
        ...pair(100, 'AcDbPolyline'),
        ...pair(90, String(loop.length)),
        ...pair(70, '1'),
        ...loop.flatMap(([x, y]) => [...pair(10, x), ...pair(20, y)]),
      ];
  }
}

export const polyline = (points: readonly Point[], layer: string, flag: 0 | 1): Pairs => [
  ...pair(0, 'POLYLINE'),
  ...pair(8, layer),
  ...pair(66, '1'),
  ...pair(70, String(flag)),
  ...points.flatMap(([x, y]) => [
    ...pair(0, 'VERTEX'),
    ...pair(8, layer),
    ...pair(10, x),
    ...pair(20, y),
  ]),
  ...pair(0, 'SEQEND'),
];

const point = ([x, y]: Point, layer: string): Pairs => [
  ...pair(0, 'POINT'),
  ...pair(8, layer),
  ...pair(10, x),
  ...pair(20, y),
];

export const segment = ([[ax, ay], [bx, by]]: readonly [Point, Point], layer: string): Pairs => [
  ...pair(0, 'LINE'),
  ...pair(8, layer),
  ...pair(10, ax),
  ...pair(20, ay),
  ...pair(11, bx),
  ...pair(21, by),
];

/** A rectangle with one curved side. */
export const bowedSquare = (name: string, side: number, [x, y]: Point = [0, 0]): PatternPiece => {
  const corners: Point[] = [
    [x, y],
    [x + side, y],
    [x + side, y + side],
    [x, y + side],
  ];
  const top = Array.from({length: 61}, (_, k): Point => {
    const t = k / 60;
    return [x + side * (1 - t), y + side + 0.6 * side * t * (1 - t)];
  });
  return {
    name,
    edges: [corners.slice(0, 2), corners.slice(1, 3), top, [at(corners, 3), at(corners, 0)]],
    grain: [middle(at(corners, 0), at(corners, 1)), middle(at(corners, 2), at(corners, 3))],
  };
};
