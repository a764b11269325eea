/** Plain DXF of the same pieces in random layers, blocks, units, gaps, frames and cut-outs. */
import '../../support/random-seed.js';

import fc from 'fast-check';
import {expect, it} from 'vitest';

import {readDxf} from '@/files/dxf/read-dxf.js';
import {defaultChoices, garmentOf} from '@/files/to-garment.js';
import {edgeLine} from '@/model/garment/edge-curve.js';
import {signedArea} from '@/model/geometry/polyline.js';
import type {DraftedEdge} from '@/model/garment/garment-document.js';
import type {Point} from '@/model/geometry/vectors.js';
import {cases} from '../../support/level.js';
import {
  block,
  box,
  closedLine,
  drawnDxf,
  flap,
  insertion,
  segments,
  type Entity,
} from '../../support/files/drawn-dxf.js';

/** `$INSUNITS`, and millimetres of a unit. */
const units = [
  [4, 1],
  [5, 10],
  [1, 25.4],
  [6, 1000],
] as const;

const anyPiece = fc.record({
  layer: fc.constantFrom('0', '1', 'CUT', 'SCHNITT 3'),
  /** Blocks around the lines of the piece. */
  depth: fc.integer({min: 0, max: 3}),
  turn: fc.constantFrom(0, 90, 30),
  /** Width of the gap of an outline of segments; null: a closed polyline. [mm] */
  gap: fc.option(fc.constantFrom(0, 0.05, 0.25)),
  hole: fc.constantFrom('none', 'cut-out', 'mark'),
});

const anyDrawing = fc.record({
  pieces: fc.array(anyPiece, {minLength: 1, maxLength: 4}),
  unit: fc.constantFrom(...units),
  isFramed: fc.boolean(),
});

type AnyPiece = typeof anyPiece extends fc.Arbitrary<infer T> ? T : never;

/** Lines of a piece at a place, in the unit of the file. */
function linesOf({layer, gap, hole}: AnyPiece, at: Point, mm: number): readonly Entity[] {
  const scaled = (points: readonly Point[]): Point[] => points.map(([x, y]) => [x / mm, y / mm]);
  const outline = flap(...at);
  const [start = at] = outline;
  const open: Point[] = [...outline, [start[0], start[1] + (gap ?? 0)]];
  const [x, y] = at;
  return [
    ...(gap === null ? [closedLine(scaled(outline), layer)] : segments(scaled(open), layer)),
    ...(hole === 'cut-out' ? [closedLine(scaled(box(x + 150, y + 80, 100, 90)), 11)] : []),
    ...(hole === 'mark' ? [closedLine(scaled(box(x + 150, y + 80, 15, 12)), 8)] : []),
  ];
}

function fileOf({pieces, unit: [code, mm], isFramed}: ReturnTypeOf<typeof anyDrawing>): string {
  const blocks: Entity[] = [];
  const entities = pieces.flatMap((piece, k) => {
    const at: Point = [200 + 700 * (k % 2), 250 + 600 * Math.floor(k / 2)];
    if (piece.depth === 0) return linesOf(piece, at, mm);
    blocks.push(block(`B${k}_0`, ...linesOf(piece, [0, 0], mm)));
    for (let n = 1; n < piece.depth; n++) {
      blocks.push(block(`B${k}_${n}`, insertion(`B${k}_${n - 1}`)));
    }
    const place: Point = [at[0] / mm, at[1] / mm];
    return [insertion(`B${k}_${piece.depth - 1}`, place, [50, piece.turn])];
  });
  const frame = box(-200, -150, 1682, 1189).map(([x, y]): Point => [x / mm, y / mm]);
  return drawnDxf({
    header: [9, '$INSUNITS', 70, code],
    blocks,
    entities: [...(isFramed && pieces.length > 1 ? [closedLine(frame)] : []), ...entities],
  });
}

type ReturnTypeOf<A> = A extends fc.Arbitrary<infer T> ? T : never;

const areaOf = (loop: readonly DraftedEdge[]): number =>
  Math.abs(signedArea(loop.flatMap((edge) => edgeLine(edge, 8).slice(0, -1))));

it('has the same pieces in their size, each with its cut-out or mark', () => {
  fc.assert(
    fc.property(anyDrawing, (asked) => {
      const bytes = new TextEncoder().encode(fileOf(asked));
      const drawing = readDxf(bytes, 'varied.dxf', {});
      const {pieces} = garmentOf(drawing, defaultChoices(drawing));
      expect(pieces.map(({outline}) => Math.round(areaOf(outline)))).toEqual(
        asked.pieces.map(() => 1150),
      );
      const counted = (name: string): number =>
        asked.pieces.filter(({hole}) => hole === name).length;
      const holes = pieces.flatMap((piece) => piece.holes);
      expect(holes.map((hole) => Math.round(areaOf(hole)))).toEqual(
        Array.from({length: counted('cut-out')}, () => 90),
      );
      expect(pieces.flatMap(({internalLines}) => internalLines)).toHaveLength(counted('mark'));
    }),
    {numRuns: cases(40, 1000)},
  );
});
