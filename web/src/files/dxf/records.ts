/**
 * Records of DXF R12 in millimetres: pairs of a group code and a value, one line each. Coordinates
 * have four decimal places.
 */
import type {Point} from '../../model/geometry/vectors.js';

/** Line ending of CAD programs. */
const lineEnd = '\r\n';
/** Height of text, which readers ignore. [mm] */
const textHeight = 5;

export type Pair = readonly [code: number, value: string | number];

/** Converts centimetres to millimetres without redundant digits. */
const mm = (cm: number): string => String(Number((10 * cm).toFixed(4)) + 0);

/** The text in 7-bit ASCII: letters without accents, and a question mark for all others. */
export function plainText(text: string): string {
  const written: Readonly<Record<string, string>> = {
    ß: 'ss',
    æ: 'ae',
    Æ: 'AE',
    ø: 'o',
    Ø: 'O',
    œ: 'oe',
    ł: 'l',
    Ł: 'L',
    '×': 'x',
    '°': ' deg',
    '–': '-',
    '—': '-',
    '’': "'",
    '\u00a0': ' ',
  };
  return text
    .replace(/[^\u0020-\u007e]/gu, (letter) => written[letter] ?? letter)
    .normalize('NFKD')
    .replace(/[\u0300-\u036f]/gu, '')
    .replace(/[^\u0020-\u007e]/gu, '?');
}

const at = ([x, y]: Point): readonly Pair[] => [
  [10, mm(x)],
  [20, mm(y)],
];

/**
 * A point.
 * @param more further pairs, such as a notch's depth and angle
 */
export const point = (layer: number, p: Point, more: readonly Pair[] = []): readonly Pair[] => [
  [0, 'POINT'],
  [8, layer],
  ...at(p),
  ...more,
];

export const line = (layer: number, [from, to]: readonly [Point, Point]): readonly Pair[] => [
  [0, 'LINE'],
  [8, layer],
  ...at(from),
  [11, mm(to[0])],
  [21, mm(to[1])],
];

/** @param colour AutoCAD colour index; that of the layer when omitted */
export const polyline = (
  layer: number,
  points: readonly Point[],
  isClosed: boolean,
  colour?: number,
): readonly Pair[] => [
  [0, 'POLYLINE'],
  [8, layer],
  ...(colour === undefined ? [] : [[62, colour] as const]),
  [66, 1],
  [10, '0'],
  [20, '0'],
  [70, isClosed ? 1 : 0],
  ...points.flatMap((p): Pair[] => [[0, 'VERTEX'], [8, layer], ...at(p)]),
  [0, 'SEQEND'],
  [8, layer],
];

export const text = (layer: number, p: Point, words: string): readonly Pair[] => [
  [0, 'TEXT'],
  [8, layer],
  ...at(p),
  [40, textHeight],
  [1, plainText(words)],
];

export const block = (name: string, entities: readonly Pair[]): readonly Pair[] => [
  [0, 'BLOCK'],
  [8, 1],
  [2, name],
  [70, 0],
  ...at([0, 0]),
  ...entities,
  [0, 'ENDBLK'],
  [8, 1],
];

export const insert = (name: string): readonly Pair[] => [
  [0, 'INSERT'],
  [8, 1],
  [2, name],
  ...at([0, 0]),
];

/** A whole file, without tables, since some readers reject them. */
export function dxfFile(blocks: readonly Pair[], entities: readonly Pair[]): string {
  const section = (name: string, pairs: readonly Pair[]): readonly Pair[] => [
    [0, 'SECTION'],
    [2, name],
    ...pairs,
    [0, 'ENDSEC'],
  ];
  const pairs: readonly Pair[] = [
    ...section('HEADER', [
      [9, '$ACADVER'],
      [1, 'AC1009'],
    ]),
    ...section('BLOCKS', blocks),
    ...section('ENTITIES', entities),
    [0, 'EOF'],
  ];
  return pairs
    .map(([code, value]) => `${String(code).padStart(3)}${lineEnd}${value}${lineEnd}`)
    .join('');
}
