/**
 * DXF in the style of the simplest programs: a block for each piece, with its outline and its name.
 */
import type {Point} from '@/model/geometry/vectors.js';

export interface PlainPiece {
  readonly name: string;
  readonly outline: readonly Point[];
}

const pairs = (...of: readonly (string | number)[]): string => of.map((one) => `${one}\n`).join('');

/**
 * @param words  on the style, such as `Units: METRIC` @param isClosed  whether outlines end at
 * their start
 */
export function plainDxf(
  pieces: readonly PlainPiece[],
  {
    words = [],
    isClosed = true,
  }: {readonly words?: readonly string[]; readonly isClosed?: boolean} = {},
): string {
  const text = (value: string): string => pairs(0, 'TEXT', 8, 1, 10, 0, 20, 0, 40, 1, 1, value);
  const vertex = ([x, y]: Point): string => pairs(0, 'VERTEX', 8, 1, 10, x, 20, y);
  const blocks = pieces.map(({name, outline}, k) =>
    [
      pairs(0, 'BLOCK', 8, 1, 2, `B${k}`, 70, 0, 10, 0, 20, 0),
      pairs(0, 'POLYLINE', 8, 1, 66, 1, 70, isClosed ? 1 : 0),
      ...outline.map(vertex),
      pairs(0, 'SEQEND', 8, 1),
      text(`Piece Name: ${name}`),
      pairs(0, 'ENDBLK', 8, 1),
    ].join(''),
  );
  const inserts = pieces.map((_, k) => pairs(0, 'INSERT', 8, 1, 2, `B${k}`, 10, 0, 20, 0));
  return [
    pairs(0, 'SECTION', 2, 'BLOCKS'),
    ...blocks,
    pairs(0, 'ENDSEC', 0, 'SECTION', 2, 'ENTITIES'),
    ...words.map(text),
    ...inserts,
    pairs(0, 'ENDSEC', 0, 'EOF'),
  ].join('');
}
