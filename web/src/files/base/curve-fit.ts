/** Fits a chain of few cubics through many points. */
import {
  between,
  distance,
  dot,
  minus,
  nearestShare,
  turnBetween,
  type Point,
} from '../../model/geometry/vectors.js';
import {straight, type CubicFrom} from './bezier.js';

/**
 * Greatest number of fitting rounds, each with the points reassigned to their nearest parameters.
 */
const rounds = 24;

/** Number of further rounds once a fit is within tolerance. */
const polish = 4;

/** A fit is abandoned if it is off by more than `times` tolerances after `after` rounds. */
const hopeless = {after: 8, times: 8};

/**
 * Greatest bow of a curve between points, in tolerances; wider gaps between points represent
 * straight lines.
 */
const mostBow = 3;

/** A segment longer than the usual one by this factor is straight, and gets intermediate points. */
const longStep = 3;
const mostParts = 64;

/**
 * A chain of curves through points, with a deviation of at most `tolerance` at each of them. The
 * ends are kept; corners have to be ends of lines already.
 * @param points at least two, in the unit of the tolerance
 */
export function pathThrough(points: readonly Point[], tolerance: number): CubicFrom[] {
  const line = withStraightSteps(points);
  const xs = Float64Array.from(line, ([x]) => x);
  const ys = Float64Array.from(line, ([, y]) => y);
  const turns = line.map((at, k) => {
    const [before, after] = [line[k - 1], line[k + 1]];
    return before && after ? Math.abs(turnBetween(minus(at, before), minus(after, at))) : 0;
  });
  const bows = Float64Array.from(line, (at, k) => {
    const length = distance(line[k - 1] ?? at, at);
    const turn = Math.max(turns[k - 1] ?? 0, turns[k] ?? 0);
    return Math.min((length / 4) * turn, mostBow * tolerance);
  });
  return fitted({xs, ys, bows}, tolerance);
}

/** Points as columns, since curves are fitted to thousands of points. */
interface Columns {
  readonly xs: Float64Array;
  readonly ys: Float64Array;
  /** Greatest bow of the curve from the line to each point: twice that of an arc. */
  readonly bows: Float64Array;
}

const pointOf = ({xs, ys}: Columns, k: number): Point => [xs[k] ?? 0, ys[k] ?? 0];

function fitted(points: Columns, tolerance: number): CubicFrom[] {
  const last = points.xs.length - 1;
  const {cubic, off, at} = hopelessFit(points, tolerance) ?? oneCurve(points, tolerance);
  if (off <= tolerance || last < 2)
    return [last < 2 ? straight(pointOf(points, 0), cubic[2]) : cubic];
  const part = (from: number, to: number): Columns => ({
    xs: points.xs.subarray(from, to + 1),
    ys: points.ys.subarray(from, to + 1),
    bows: points.bows.subarray(from, to + 1),
  });
  return [...fitted(part(0, at), tolerance), ...fitted(part(at, last), tolerance)];
}

/** Greatest number of points of a trial. */
const trialPoints = 48;

/**
 * The fit through some of very many points if it misses even these; undefined otherwise. It spares
 * the rounds with all points, since a line of thousands of points takes many curves.
 */
function hopelessFit({xs, ys, bows}: Columns, tolerance: number): Fit | undefined {
  const count = xs.length;
  if (count <= 4 * trialPoints) return undefined;
  const index = Int32Array.from({length: trialPoints}, (_, k) =>
    Math.round((k * (count - 1)) / (trialPoints - 1)),
  );
  const some = (all: Float64Array): Float64Array => Float64Array.from(index, (k) => all[k] ?? 0);
  const fit = oneCurve({xs: some(xs), ys: some(ys), bows: some(bows).fill(Infinity)}, tolerance);
  return fit.off > tolerance ? {...fit, at: index[fit.at] ?? 1} : undefined;
}

/** Adds points to long straight segments, since a fitted curve could swing between its points. */
function withStraightSteps(points: readonly Point[]): readonly Point[] {
  const lengths = points.slice(1).map((to, k) => distance(points[k] ?? to, to));
  const usual = [...lengths].sort((a, b) => a - b)[Math.floor(lengths.length / 2)] ?? 0;
  if (lengths.length < 2) return points;
  return points.flatMap((to, k) => {
    const from = points[k - 1];
    const length = lengths[k - 1] ?? 0;
    if (!from || length <= longStep * usual) return [to];
    const parts = Math.min(mostParts, Math.ceil(length / usual));
    return Array.from({length: parts}, (_, j) => between(from, to, (j + 1) / parts));
  });
}

