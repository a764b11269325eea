/** Features of a drape's fabric that only its drawing needs. */
import {expect, it} from 'vitest';

import type {DrapeMesh} from '@/model/result/draped-garment.js';
import {hemPlaces, hemReach, hollows, openEdges} from '@/viewer/drape/relief.js';

/** Squares of 10 cm with a vertex in the middle, sewn along a common side. */
const shape = Float64Array.of(0, 0, 10, 0, 10, 10, 0, 10, 5, 5);
const square = (name: string, sewn: readonly number[]): DrapeMesh['pieces'][number] => ({
  ...{name, rest: shape, shape, sewn: Uint32Array.from(sewn)},
  triangles: Uint32Array.of(0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4),
  ...{outline: Uint32Array.of(0, 1, 2, 3), resultVertices: Uint32Array.of(0, 1, 2, 3)},
  ...{grainAngle: Math.PI / 2, layer: 0, part: 'torso'},
});
const mesh: DrapeMesh = {
  pieces: [square('a', [0, 1, 2, 3, 4]), square('b', [1, 5, 6, 2, 7])],
  seams: [
    {
      a: {piece: 0, vertices: Uint32Array.of(1, 2)},
      b: {piece: 1, vertices: Uint32Array.of(0, 3)},
    },
  ],
  mirrors: [],
  size: 8,
};

it('knows the edges that no seam joins, and where they are on the outline', () => {
  expect(openEdges(mesh)).toEqual([
    {piece: 0, from: 0, to: 1, run: 0},
    {piece: 0, from: 2, to: 3, run: 20},
    {piece: 0, from: 3, to: 0, run: 30},
    {piece: 1, from: 0, to: 1, run: 0},
    {piece: 1, from: 1, to: 2, run: 10},
    {piece: 1, from: 2, to: 3, run: 20},
  ]);
});

it('measures the distance to the nearest of them, as far as a hem reaches', () => {
  const near = {...square('a', []), shape: Float64Array.of(...shape.slice(0, 8), 6, 1.5)};
  expect([...hemPlaces(near, [{piece: 0, from: 0, to: 1, run: 3}])]).toEqual([
    ...[0, 3, 0, 13],
    ...[hemReach, 0, hemReach, 0],
    ...[1.5, 9],
  ]);
});

it('finds the depth of a fold hollow, its ridge the contrary, and a plane neither', () => {
  const up = Float32Array.from({length: 15}, (_, k) => (k % 3 === 2 ? 1 : 0));
  const triangles = square('a', []).triangles;
  const depthOf = (middle: number): number => {
    const positions = Float32Array.of(0, 0, 0, 10, 0, 0, 10, 10, 0, 0, 10, 0, 5, 5, middle);
    const into = new Float32Array(5);
    hollows(positions, up, triangles, into);
    return into[4] ?? 0;
  };
  expect([depthOf(-1), depthOf(0), depthOf(1)].map(Math.sign)).toEqual([1, 0, -1]);
});
