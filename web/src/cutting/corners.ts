/** The allowance beyond a corner of an outline: counter-clockwise polygons. Lengths in cm. */
import {
  between,
  cross,
  dot,
  leftOf,
  minus,
  norm,
  plus,
  turnBetween,
  unit,
  type Point,
} from '../model/geometry/vectors.js';

/** The edge that ends at a corner, or the one that begins there. */
export type Own = 'before' | 'after';

/** The shape of a corner. By default the cut lines are extended until they meet. */
export interface CornerPlan {
  /** The edge whose allowance is turned up along its seam line, like a hem. */
  readonly turned?: Own;
  /** Distance beyond the end of a seam at which its allowance is cut off square. */
  readonly square?: {readonly before?: number; readonly after?: number};
}

/** A corner: directions and allowances of its two edges. */
export interface Corner {
  readonly at: Point;
  /** Unit vectors in the direction of the outline. */
  readonly before: Point;
  readonly after: Point;
  readonly widthBefore: number;
  readonly widthAfter: number;
}

/** Greatest length of a mitre, in allowance widths. */
const mitreLimit = 2.5;
/** Sine of the least turn of a corner. */
const least = 1e-6;

/** Sine of the least angle at which an allowance can be turned up. */
const leastTurned = 0.3;

/** The direction a quarter turn clockwise, out of the piece. */
const outOf = (direction: Point): Point => {
  const [x, y] = leftOf(direction);
  return [0 - x, 0 - y];
};

/**
 * A corner in the coordinates of one of its edges. The corner is the origin, the edge runs towards
 * it along +x, and its allowance is at +y. The other allowance is the region less than `width`
 * along `normal`.
 */
interface Frame {
  readonly along: Point;
  readonly out: Point;
  readonly width: number;
  readonly other: {readonly normal: Point; readonly width: number};
}

function frameOf(corner: Corner, own: Own): Frame {
  const {before, after, widthBefore, widthAfter} = corner;
  const isBefore = own === 'before';
  const along: Point = isBefore ? before : [0 - after[0], 0 - after[1]];
  const out = outOf(isBefore ? before : after);
  const otherOut = outOf(isBefore ? after : before);
  return {
    ...{along, out, width: isBefore ? widthBefore : widthAfter},
    other: {
      normal: [dot(otherOut, along), dot(otherOut, out)],
      width: isBefore ? widthAfter : widthBefore,
    },
  };
}

const fromFrame = ({at}: Corner, {along, out}: Frame, [x, y]: Point): Point =>
  plus(plus(at, along, x), out, y);

const intoFrame = ({at}: Corner, {along, out}: Frame, p: Point): Point => [
  dot(minus(p, at), along),
  dot(minus(p, at), out),
];

/** The x coordinate of the other cut line at height y. */
const acrossAt = ({other: {normal, width}}: Frame, y: number): number =>
  (width - y * normal[1]) / normal[0];

/** Extends both cut lines until they meet, or to the limit. */
function mitre(frame: Frame): readonly Point[] {
  const {
    width,
    other: {normal, width: otherWidth},
  } = frame;
  const foot: Point = [0, width];
  const otherFoot: Point = [otherWidth * normal[0], otherWidth * normal[1]];
  // if one allowance ends inside the other, the end of the wider one stays square
  if (otherWidth < width * normal[1]) return [[0, 0], [0, otherWidth / normal[1]], otherFoot];
  if (width < otherWidth * normal[1]) {
    const share = width / normal[1];
    return [[0, 0], foot, [share * normal[0], share * normal[1]]];
  }
  const meeting: Point = [acrossAt(frame, width), width];
  const reach = norm(meeting);
  const limit = mitreLimit * Math.max(width, otherWidth);
  if (reach <= limit) return [[0, 0], foot, meeting, otherFoot];
  const towards = unit(meeting);
  const cutOff = (from: Point): Point =>
    between(from, meeting, (limit - dot(from, towards)) / (reach - dot(from, towards)));
  return [[0, 0], foot, cutOff(foot), cutOff(otherFoot), otherFoot];
}

/** The part of a convex polygon up to the distance `far` in a direction. */
function upTo(polygon: readonly Point[], direction: Point, far: number): readonly Point[] {
  return polygon.flatMap((p, k) => {
    const q = polygon[(k + 1) % polygon.length] ?? p;
    const [a, b] = [dot(p, direction) - far, dot(q, direction) - far];
    const crossing = a > 0 !== b > 0 ? [between(p, q, a / (a - b))] : [];
    return a > 0 ? crossing : [p, ...crossing];
  });
}

/** Overlap of an extended allowance with its piece, across the seam line. */
const overlap = 0.1;

/** The extended part of a seam's allowance; empty if none is needed. */
export function longer(corner: Corner, own: Own, reach: number): readonly Point[] {
  const frame = frameOf(corner, own);
  if (frame.other.normal[0] < least || reach <= acrossAt(frame, 0) + least) return [];
  return [
    [0, 0 - overlap],
    [0, frame.width],
    [reach, frame.width],
    [reach, 0 - overlap],
  ].map(([x = 0, y = 0]) => fromFrame(corner, frame, [x, y]));
}

/** The allowance of a corner with its seam cut off square. */
function squared(
  frame: Frame,
  reach: number,
  fabric: readonly Point[],
): readonly (readonly Point[])[] {
  // an acute tip beyond the other allowance is cut off; otherwise the allowance is extended
  if (frame.other.normal[1] < 0) return [upTo(fabric, [1, 0], reach)];
  return [
    fabric,
    [
      [0, 0],
      [0, frame.width],
      [reach, frame.width],
      [reach, 0],
    ],
  ];
}