/** The control points of a curve and its deviation. */
interface Fit {
  readonly cubic: CubicFrom;
  readonly off: number;
  /** The index of the point with the largest deviation, excluding the ends. */
  readonly at: number;
}

/** The best curve from the first to the last point, or one within tolerance. */
function oneCurve(points: Columns, tolerance: number): Fit {
  const last = points.xs.length - 1;
  const [start, end] = [pointOf(points, 0), pointOf(points, last)];
  const [first, second] = straight(start, end);
  const controls = Float64Array.of(...start, ...first, ...second, ...end);
  const at = shares(points);
  let best = fitOf(points, at, controls);
  let more = best.off > tolerance ? rounds : 0;
  for (let round = 0; round < more; round++) {
    // minimises distances from the points first, then from the tangents, along which points may
    // slide
    if (!improve(points, at, controls, round === 0)) break;
    moveAlong(points, at, controls);
    moveAlong(points, at, controls);
    const fit = fitOf(points, at, controls);
    // a fit within tolerance is refined further, so that it does not depend on the unit
    if (fit.off <= tolerance) more = Math.min(more, round + 1 + polish);
    if (fit.off < best.off) best = fit;
    if (round >= hopeless.after && best.off > hopeless.times * tolerance) break;
  }
  return best;
}

/** The position of each point as a share of the whole length. */
function shares({xs, ys}: Columns): Float64Array {
  const at = new Float64Array(xs.length);
  for (let k = 1; k < at.length; k++) {
    const step = Math.hypot((xs[k] ?? 0) - (xs[k - 1] ?? 0), (ys[k] ?? 0) - (ys[k - 1] ?? 0));
    at[k] = (at[k - 1] ?? 0) + step;
  }
  const length = at.at(-1) ?? 0;
  return at.map((one) => one / (length || 1));
}

/** One coordinate of a curve at a parameter, and its first two derivatives. */
function axisAt(
  controls: Float64Array,
  axis: 0 | 1,
  t: number,
): [value: number, slope: number, bend: number] {
  const u = 1 - t;
  const a = controls[axis] ?? 0;
  const b = controls[2 + axis] ?? 0;
  const c = controls[4 + axis] ?? 0;
  const d = controls[6 + axis] ?? 0;
  const [ab, bc, cd] = [b - a, c - b, d - c];
  return [
    a * u * u * u + 3 * b * u * u * t + 3 * c * u * t * t + d * t * t * t,
    3 * (ab * u * u + 2 * bc * u * t + cd * t * t),
    6 * ((bc - ab) * u + (cd - bc) * t),
  ];
}

/**
 * Returns whether a curve leaves an end against the way of its points, as one that overshoots the
 * corner there.
 */
function isBackwards({xs, ys}: Columns, controls: Float64Array): boolean {
  const last = xs.length - 1;
  const way = (from: number, to: number): Point => [
    (xs[to] ?? 0) - (xs[from] ?? 0),
    (ys[to] ?? 0) - (ys[from] ?? 0),
  ];
  const handle = (from: number, to: number): Point => [
    (controls[2 * to] ?? 0) - (controls[2 * from] ?? 0),
    (controls[2 * to + 1] ?? 0) - (controls[2 * from + 1] ?? 0),
  ];
  return dot(handle(0, 1), way(0, 1)) < 0 || dot(handle(3, 2), way(last, last - 1)) < 0;
}

function fitOf(points: Columns, at: Float64Array, controls: Float64Array): Fit {
  const {xs, ys} = points;
  let off = 0;
  let number = 1;
  for (let k = 1; k < at.length; k++) {
    const swing = swingTo(points, at, controls, k);
    const t = at[k] ?? 0;
    const [[x], [y]] = [axisAt(controls, 0, t), axisAt(controls, 1, t)];
    const away = Math.max(Math.hypot(x - (xs[k] ?? 0), y - (ys[k] ?? 0)), swing);
    if (away > off) [off, number] = [away, Math.min(k, at.length - 2)];
  }
  const [, , ax = 0, ay = 0, bx = 0, by = 0, x = 0, y = 0] = controls;
  const cubic: CubicFrom = [
    [ax, ay],
    [bx, by],
    [x, y],
  ];
  return {cubic, off: isBackwards(points, controls) ? Infinity : off, at: number};
}

