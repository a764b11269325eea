/** Points and directions in space: y up, z to the front, +x to the wearer's left. [cm] */
export type Vector = readonly [x: number, y: number, z: number];

export const dot3 = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

export const minus3 = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

export const plus3 = (a: Vector, b: Vector, factor = 1): Vector => [
  a[0] + factor * b[0],
  a[1] + factor * b[1],
  a[2] + factor * b[2],
];

export const cross3 = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** Returns a vector of length 1; the zero vector stays zero. */
export function unit3(a: Vector): Vector {
  const length = Math.hypot(...a) || 1;
  return [a[0] / length, a[1] / length, a[2] / length];
}

/** Returns one point of an array of x, y, z triples. */
export const pointOf = (points: ArrayLike<number>, number: number): Vector => [
  points[3 * number] ?? 0,
  points[3 * number + 1] ?? 0,
  points[3 * number + 2] ?? 0,
];

/** A box with sides along the axes. */
export interface Box3 {
  readonly low: Vector;
  readonly high: Vector;
}

/** Returns the bounding box of points, as x, y, z triples, and a box; undefined without any. */
export function boxAround(points: ArrayLike<number>, box?: Box3): Box3 | undefined {
  const low = [...(box?.low ?? [Infinity, Infinity, Infinity])];
  const high = [...(box?.high ?? [-Infinity, -Infinity, -Infinity])];
  for (let k = 0; k < points.length; k++) {
    const value = points[k] ?? 0;
    const axis = k % 3;
    if (value < (low[axis] ?? 0)) low[axis] = value;
    if (value > (high[axis] ?? 0)) high[axis] = value;
  }
  if ((low[0] ?? 0) > (high[0] ?? 0)) return undefined;
  return {low: low as [number, number, number], high: high as [number, number, number]};
}

/** Returns the greatest distance between corresponding sides of two boxes. [cm] */
export const boxDistance = (one: Box3, other: Box3): number =>
  Math.max(
    ...one.low.map((value, k) => Math.abs(value - (other.low[k] ?? 0))),
    ...one.high.map((value, k) => Math.abs(value - (other.high[k] ?? 0))),
  );
