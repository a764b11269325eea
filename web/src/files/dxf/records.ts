/**
 * Records of DXF R12: pairs of a group code and a value, one line each. Lengths are in cm until the
 * file is written in its unit, with four decimal places.
 */
import type {Point} from '../../model/geometry/vectors.js';
import {cmPer} from '../base/units.js';
import type {DxfUnit} from '../../model/base/dxf-format.js';

/** Line ending of CAD programs. */
const lineEnd = '\r\n';
/** Height of text, which readers ignore. [cm] */
const textHeight = 0.5;

/** A length that is written in the unit of the file. */
interface Length {
  readonly cm: number;
}

export type Pair = readonly [code: number, value: string | number | Length];

/** Units per centimetre. */
const perCm = (unit: DxfUnit): number => (unit === 'mm' ? 10 : 1 / cmPer('inch'));

export const length = (cm: number): Length => ({cm});

/** A value without redundant digits. */
const written = (value: string | number | Length, scale: number): string | number =>
  typeof value === 'object' ? String(Number((scale * value.cm).toFixed(4)) + 0) : value;

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
  [10, length(x)],
  [20, length(y)],
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
  [11, length(to[0])],
  [21, length(to[1])],
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
  [40, length(textHeight)],
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

export const insert = (name: string, place: Point = [0, 0]): readonly Pair[] => [
  [0, 'INSERT'],
  [8, 1],
  [2, name],
  ...at(place),
];

/** A whole file, without tables, since some readers reject them. */
export function dxfFile(
  blocks: readonly Pair[],
  entities: readonly Pair[],
  unit: DxfUnit = 'mm',
): string {
  const scale = perCm(unit);
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
    .map(
      ([code, value]) => `${String(code).padStart(3)}${lineEnd}${written(value, scale)}${lineEnd}`,
    )
    .join('');
}
