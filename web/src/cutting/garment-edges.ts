/** The edges of all pieces, and the ends of seams. */
import {minus, turnBetween, type Point} from '../model/geometry/vectors.js';
import type {GarmentPiece} from '../model/garment/garment-document.js';
import type {SolveResult} from '../model/result/result.js';
import {pick} from '../scene/marks.js';
import {outlineEdges, type OutlineEdge} from './edges.js';

/** Identifies an edge of the garment: piece, loop and edge. */
export type EdgeKey = string;

export interface EdgeEnd {
  readonly key: EdgeKey;
  readonly at: 'start' | 'end';
}

interface PlacedEdge {
  readonly edge: OutlineEdge;
  readonly piece: number;
  /** 0 for the outline, then the holes. */
  readonly loop: number;
  readonly before: EdgeKey;
  readonly after: EdgeKey;
}

export interface GarmentEdges {
  readonly edges: ReadonlyMap<EdgeKey, PlacedEdge>;
  /** For each piece, its loops with their edges in order. */
  readonly loops: readonly (readonly (readonly EdgeKey[])[])[];
  /** For each piece, the outline of its shape. */
  readonly outlines: readonly (readonly Point[])[];
  /** Pairs of edge ends that are sewn to each other. */
  readonly seamEnds: readonly (readonly [EdgeEnd, EdgeEnd])[];
}

const keyOf = (piece: number, loop: number, edge: number): EdgeKey => [piece, loop, edge].join('.');

function seamEndsOf(edges: GarmentEdges['edges']): GarmentEdges['seamEnds'] {
  const sides = new Map<number, {a?: EdgeKey; b?: EdgeKey}>();
  for (const [key, {edge}] of edges) {
    if (!edge.seam) continue;
    const {number, side} = edge.seam;
    sides.set(number, {...sides.get(number), [side]: key});
  }
  /** The start and the end of an edge in sewing direction. */
  const ends = (key: EdgeKey): readonly [EdgeEnd, EdgeEnd] => {
    const both = [
      {key, at: 'start'},
      {key, at: 'end'},
    ] as const;
    return edges.get(key)?.edge.seam?.isReversed ? [both[1], both[0]] : both;
  };
  return [...sides.values()].flatMap(({a, b}) => {
    if (a === undefined || b === undefined) return [];
    const [endsA, endsB] = [ends(a), ends(b)];
    return [[endsA[0], endsB[0]] as const, [endsA[1], endsB[1]] as const];
  });
}

/**
 * The edges of a garment.
 * @param draftOf returns a piece of the garment by name
 */
export function garmentEdges(
  {pieces, seams}: Pick<SolveResult, 'pieces' | 'seams'>,
  draftOf: (name: string) => GarmentPiece | undefined,
): GarmentEdges {
  const edges = new Map<EdgeKey, PlacedEdge>();
  const loops = pieces.map((piece, number) =>
    outlineEdges(piece, number, seams, draftOf(piece.name)).map((loop, l) =>
      loop.map((edge, e) => {
        const n = loop.length;
        const key = keyOf(number, l, e);
        edges.set(key, {
          ...{edge, piece: number, loop: l},
          before: keyOf(number, l, (e + n - 1) % n),
          after: keyOf(number, l, (e + 1) % n),
        });
        return key;
      }),
    ),
  );
  return {
    ...{edges, loops, seamEnds: seamEndsOf(edges)},
    outlines: pieces.map(({shape, outline}) => pick(shape, outline)),
  };
}

/**
 * The corner at an end of an edge: the next edge, and the turn of the outline to the left. [rad]
 */
export function cornerOf(
  {edges}: GarmentEdges,
  {key, at}: EdgeEnd,
): {readonly other: EdgeKey; readonly turn: number} {
  const {before = key, after = key} = edges.get(key) ?? {};
  const other = at === 'start' ? before : after;
  const [first, second] = at === 'start' ? [other, key] : [key, other];
  const [p, q] = edges.get(first)?.edge.points.slice(-2) ?? [];
  const [r, s] = edges.get(second)?.edge.points ?? [];
  const turn = p && q && r && s ? turnBetween(minus(q, p), minus(s, r)) : 0;
  return {other, turn};
}

/** The loops of a piece, edge by edge. */
export const allowedLoops = (
  {edges, loops}: GarmentEdges,
  piece: number,
): readonly (readonly {readonly key: EdgeKey; readonly points: readonly Point[]}[])[] =>
  (loops[piece] ?? []).map((loop) =>
    loop.map((key) => ({key, points: edges.get(key)?.edge.points ?? []})),
  );
