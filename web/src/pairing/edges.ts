/**
 * Measures the edges of a garment for comparison. Edges do not depend on names or on their order;
 * only lengths and areas have a unit.
 */
import {
  angleOf,
  between,
  distance,
  dot,
  minus,
  rotated,
  turnBetween,
  unit,
  type Point,
} from '../model/geometry/vectors.js';
import type {EdgeOfPiece, GarmentPiece} from '../model/garment/garment-document.js';
import {edgeLine} from '../model/garment/edge-curve.js';
import {lengthOf, signedArea, stepAt} from '../model/geometry/polyline.js';
import {closedEdges} from './closed-pleats.js';
import {dartsOf} from './darts.js';
import {wordsOf, type Words} from '../model/garment/piece-words.js';

/** Number of equal steps in a heading profile: fine enough for the S of a sleeve cap. */
const profileSteps = 9;

export interface MeasuredEdge {
  readonly at: EdgeOfPiece;
  /** [cm] */
  readonly length: number;
  /** Deviation from the mean heading at each step, counter-clockwise. [rad] */
  readonly profile: readonly number[];
  /** Total turn from start to end. [rad] */
  readonly turning: number;
  /** Interior angle of the piece at the edge's start. [rad] */
  readonly corner: number;
  /** Direction of the chord relative to the piece's grain: across it, and along it. */
  readonly chord: Point;
  /**
   * Middle of the edge within the piece: share across from the middle, and share up from the foot.
   */
  readonly place: Point;
  /** Length as a share of the outline's length. */
  readonly share: number;
  /** Numbers of the previous and the next edge of the outline, in the list of all edges. */
  readonly before: number;
  readonly after: number;
  /** As `before`, `after` and `corner` once the piece's darts are closed. */
  readonly previous: number;
  readonly next: number;
  readonly angle: number;
  /** Notches as shares of the length, ascending. */
  readonly notches: readonly number[];
  /** True if the edge is not sewn: the user marked it, or a pleat hides it. */
  readonly isOpen: boolean;
}

export interface MeasuredPiece {
  readonly first: number;
  readonly count: number;
  /** [cm2] */
  readonly area: number;
  readonly words: Words;
  readonly material: string;
}

export interface MeasuredGarment {
  readonly edges: readonly MeasuredEdge[];
  readonly pieces: readonly MeasuredPiece[];
  /** Side of a square with the area of all pieces. [cm] */
  readonly scale: number;
}

/** Returns points at equal steps of a line's length, both ends included. */
function evenly(line: readonly Point[], steps: number): Point[] {
  return Array.from({length: steps + 1}, (_, k) => {
    const {step, part} = stepAt(line, k / steps);
    return between(line[step] ?? [0, 0], line[step + 1] ?? line[step] ?? [0, 0], part);
  });
}

interface Shape {
  readonly length: number;
  readonly profile: readonly number[];
  readonly turning: number;
  readonly chord: Point;
  readonly middle: Point;
  /** Headings at both ends. */
  readonly ends: readonly [Point, Point];
}

function shapeOf(line: readonly Point[]): Shape {
  const points = evenly(line, profileSteps);
  const ways = points.slice(1).map((to, k) => minus(to, points[k] ?? to));
  const headings: number[] = [];
  for (const [k, way] of ways.entries()) {
    headings.push((headings[k - 1] ?? 0) + (k === 0 ? 0 : turnBetween(ways[k - 1] ?? way, way)));
  }
  const mean = headings.reduce((sum, one) => sum + one, 0) / headings.length;
  const [from = [0, 0], to = from] = [line[0], line.at(-1)];
  const near = (k: number) => minus(line[k + 1] ?? to, line[k] ?? from);
  const ends = [near(0), near(line.length - 2)] as const;
  const [first = [1, 0], last = first] = [ways[0], ways.at(-1)];
  return {
    length: lengthOf(line),
    profile: headings.map((heading) => heading - mean),
    turning:
      turnBetween(ends[0], first) +
      ((headings.at(-1) ?? 0) - (headings[0] ?? 0)) +
      turnBetween(last, ends[1]),
    chord: unit(minus(to, from)),
    middle: evenly(line, 2)[1] ?? from,
    ends,
  };
}

/** Returns the unit vector of a piece's grain that points upwards. */
function upOf({grain}: GarmentPiece): Point {
  const [foot, head] = grain?.line ?? [];
  if (!foot || !head || distance(foot, head) === 0) return [0, 1];
  const way = unit(minus(head, foot));
  const [x, y] = Math.abs(way[1]) < 1e-6 ? [way[0], 0] : way;
  return y < 0 || (y === 0 && x < 0) ? [-x, -y] : [x, y];
}

