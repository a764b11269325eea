/** The outline of a solved piece, divided into its drafted edges. Lengths in cm. */
import type {DraftedEdge, GarmentPiece} from '../model/garment/garment-document.js';
import {
  distance,
  dot,
  minus,
  plus,
  turnBetween,
  unit,
  type Point,
} from '../model/geometry/vectors.js';
import type {ResultPiece, ResultSeam} from '../model/result/result.js';
import {pick} from '../scene/marks.js';

/** The seam of an edge. */
interface EdgeSeam {
  readonly number: number;
  readonly side: 'a' | 'b';
  /** Sewn from end to start. */
  readonly isReversed: boolean;
}

export interface OutlineEdge {
  /** Vertex indices of the piece from start to end. */
  readonly vertices: readonly number[];
  /** A smooth curve through the vertices of the shape. */
  readonly points: readonly Point[];
  readonly drafted?: DraftedEdge;
  readonly seam?: EdgeSeam;
}

/** Greatest distance between a drafted corner and its outline vertex. */
const sameCorner = 0.05;
/** Least turn of a corner in an outline without a matching draft. [rad] */
const cornerTurn = 0.4;

type Sides = readonly (EdgeSeam & {readonly vertices: readonly number[]})[];

/** Every sewn run of outline vertices, in the direction of the outline. */
const sidesOf = (
  seams: readonly ResultSeam[],
  piece: number,
  loops: readonly (readonly number[])[],
): Sides =>
  seams.flatMap((seam, number) =>
    (['a', 'b'] as const).flatMap((side) => {
      const {piece: on, vertices} = seam[side];
      const [first = -1, second = -1] = vertices;
      if (on !== piece) return [];
      const runsAlong = loops.some((loop) => {
        const at = loop.indexOf(first);
        return at >= 0 && loop[(at + 1) % loop.length] === second;
      });
      const forward = runsAlong ? vertices : [...vertices].reverse();
      return [{number, side, isReversed: !runsAlong, vertices: forward}];
    }),
  );

/** Loop indices where drafted edges begin; undefined if the draft does not fit the outline. */
function draftedStarts(
  {rest}: ResultPiece,
  loop: readonly number[],
  edges: readonly DraftedEdge[],
): readonly number[] | undefined {
  const points = pick(rest, loop);
  const starts = edges.map(({points: [start]}) => {
    const apart = points.map((p) => distance(p, start));
    const least = Math.min(...apart);
    return least < sameCorner ? apart.indexOf(least) : -1;
  });
  const steps = starts.map(
    (at, k) => ((starts[(k + 1) % starts.length] ?? at) - at + loop.length) % loop.length,
  );
  const isWhole =
    starts.length > 0 && !starts.includes(-1) && steps.reduce((a, b) => a + b, 0) === loop.length;
  return isWhole || (starts.length === 1 && starts[0] !== -1) ? starts : undefined;
}

/** Loop indices where seams begin or end, and where the outline turns sharply. */
function seenStarts({rest}: ResultPiece, loop: readonly number[], sides: Sides): readonly number[] {
  const points = pick(rest, loop);
  const ends = new Set(sides.flatMap(({vertices}) => [vertices[0], vertices.at(-1)]));
  const n = points.length;
  const starts = points.flatMap((p, k) => {
    const [before = p, after = p] = [points[(k + n - 1) % n], points[(k + 1) % n]];
    const turn = Math.abs(turnBetween(minus(p, before), minus(after, p)));
    return turn > cornerTurn || ends.has(loop[k]) ? [k] : [];
  });
  return starts.length > 0 ? starts : [0];
}

