/** The dummy: its parts meet, face outwards, and are drawn whole. */
import {describe, expect, it} from 'vitest';

import type {Form} from '@/model/result/draped-garment.js';
import {bodyOf, standOf, type Solid} from '@/viewer/drape/dummy.js';
import {solidGeometry} from '@/viewer/drape/studio.js';

/** A prism from 60 to 150 cm above the floor, 20 cm wide and deep, 3 cm before the middle. */
const corners = [
  [-10, -7],
  [-10, 13],
  [0, 13],
  [10, 13],
  [10, -7],
  [0, -7],
] as const;
const vertices = Float32Array.from(
  [60, 150].flatMap((y) => corners.flatMap(([x, z]) => [x, y, z])),
);
const triangles = Uint32Array.from(
  corners.flatMap((_, k) => {
    const next = (k + 1) % corners.length;
    return [k, next, k + 6, k + 6, next, next + 6];
  }),
);
const surface = {vertices, triangles};
const formWith = (waistHeight: number): Form =>
  ({surface, body: {waistHeight, backLength: 40}}) as unknown as Form;

type Vector = readonly [number, number, number];
const vectorAt = (all: ArrayLike<number>, k: number): Vector => [
  all[3 * k] ?? NaN,
  all[3 * k + 1] ?? NaN,
  all[3 * k + 2] ?? NaN,
];
const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Least agreement of the direction that triangles face with the normals of their corners. */
function agreement({positions, normals, triangles: all}: Solid): number {
  let least = Infinity;
  for (let t = 0; t < all.length; t += 3) {
    const [a = 0, b = 0, c = 0] = all.subarray(t, t + 3);
    const [p, q, r] = [a, b, c].map((k) => vectorAt(positions, k)) as [Vector, Vector, Vector];
    const facing = cross(minus(q, p), minus(r, p));
    if (Math.hypot(...facing) < 1e-6) continue; // at the tip of a cone
    for (const k of [a, b, c])
      least = Math.min(least, dot(facing, vectorAt(normals, k)) / Math.hypot(...facing));
  }
  return least;
}

const heights = ({positions}: Solid): readonly number[] => [
  ...positions.filter((_, k) => k % 3 === 1),
];

describe('the dummy', () => {
  it('faces outwards everywhere', () => {
    expect(agreement(bodyOf(surface))).toBeGreaterThan(0.2);
    expect(agreement(standOf(formWith(105), 40).parts)).toBeGreaterThan(0.99);
  });

  it('stands 15 cm above the floor on a pole under its middle, with a cap on its neck', () => {
    const {floor, parts, middle} = standOf(formWith(105), 40);
    expect([floor, middle]).toEqual([25, 3]);
    expect(Math.min(...heights(parts))).toBe(25);
    expect(Math.max(...heights(parts))).toBeCloseTo(155.1, 4);
  });

  it('needs no cap if it has a head', () => {
    const {parts} = standOf(formWith(90), 40);
    expect(Math.max(...heights(parts))).toBe(62); // the pole ends within the body
  });

  it('is drawn with all its triangles', () => {
    const {parts} = standOf(formWith(105), 40);
    const geometry = solidGeometry(parts);
    expect(geometry.getIndex()?.array).toBe(parts.triangles);
    expect(geometry.getAttribute('position').array).toBe(parts.positions);
    expect(geometry.getAttribute('normal').array).toBe(parts.normals);
    expect(geometry.getAttribute('colour').array).toBe(parts.colours);
  });
});