/** Returns a function for a point's share across, from -1/2 to 1/2, and along `up`, from 0 to 1. */
function placesIn(points: readonly Point[], up: Point): (point: Point) => Point {
  const across = rotated(up, -Math.PI / 2);
  const spread = (along: Point): ((point: Point) => number) => {
    const seen = points.map((point) => dot(point, along));
    const [low, high] = [Math.min(...seen), Math.max(...seen)];
    return (point) => (dot(point, along) - low) / (high - low || 1);
  };
  const [x, y] = [spread(across), spread(up)];
  return (point) => [x(point) - 0.5, y(point)];
}

/** The next number of an edge that is not hidden in a pleat, in steps of `by`. */
function visibleFrom(hidden: readonly boolean[], k: number, by: 1 | -1): number {
  const count = hidden.length;
  let next = (k + by + count) % count;
  while (hidden[next] && next !== k) next = (next + by + count) % count;
  return next;
}

function edgesOfPiece(
  piece: GarmentPiece,
  closed: ReturnType<typeof closedEdges>,
  number: number,
  first: number,
): OutlineEdge[] {
  const hidden = closed.map(({isHidden}) => isHidden);
  const shapes = closed.map(({line}) => shapeOf(line));
  const visible = closed.filter(({isHidden}) => !isHidden).map(({line}) => line);
  const perimeter = shapes.reduce((sum, {length}, k) => sum + (hidden[k] ? 0 : length), 0);
  const up = upOf(piece);
  const turn = Math.PI / 2 - angleOf(up);
  const placeOf = placesIn(visible.flat(), up);
  return shapes.map(({length, profile, turning, chord, middle, ends}, k) => {
    const before = visibleFrom(hidden, k, -1);
    const previous = shapes[before]?.ends[1] ?? ends[0];
    return {
      at: {piece: number, edge: k},
      ...{length, profile, turning},
      corner: Math.PI - turnBetween(previous, ends[0]),
      chord: rotated(chord, turn),
      place: placeOf(middle),
      share: length / perimeter,
      before: first + before,
      after: first + visibleFrom(hidden, k, 1),
      notches: (piece.notches ?? [])
        .filter(({edge}) => edge === k)
        .map(({at}) => at)
        .sort((a, b) => a - b),
      isOpen: piece.outline[k]?.open === true,
    };
  });
}

/** An edge as drafted, with open darts. */
type OutlineEdge = Omit<MeasuredEdge, 'previous' | 'next' | 'angle'>;

/** Adds the neighbours of each edge beyond closed darts. */
function withClosedDarts(
  edges: readonly OutlineEdge[],
  pieces: readonly MeasuredPiece[],
): readonly MeasuredEdge[] {
  const all = edges.map((edge) => ({
    ...edge,
    ...{previous: edge.before, next: edge.after, angle: edge.corner},
  }));
  for (const [first, second] of dartsOf({edges, pieces})) {
    const [before, after] = [all[all[first]?.previous ?? -1], all[all[second]?.next ?? -1]];
    const leg = all[first];
    if (!before || !after || !leg || before === after) continue;
    after.angle += leg.angle;
    [after.previous, before.next] = [leg.previous, all[second]?.next ?? before.next];
  }
  return all;
}

/** Pleats as they are sewn, or as they are cut. */
export type PleatState = 'closed' | 'open';

/** Measures all edges of a garment, piece by piece. */
export function measured(
  pieces: readonly GarmentPiece[],
  pleats: PleatState = 'closed',
): MeasuredGarment {
  const edges: OutlineEdge[] = [];
  const seen = pieces.map((piece, number): MeasuredPiece => {
    const first = edges.length;
    const lines = piece.outline.map((edge) => edgeLine(edge));
    const closed = closedEdges(piece, lines);
    const drawn = pleats === 'closed' ? closed : lines.map((line) => ({line, isHidden: false}));
    const own = edgesOfPiece(piece, drawn, number, first);
    edges.push(...own.map((edge, k) => (closed[k]?.isHidden ? {...edge, isOpen: true} : edge)));
    const area = signedArea(drawn.flatMap(({line, isHidden}) => (isHidden ? [] : line.slice(1))));
    return {
      ...{first, count: edges.length - first, area: Math.abs(area)},
      words: wordsOf(piece.name),
      material: piece.material ?? '',
    };
  });
  const total = seen.reduce((sum, {area}) => sum + area, 0);
  return {edges: withClosedDarts(edges, seen), pieces: seen, scale: Math.sqrt(total)};
}
