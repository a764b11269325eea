/**
 * Flat areas to print, drawn in cm with y up: outlines, the strokes of a tapering tool, and motifs
 * made of both.
 */
import type {Point} from '../../src/model/geometry/vectors.js';

/**
 * Inks, to which a colourway assigns colours. Cuts into a motif show the ground, as in a block
 * print.
 */
const inks = ['ground', 'line', 'leaf', 'bloom', 'soft', 'spark'] as const;
export type Ink = (typeof inks)[number];

export const isInk = (text: string): text is Ink => inks.some((ink) => ink === text);

/** A straight side: its end; a cubic Bezier curve: its two control points and its end. */
type Side = readonly [Point] | readonly [Point, Point, Point];

export interface Outline {
  readonly start: Point;
  readonly sides: readonly Side[];
}

/** One printing block: areas of one ink. */
interface Shape {
  readonly ink: Ink;
  readonly outlines: readonly Outline[];
}

/** Shapes in the order of printing, growing from the origin along +y. */
export type Motif = readonly Shape[];

/** Degrees, counter-clockwise from +y. */
type Heading = number;

/** The point at `along` ahead of `from`, and at `aside` to its left. */
export function ahead([x, y]: Point, heading: Heading, along: number, aside = 0): Point {
  const a = (heading * Math.PI) / 180;
  const [s, c] = [Math.sin(a), Math.cos(a)];
  return [x - s * along - c * aside, y + c * along - s * aside];
}

/** Points of a curve; as text, `x,y` after `x,y`. [cm] */
export type Trace = string | readonly Point[];

function via(trace: Trace): readonly Point[] {
  if (typeof trace !== 'string') return trace;
  return trace.split(' ').map((pair): Point => {
    const [x = NaN, y = NaN] = pair.split(',').map(Number);
    return [x, y];
  });
}

/** 'closed' if a curve returns to its start. */
type Ends = 'open' | 'closed';

/** Cubic curves through all points (Catmull-Rom). */
function smoothSides(points: readonly Point[], ends: Ends): Side[] {
  const count = points.length;
  const point = (k: number): Point => {
    const index = ends === 'closed' ? (k + count) % count : Math.min(Math.max(k, 0), count - 1);
    return points[index] ?? origin;
  };
  const tangent = (k: number): Point => {
    const [before, after] = [point(k - 1), point(k + 1)];
    return [(after[0] - before[0]) / 6, (after[1] - before[1]) / 6];
  };
  return Array.from({length: ends === 'closed' ? count : count - 1}, (_, k): Side => {
    const [p, q, tp, tq] = [point(k), point(k + 1), tangent(k), tangent(k + 1)];
    return [[p[0] + tp[0], p[1] + tp[1]], [q[0] - tq[0], q[1] - tq[1]], q];
  });
}

const outline = (start: Point, ...sides: Side[]): Outline => ({start, sides});

const origin: Point = [0, 0];

export function polygon(ink: Ink, corners: Trace): Shape {
  const [start = origin, ...rest] = via(corners);
  return {ink, outlines: [outline(start, ...rest.map((corner): Side => [corner]))]};
}

/** A round area through points. */
export function pebble(ink: Ink, through: Trace): Shape {
  const points = via(through);
  return {ink, outlines: [outline(points[0] ?? origin, ...smoothSides(points, 'closed'))]};
}

/**
 * An area with two corners, its foot and its tip: the left edge from one to the other, the right
 * one between them.
 */
export function blade(ink: Ink, left: Trace, right: Trace): Shape {
  const up = via(left);
  const [foot, tip] = [up[0] ?? origin, up.at(-1) ?? origin];
  const down = smoothSides([tip, ...via(right).toReversed(), foot], 'open');
  return {ink, outlines: [outline(foot, ...smoothSides(up, 'open'), ...down)]};
}