/** Distance by which the curve exceeds its allowed bow from the line to a point. */
function swingTo(
  {xs, ys, bows}: Columns,
  at: Float64Array,
  controls: Float64Array,
  k: number,
): number {
  const t = ((at[k - 1] ?? 0) + (at[k] ?? 0)) / 2;
  const p: Point = [axisAt(controls, 0, t)[0], axisAt(controls, 1, t)[0]];
  const [from, to]: [Point, Point] = [
    [xs[k - 1] ?? 0, ys[k - 1] ?? 0],
    [xs[k] ?? 0, ys[k] ?? 0],
  ];
  return distance(p, between(from, to, nearestShare(from, to, p))) - (bows[k] ?? 0);
}

/** One Newton step for each point towards the parameter nearest to it. */
function moveAlong({xs, ys}: Columns, at: Float64Array, controls: Float64Array): void {
  for (let k = 1; k + 1 < at.length; k++) {
    const t = at[k] ?? 0;
    const [x, dx, ddx] = axisAt(controls, 0, t);
    const [y, dy, ddy] = axisAt(controls, 1, t);
    const [ox, oy] = [x - (xs[k] ?? 0), y - (ys[k] ?? 0)];
    const slope = dx * dx + dy * dy + ox * ddx + oy * ddy;
    const moved = slope > 0 ? t - (ox * dx + oy * dy) / slope : t;
    at[k] = Math.max(0, Math.min(1, moved));
  }
}

/**
 * Least squares for the four coordinates of both inner control points.
 * @returns whether the system could be solved
 */
function improve(
  {xs, ys}: Columns,
  at: Float64Array,
  controls: Float64Array,
  isByPoints: boolean,
): boolean {
  const rows = new Float64Array(20); // four rows of the normal equations, each with its right side
  const row = new Float64Array(5);
  const add = (p: number, q: number, r: number, s: number, side: number): void => {
    [row[0], row[1], row[2], row[3], row[4]] = [p, q, r, s, side];
    for (let i = 0; i < 4; i++) {
      for (let j = 0; j < 5; j++) {
        rows[5 * i + j] = (rows[5 * i + j] ?? 0) + (row[i] ?? 0) * (row[j] ?? 0);
      }
    }
  };
  for (let k = 1; k + 1 < at.length; k++) {
    const t = at[k] ?? 0;
    const u = 1 - t;
    const [a, b] = [3 * u * u * t, 3 * u * t * t];
    const [x, dx] = axisAt(controls, 0, t);
    const [y, dy] = axisAt(controls, 1, t);
    const [ox, oy] = [(xs[k] ?? 0) - x, (ys[k] ?? 0) - y];
    if (isByPoints) {
      add(a, 0, b, 0, ox);
      add(0, a, 0, b, oy);
    } else {
      const length = Math.hypot(dx, dy) || 1;
      const [nx, ny] = [0 - dy / length, dx / length];
      add(a * nx, a * ny, b * nx, b * ny, nx * ox + ny * oy);
    }
  }
  const step = solved(rows);
  step?.forEach((by, k) => (controls[k + 2] = (controls[k + 2] ?? 0) + by));
  return step !== undefined;
}

/**
 * Share of the trace added to the diagonal: along a straight line, the control points are
 * undetermined.
 */
const damping = 1e-7;

/** Gaussian elimination for a matrix that damping makes positive definite. */
function solved(rows: Float64Array): number[] | undefined {
  const get = (i: number, j: number): number => rows[5 * i + j] ?? 0;
  const trace = get(0, 0) + get(1, 1) + get(2, 2) + get(3, 3);
  if (!(trace > 0)) return undefined;
  for (let i = 0; i < 4; i++) rows[6 * i] = get(i, i) + damping * trace;
  for (let i = 0; i < 4; i++) {
    for (let r = i + 1; r < 4; r++) {
      const factor = get(r, i) / get(i, i);
      for (let j = i; j < 5; j++) rows[5 * r + j] = get(r, j) - factor * get(i, j);
    }
  }
  const values = [0, 0, 0, 0];
  for (let i = 3; i >= 0; i--) {
    let rest = get(i, 4);
    for (let j = i + 1; j < 4; j++) rest -= get(i, j) * (values[j] ?? 0);
    values[i] = rest / get(i, i);
  }
  return values.every(Number.isFinite) ? values : undefined;
}
