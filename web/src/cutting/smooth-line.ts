/** Smooth curves through the points of lines. Lengths in cm, angles in radians. */
import {
  distance,
  dot,
  minus,
  plus,
  turnBetween,
  unit,
  type Point,
} from '../model/geometry/vectors.js';

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