export function dot(ink: Ink, [x, y]: Point, radius: number): Shape {
  const k = radius * 0.5523; // approximates a quarter of a circle to 3 parts in 10 000
  const r = radius;
  const quarter = (a: Point, b: Point, to: Point): Side => [a, b, to];
  return {
    ink,
    outlines: [
      outline(
        [x + r, y],
        quarter([x + r, y + k], [x + k, y + r], [x, y + r]),
        quarter([x - k, y + r], [x - r, y + k], [x - r, y]),
        quarter([x - r, y - k], [x - k, y - r], [x, y - r]),
        quarter([x + k, y - r], [x + r, y - k], [x + r, y]),
      ),
    ],
  };
}

/**
 * Points of a smooth curve through `points`, `steps` for each of its parts, with their headings.
 */
export function along(trace: Trace, steps: number): {at: Point; heading: Heading}[] {
  const points = via(trace);
  let from = points[0] ?? origin;
  const found: {at: Point; heading: Heading}[] = [];
  const sides = smoothSides(points, 'open');
  sides.forEach((side, k) => {
    const [a, b, to] = side.length === 3 ? side : [from, side[0], side[0]];
    const last = k === sides.length - 1 ? steps : steps - 1;
    for (let i = 0; i <= last; i++) {
      const t = i / steps;
      const s = 1 - t;
      const mix = (n: 0 | 1): number =>
        s * s * s * from[n] + 3 * s * s * t * a[n] + 3 * s * t * t * b[n] + t * t * t * to[n];
      const rise = (n: 0 | 1): number =>
        s * s * (a[n] - from[n]) + 2 * s * t * (b[n] - a[n]) + t * t * (to[n] - b[n]);
      found.push({
        at: [mix(0), mix(1)],
        heading: (Math.atan2(-rise(0), rise(1)) * 180) / Math.PI,
      });
    }
    from = to;
  });
  return found;
}

/** A stroke along a smooth curve, `width` at its start and `end` at its end. [cm] */
export function stroke(ink: Ink, through: Trace, width: number, end = width): Shape {
  const line = along(through, 1);
  const ribs = line.map(({at, heading}, k) => {
    const half = (width + ((end - width) * k) / (line.length - 1)) / 2;
    return {
      left: ahead(at, heading, 0, half),
      right: ahead(at, heading, 0, -half),
      at,
      heading,
      half,
    };
  });
  const tip = (k: number, way: 1 | -1): Point[] =>
    ribs
      .slice(k, k === -1 ? undefined : k + 1)
      .map(({at, heading, half}) => ahead(at, heading, way * half));
  const ring = [
    ...ribs.map(({left}) => left),
    ...tip(-1, 1),
    ...ribs.map(({right}) => right).toReversed(),
    ...tip(0, -1),
  ];
  return line.length > 2 ? pebble(ink, ring) : polygon(ink, ring);
}

type Mapping = (p: Point) => Point;

function mapped(motif: Motif, to: Mapping): Motif {
  const side = (s: Side): Side => (s.length === 1 ? [to(s[0])] : [to(s[0]), to(s[1]), to(s[2])]);
  return motif.map(({ink, outlines}) => ({
    ink,
    outlines: outlines.map((o) => ({start: to(o.start), sides: o.sides.map(side)})),
  }));
}

/** The motif from another foot, in another heading and size; a negative `width` mirrors it. */
export const grown = (motif: Motif, foot: Point, heading: Heading, size = 1, width = size): Motif =>
  mapped(motif, ([x, y]) => ahead(foot, heading, y * size, -x * width));

/** Several motifs printed at once: the first blocks of all, then the second blocks, and so on. */
export function together(...motifs: Motif[]): Motif {
  const depth = Math.max(...motifs.map((motif) => motif.length));
  const levels = Array.from({length: depth}, (_, k) => motifs.flatMap((motif) => motif[k] ?? []));
  return joined(levels.flat());
}

/** Merges consecutive blocks of the same ink. */
export function joined(motif: Motif): Motif {
  const blocks: Shape[] = [];
  for (const shape of motif) {
    const last = blocks.at(-1);
    if (last?.ink === shape.ink) {
      blocks[blocks.length - 1] = {
        ink: shape.ink,
        outlines: [...last.outlines, ...shape.outlines],
      };
    } else {
      blocks.push(shape);
    }
  }
  return blocks;
}