/** The allowance of a corner that is not turned up; empty at a concave corner. */
export function cornerFabric(
  corner: Corner,
  square: CornerPlan['square'] = {},
): readonly (readonly Point[])[] {
  const frame = frameOf(corner, 'before');
  if (frame.other.normal[0] < least || frame.width + frame.other.width === 0) return [];
  const real = (points: readonly Point[], of: Frame) => points.map((p) => fromFrame(corner, of, p));
  let fabric = real(mitre(frame), frame);
  const more: (readonly Point[])[] = [];
  for (const own of ['before', 'after'] as const) {
    const reach = square[own];
    if (reach === undefined) continue;
    const of = frameOf(corner, own);
    const [kept = [], ...added] = squared(
      of,
      reach,
      fabric.map((p) => intoFrame(corner, of, p)),
    );
    fabric = real(kept, of);
    more.push(...added.map((points) => real(points, of)), longer(corner, own, reach));
  }
  return [fabric, ...more];
}

/**
 * Polygons at a hem's end: additions to its allowance, subtractions from it, and additions to the
 * other edge's.
 */
interface Turned {
  readonly more: readonly Point[];
  readonly less: readonly Point[];
  readonly beside: readonly Point[];
}

/**
 * The corner of a hem. The folded hem covers the piece, so beyond its seam line the other cut line
 * continues as its mirror image.
 * @param otherCut the other edge's cut line, starting at the corner
 */
export function turnedCorner(
  corner: Corner,
  own: Own,
  otherCut: readonly Point[],
): Turned | undefined {
  const frame = frameOf(corner, own);
  const {width, other} = frame;
  if (other.normal[0] < leastTurned || width === 0) return undefined;
  const start = acrossAt(frame, 0);
  const image: Point[] = [[start, 0]];
  for (const p of otherCut) {
    const [x, y] = intoFrame(corner, frame, p);
    const [, last] = image.at(-1) ?? [start, 0];
    if (-y > last + least) image.push([x, -y]);
    if (-y > width) break;
  }
  // a line shorter than the hem's depth continues in its last direction
  const [[x1, y1] = [start, 0], [x0, y0] = [start - other.normal[1], -other.normal[0]]] = image
    .slice(-2)
    .reverse();
  const end = 1.2 * width;
  if (y1 < end) image.push([x1 + ((end - y1) * (x1 - x0)) / (y1 - y0 || 1), end]);
  const far = Math.max(...image.map(([x]) => x)) + 1;
  const beyond = far + Math.max(0, ...image.map(([x]) => -x)) + 1;
  const last = image.at(-1)?.[1] ?? end;
  const real = (points: readonly Point[]) => points.map((p) => fromFrame(corner, frame, p));
  return {
    more: real([
      [0, 0],
      [0, width],
      [far, width],
      [far, 0],
    ]),
    less: real([...image, [beyond, last], [beyond, 0 - overlap], [start, 0 - overlap]]),
    beside: real([
      [0, 0],
      [start, 0],
      [other.width * other.normal[0], other.width * other.normal[1]],
    ]),
  };
}

/** The allowance along an edge, between sewn line and cut line. Lengths in cm. */
export interface Band {
  /** Counter-clockwise polygons that cover the allowance. */
  readonly fabric: readonly (readonly Point[])[];
  /** The cut line from the edge's start to its end. */
  readonly cut: readonly Point[];
}

/** A segment of the edge. */
interface Step {
  readonly from: Point;
  readonly to: Point;
  readonly out: Point;
}

/** Greatest total turn of a band as one polygon; beyond it, the cut line may cross itself. [rad] */
const greatestTurn = 2.2;
/** Segments with a smaller 1 + cosine of their turn form a corner. */
const leastBend = 0.6;

/** Points of the cut line at a point of the edge: one, or two at a corner. */
function feet(
  at: Point,
  width: number,
  before: Step | undefined,
  after: Step | undefined,
): Point[] {
  const [one, two] = [before ?? after, after ?? before];
  if (!one || !two) return [];
  const bend = 1 + dot(one.out, two.out);
  if (bend < leastBend) return [plus(at, one.out, width), plus(at, two.out, width)];
  return [plus(at, plus(one.out, two.out), width / bend)];
}

/**
 * The band of an edge, without its corners.
 * @param points from start to end, with the piece to the left
 */
export function bandOf(points: readonly Point[], width: number): Band {
  const steps = points.slice(1).map((to, k): Step => {
    const from = points[k] ?? to;
    return {from, to, out: outOf(unit(minus(to, from)))};
  });
  const cut = points.map((at, k) => feet(at, width, steps[k - 1], steps[k]));
  const line = cut.flat();
  if (width === 0) return {fabric: [], cut: line};
  const turn = steps.slice(1).reduce((sum, {out}, k) => {
    return sum + Math.abs(turnBetween(steps[k]?.out ?? out, out));
  }, 0);
  const runsOn = steps.every(({from, to}, k) => {
    const [a, b] = [cut[k]?.at(-1), cut[k + 1]?.[0]];
    return a && b && dot(minus(b, a), minus(to, from)) > 0;
  });
  if (runsOn && turn < greatestTurn)
    return {fabric: [[...line, ...[...points].reverse()]], cut: line};
  const fabric = steps.flatMap(({from, to, out}, k) => {
    const [first, last] = [plus(from, out, width), plus(to, out, width)];
    const next = steps[k + 1]?.out;
    const wedge =
      next && cross(out, next) > 0
        ? [[to, last, ...(cut[k + 1] ?? []), plus(to, next, width)]]
        : [];
    return [[first, last, to, from], ...wedge];
  });
  return {fabric, cut: line};
}
