/** View of flat fabric through a camera. */
import type {Point} from '@/model/geometry/vectors.js';

/** Row by row. */
export type Matrix3 = readonly [
  number,
  number,
  number,
  number,
  number,
  number,
  number,
  number,
  number,
];

/** Map of lattice coordinates (u, v) to the upright image: lens(H (u, v, 1)); y down. [px] */
export interface LatticeView {
  readonly homography: Matrix3;
  /** k of lens(y) = c + (1 + k |y - c|^2 / r^2) (y - c) */
  readonly lens: number;
  /** c [px] */
  readonly lensMiddle: Point;
  /** r, half the longer side of the whole frame. [px] */
  readonly lensRadius: number;
}

interface Pose {
  readonly width: number;
  readonly height: number;
  /** Focal length for 35 mm film: the frame's longer side is 36 mm. */
  readonly f35: number;
  /**
   * Angle between the fabric and the image plane, and direction of the rotation axis in that plane.
   * [rad]
   */
  readonly tilt: number;
  readonly axis: number;
  /** Rotation of the fabric in its plane, counter-clockwise as seen. [rad] */
  readonly turn: number;
  /** Resolution at the image's middle. */
  readonly pxPerCm: number;
  /** Lattice coordinates at the image's middle. */
  readonly middle: Point;
}

const product = (a: Matrix3, b: Matrix3): Matrix3 => {
  const cell = (row: number, column: number): number =>
    [0, 1, 2].reduce((sum, k) => sum + (a[3 * row + k] ?? 0) * (b[3 * k + column] ?? 0), 0);
  // prettier-ignore
  return [
    cell(0, 0), cell(0, 1), cell(0, 2),
    cell(1, 0), cell(1, 1), cell(1, 2),
    cell(2, 0), cell(2, 1), cell(2, 2),
  ];
};

export const inverse = ([a, b, c, d, e, f, g, h, i]: Matrix3): Matrix3 => {
  const det = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  // prettier-ignore
  return [
    (e * i - f * h) / det, (c * h - b * i) / det, (b * f - c * e) / det,
    (f * g - d * i) / det, (a * i - c * g) / det, (c * d - a * f) / det,
    (d * h - e * g) / det, (b * g - a * h) / det, (a * e - b * d) / det,
  ];
};

export function applied(m: Matrix3, [x, y]: Point): Point {
  const w = m[6] * x + m[7] * y + m[8];
  return [(m[0] * x + m[1] * y + m[2]) / w, (m[3] * x + m[4] * y + m[5]) / w];
}

/**
 * Rotation by `tilt` about the axis (cos a, sin a, 0), after a turn in the plane. Camera: x right,
 * y down, z away.
 */
function rotation({tilt, axis, turn}: Pose): Matrix3 {
  const x = Math.cos(axis);
  const y = Math.sin(axis);
  const c = Math.cos(tilt);
  const s = Math.sin(tilt);
  // prettier-ignore
  const tilted: Matrix3 = [
    c + x * x * (1 - c), x * y * (1 - c), y * s,
    x * y * (1 - c), c + y * y * (1 - c), -x * s,
    -y * s, x * s, c,
  ];
  // y down: counter-clockwise as seen is a negative angle
  // prettier-ignore
  const turned: Matrix3 = [
    Math.cos(turn), Math.sin(turn), 0,
    -Math.sin(turn), Math.cos(turn), 0,
    0, 0, 1,
  ];
  return product(tilted, turned);
}

/** H of a pinhole camera directed at the middle: K [R | t] on the fabric's plane. */
export function homographyOf(pose: Pose, w1: Point, w2: Point): Matrix3 {
  const f = (pose.f35 / 36) * Math.max(pose.width, pose.height);
  const away = f / pose.pxPerCm;
  const [u, v] = pose.middle;
  // prettier-ignore
  const onFabric: Matrix3 = [
    w1[0], w2[0], -(u * w1[0] + v * w2[0]),
    -w1[1], -w2[1], u * w1[1] + v * w2[1],
    0, 0, 1,
  ];
  const r = rotation(pose);
  const placed: Matrix3 = [r[0], r[1], 0, r[3], r[4], 0, r[6], r[7], away];
  const k: Matrix3 = [f, 0, pose.width / 2, 0, f, pose.height / 2, 0, 0, 1];
  return scaled(product(k, product(placed, onFabric)));
}

/** Scales the matrix so that its last entry is 1. */
export function scaled(m: Matrix3): Matrix3 {
  const s = 1 / m[8];
  return [m[0] * s, m[1] * s, m[2] * s, m[3] * s, m[4] * s, m[5] * s, m[6] * s, m[7] * s, 1];
}

/**
 * Distance of a ray from the middle without the lens, over that with it, by its squared radius in
 * the image.
 */
export function unlensed({lens, lensRadius}: LatticeView, squared: number): number {
  if (lens === 0 || squared === 0) return 1;
  const k = lens / (lensRadius * lensRadius);
  const r = Math.sqrt(squared);
  let flat = r;
  for (let pass = 0; pass < 8; pass++) {
    flat -= (flat + k * flat ** 3 - r) / (1 + 3 * k * flat * flat);
  }
  return flat / r;
}

/** The same from a table, for every pixel of an image. */
export function unlensedTable(view: LatticeView): (squared: number) => number {
  if (view.lens === 0) return () => 1;
  const steps = 1024;
  const most = 2 * view.lensRadius * view.lensRadius; // the corners
  const table = Float64Array.from({length: steps + 2}, (_, i) =>
    unlensed(view, (most * i) / steps),
  );
  return (squared) => {
    const place = (squared / most) * steps;
    const i = Math.min(steps, Math.floor(place));
    const before = table[i] ?? 1;
    return before + (place - i) * ((table[i + 1] ?? before) - before);
  };
}

/** d(px) / d(u, v) at a point of the image plane before the lens: the columns w1, w2 there. */
export function repeatsAt(h: Matrix3, at: Point): readonly [Point, Point] {
  const [u, v] = applied(inverse(h), at);
  const w = h[6] * u + h[7] * v + h[8];
  const column = (k: 0 | 1): Point => [
    (h[k] - at[0] * (h[6 + k] ?? 0)) / w,
    ((h[3 + k] ?? 0) - at[1] * (h[6 + k] ?? 0)) / w,
  ];
  return [column(0), column(1)];
}