/** The edges of the outline, then of each hole. */
export function outlineEdges(
  piece: ResultPiece,
  number: number,
  seams: readonly ResultSeam[],
  drafted?: GarmentPiece,
): readonly (readonly OutlineEdge[])[] {
  const loops = [piece.outline, ...piece.holes];
  const sides = sidesOf(seams, number, loops);
  const draft = drafted && [drafted.outline, ...drafted.holes];
  return loops.map((loop, k) => {
    const known = draft?.[k];
    const byDraft = known && draftedStarts(piece, loop, known);
    const starts = byDraft ?? seenStarts(piece, loop, sides);
    return starts.map((start, e) => {
      const end = starts[(e + 1) % starts.length] ?? start;
      const steps = (end - start + loop.length) % loop.length || loop.length;
      const vertices = Array.from(
        {length: steps + 1},
        (_, n) => loop[(start + n) % loop.length] ?? 0,
      );
      const seam = sides.find(
        (side) => side.vertices[0] === vertices[0] && side.vertices[1] === vertices[1],
      );
      const edge = byDraft && known[e];
      return {
        ...{vertices, points: smoothLine(pick(piece.shape, vertices))},
        ...(edge && {drafted: edge}),
        ...(seam && {
          seam: {number: seam.number, side: seam.side, isReversed: seam.isReversed},
        }),
      };
    });
  });
}

// Smooth curves through the points of lines. Lengths in cm, angles in radians.

/** Greatest distance between points of a curve. */
const dense = 2.5;
/** Least turn of a corner. */
const corner = 0.4;
/** Greatest turn between the drawn segments of a curve. */
const leastStep = 0.03;
/** Least bend of a curve. */
const leastBend = 1e-5;

/** A direction reflected in a chord: the direction of an arc at the chord's other end. */
const acrossChord = (way: Point, chord: Point): Point =>
  unit(minus(plus([0, 0], chord, 2 * dot(way, chord)), way));

/** Direction and length of a segment; undefined if the segment stays straight. */
interface Chord {
  readonly way: Point;
  readonly length: number;
}

/**
 * The direction of a curve at a point between two segments: that of the parabola through all three
 * points.
 */
const between = (one: Chord, two: Chord): Point =>
  unit(plus(plus([0, 0], one.way, two.length), two.way, one.length));

/** Points of a cubic with given directions at its ends, without the last point. */
function curved(from: Point, to: Point, start: Point, end: Point): readonly Point[] {
  const length = distance(from, to);
  const chord = unit(minus(to, from));
  const bend = Math.abs(turnBetween(start, chord)) + Math.abs(turnBetween(chord, end));
  if (bend < leastBend) return [from];
  const count = Math.ceil(bend / leastStep);
  const [a, b] = [plus(from, start, length / 3), plus(to, end, -length / 3)];
  return Array.from({length: count}, (_, k): Point => {
    const t = k / count;
    const s = 1 - t;
    const [p, q, r, z] = [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t];
    return [
      p * from[0] + q * a[0] + r * b[0] + z * to[0],
      p * from[1] + q * a[1] + r * b[1] + z * to[1],
    ];
  });
}

/**
 * The line with additional points on its curves. Its own points, straight parts and corners stay.
 */
export function smoothLine(points: readonly Point[]): readonly Point[] {
  const chords = points.slice(1).map((to, k): Chord | undefined => {
    const from = points[k] ?? to;
    const length = distance(from, to);
    return length > 0 && length < dense ? {way: unit(minus(to, from)), length} : undefined;
  });
  /** Undefined where the curve ends. */
  const ways = points.map((_, k): Point | undefined => {
    const [before, after] = [chords[k - 1], chords[k]];
    if (!before || !after || Math.abs(turnBetween(before.way, after.way)) > corner)
      return undefined;
    return between(before, after);
  });
  const line = points.slice(1).flatMap((to, k): readonly Point[] => {
    const [from, chord] = [points[k] ?? to, chords[k]];
    const [start, end] = [ways[k], ways[k + 1]];
    if (!chord || (!start && !end)) return [from];
    const first = start ?? acrossChord(end ?? chord.way, chord.way);
    return curved(from, to, first, end ?? acrossChord(first, chord.way));
  });
  return [...line, ...points.slice(-1)];
}
