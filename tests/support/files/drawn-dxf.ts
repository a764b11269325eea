/** Plain DXF from entities, each given as pairs of codes and values. */
import type {Point} from '@/model/geometry/vectors.js';

export type Entity = readonly (string | number)[];

const section = (name: string, content: readonly Entity[]): Entity => [
  ...[0, 'SECTION', 2, name],
  ...content.flat(),
  ...[0, 'ENDSEC'],
];

interface Parts {
  /** Pairs of the header. Default: millimetres. */
  readonly header?: Entity;
  readonly tables?: readonly Entity[];
  readonly blocks?: readonly Entity[];
  readonly entities: readonly Entity[];
}

export const millimetres: Entity = [9, '$INSUNITS', 70, 4];

export function drawnDxf({
  header = millimetres,
  tables = [],
  blocks = [],
  entities,
}: Parts): string {
  const sections = [
    section('HEADER', [header]),
    ...(tables.length > 0 ? [section('TABLES', tables)] : []),
    ...(blocks.length > 0 ? [section('BLOCKS', blocks)] : []),
    section('ENTITIES', entities),
  ];
  return `${[...sections.flat(), 0, 'EOF'].join('\n')}\n`;
}

export const closedLine = (
  points: readonly Point[],
  layer: number | string = 0,
  more: Entity = [],
): Entity => [
  ...[0, 'LWPOLYLINE', 8, layer, ...more, 90, points.length, 70, 1],
  ...points.flatMap(([x, y]) => [10, x, 20, y]),
];

export const box = (x: number, y: number, width: number, height: number): Point[] => [
  [x, y],
  [x + width, y],
  [x + width, y + height],
  [x, y + height],
];

/** A piece without symmetry, 40 x 30 cm in millimetres. */
export const flap = (x: number, y: number): Point[] => [
  [x, y],
  [x + 400, y],
  [x + 400, y + 300],
  [x + 100, y + 300],
  [x, y + 200],
];

export const segment = ([x, y]: Point, [toX, toY]: Point, layer: number | string = 0): Entity => [
  ...[0, 'LINE', 8, layer, 10, x, 20, y, 11, toX, 21, toY],
];

/** Segments along points. */
export const segments = (points: readonly Point[], layer: number | string = 0): Entity[] =>
  points.slice(1).map((to, k) => segment(points[k] ?? to, to, layer));

export const text = (words: string, [x, y]: Point, layer: number | string = 0): Entity => [
  ...[0, 'TEXT', 8, layer, 10, x, 20, y, 40, 5, 1, words],
];

export const block = (name: string, ...entities: readonly Entity[]): Entity => [
  ...[0, 'BLOCK', 8, 0, 2, name, 70, 0, 10, 0, 20, 0],
  ...entities.flat(),
  ...[0, 'ENDBLK', 8, 0],
];

export const insertion = (name: string, at: Point = [0, 0], more: Entity = []): Entity => [
  ...[0, 'INSERT', 8, 0, 2, name, 10, at[0], 20, at[1]],
  ...more,
];
