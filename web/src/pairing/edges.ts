/** Edges of a garment, measured for comparing them: nothing here depends on units, names or their order. */
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
} from '../model/geometry.js';
import type {EdgeOfPiece, GarmentPiece} from '../model/garment-document.js';
import {edgeLine} from '../model/edge-curve.js';
import {lengthOf, signedArea, stepAt} from '../model/polyline.js';
import {wordsOf, type Words} from './words.js';

/** Of how many equal steps a profile of headings is made: fine enough for the S of a sleeve cap. */
const profileSteps = 9;

export interface MeasuredEdge {
  readonly at: EdgeOfPiece;
  /** [cm] */
  readonly length: number;
  /** How far it has turned from its mean heading at each step, counter-clockwise. [rad] */
  readonly profile: readonly number[];
  /** By how much it turns from its start to its end. [rad] */
  readonly turning: number;
  /** The angle within the piece at its start. [rad] */
  readonly corner: number;
  /** Where its chord leads, to the piece's grain: across it, and along. */
  readonly chord: Point;
  /** Its middle within the piece: across from the middle and up from the foot, as shares. */
  readonly place: Point;
  /** Its length as a share of the outline's. */
  readonly share: number;
  /** Numbers, in the list of all edges, of those before and after it on the outline. */
  readonly before: number;
  readonly after: number;
  /** Shares of its length that are notched, ascending. */
  readonly notches: readonly number[];
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
  /** The side of a square as large as all pieces. [cm] */
  readonly scale: number;
}

/** Points at equal steps of a line's length, its ends among them. */
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
  /** Headings at its ends. */
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

/** The direction of a piece's grain, as far upwards as it goes: of length 1. */
function upOf({grain}: GarmentPiece): Point {
  const [foot, head] = grain?.line ?? [];
  if (!foot || !head || distance(foot, head) === 0) return [0, 1];
  const way = unit(minus(head, foot));
  const [x, y] = Math.abs(way[1]) < 1e-6 ? [way[0], 0] : way;
  return y < 0 || (y === 0 && x < 0) ? [-x, -y] : [x, y];
}

/** Shares across, from -1/2 to 1/2, and along a direction, from 0 to 1, of points among all. */
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

function edgesOfPiece(
  piece: GarmentPiece,
  lines: readonly (readonly Point[])[],
  number: number,
  first: number,
): MeasuredEdge[] {
  const shapes = lines.map(shapeOf);
  const perimeter = shapes.reduce((sum, {length}) => sum + length, 0);
  const up = upOf(piece);
  const turn = Math.PI / 2 - angleOf(up);
  const placeOf = placesIn(lines.flat(), up);
  const count = shapes.length;
  return shapes.map(({length, profile, turning, chord, middle, ends}, k) => {
    const previous = shapes[(k + count - 1) % count]?.ends[1] ?? ends[0];
    return {
      at: {piece: number, edge: k},
      ...{length, profile, turning},
      corner: Math.PI - turnBetween(previous, ends[0]),
      chord: rotated(chord, turn),
      place: placeOf(middle),
      share: length / perimeter,
      before: first + ((k + count - 1) % count),
      after: first + ((k + 1) % count),
      notches: (piece.notches ?? [])
        .filter(({edge}) => edge === k)
        .map(({at}) => at)
        .sort((a, b) => a - b),
      isOpen: piece.outline[k]?.open === true,
    };
  });
}

/** All edges of a garment's pieces, piece by piece. */
export function measured(pieces: readonly GarmentPiece[]): MeasuredGarment {
  const edges: MeasuredEdge[] = [];
  const seen = pieces.map((piece, number): MeasuredPiece => {
    const first = edges.length;
    const lines = piece.outline.map((edge) => edgeLine(edge));
    edges.push(...edgesOfPiece(piece, lines, number, first));
    const area = signedArea(lines.flatMap((line) => line.slice(1)));
    return {
      ...{first, count: edges.length - first, area: Math.abs(area)},
      words: wordsOf(piece.name),
      material: piece.material ?? '',
    };
  });
  const total = seen.reduce((sum, {area}) => sum + area, 0);
  return {edges, pieces: seen, scale: Math.sqrt(total)};
}
