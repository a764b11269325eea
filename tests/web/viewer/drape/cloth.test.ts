/**
 * Rendering of a drape's fabric: shades continue across seams, and the print is that of the flat
 * pattern.
 */
import {expect, it} from 'vitest';

import type {DrapeMesh} from '@/model/result/draped-garment.js';
import {onPrint, coordinates, type Alignment} from '@/model/geometry/vectors.js';
import type {Print} from '@/model/print/repeating-print.js';
import {imageCell} from '@/model/print/wallpaper.js';
import {clothOf, normalsOf, printPlaces, putToDrawn} from '@/viewer/drape/cloth-layer.js';

/**
 * Two squares of 10 cm, side by side and sewn along their common side; they were drafted smaller.
 */
const shape = Float64Array.of(0, 0, 10, 0, 10, 10, 0, 10);
const rest = shape.map((value) => 0.98 * value);
const piece = (name: string, sewn: readonly number[]): DrapeMesh['pieces'][number] => ({
  ...{name, rest, shape, sewn: Uint32Array.from(sewn)},
  triangles: Uint32Array.of(0, 1, 2, 0, 2, 3),
  ...{outline: Uint32Array.of(0, 1, 2, 3), resultVertices: Uint32Array.of(0, 1, 2, 3)},
  ...{grainAngle: Math.PI / 2, layer: 0, part: 'torso'},
});
const mesh: DrapeMesh = {
  pieces: [piece('a', [0, 1, 2, 3]), piece('b', [1, 4, 5, 2])],
  seams: [
    {
      a: {piece: 0, vertices: Uint32Array.of(1, 2)},
      b: {piece: 1, vertices: Uint32Array.of(0, 3)},
    },
  ],
  mirrors: [],
  size: 6,
};
/** A roof: the first square slopes to the front, the second to the back; the seam is the ridge. */
const roof = Float32Array.of(0, 0, 6, 0, 8, 0, 10, 8, 0, 10, 0, 6, 0, 0, -6, 10, 0, -6);

it('splits what is sewn by piece and keeps it in one place', () => {
  const cloth = clothOf(mesh);
  const drawn = new Float32Array(24);
  putToDrawn(cloth, roof, drawn);
  expect([...cloth.pieces]).toEqual([0, 0, 0, 0, 1, 1, 1, 1]);
  expect([...cloth.triangles.slice(6)]).toEqual([4, 5, 6, 4, 6, 7]);
  expect([...drawn.slice(3, 6)]).toEqual([...drawn.slice(12, 15)]);
});

it('shades over a seam as over cloth: by area, the same on both pieces', () => {
  const {welded} = clothOf(mesh);
  const normals = normalsOf(roof, welded);
  const [x, y, z] = [...normals.slice(3, 6)].map(Math.abs);
  expect(Math.hypot(...normals.slice(3, 6))).toBeCloseTo(1, 6);
  // the ridge's normal is vertical, between both sides
  expect(x).toBeLessThan(0.5);
  expect(y).toBeGreaterThan(0.8);
  expect(z).toBeLessThan(0.5);
  // an empty triangle has no normal, and does not affect others
  expect([...normalsOf(new Float32Array(18), welded)].every((one) => one === 0)).toBe(true);
});

it.each([
  ['shape', shape],
  ['rest', rest],
] as const)(
  'lays the %s of every piece on the print as the flat pattern does, but for whole cells',
  (outline, points) => {
    const print: Print = {
      ...{title: 'p', group: 'p1', w1: [7, 1], w2: [2, 6], oneWay: false},
      ...{cell: 'primitive', image: ''},
    };
    const alignments: Alignment[] = [
      {angle: 0.3, translation: [40, -3]},
      {angle: -1.2, translation: [1, 200]},
    ];
    const cloth = clothOf(mesh);
    const places = new Float32Array(16);
    printPlaces(cloth, alignments, print, places, outline);
    for (const [k, number] of [0, 0, 0, 0, 1, 1, 1, 1].entries()) {
      const alignment = alignments[number];
      if (!alignment) throw new Error('no alignment');
      const at = [points[2 * (k % 4)] ?? 0, points[2 * (k % 4) + 1] ?? 0] as const;
      const [u, v] = coordinates(imageCell(print), onPrint(alignment, at));
      const [du, dv] = [(places[2 * k] ?? 0) - u, (places[2 * k + 1] ?? 0) - v];
      expect(du - Math.round(du)).toBeCloseTo(0, 4);
      expect(dv - Math.round(dv)).toBeCloseTo(0, 4);
    }
    expect(Math.max(...places.map(Math.abs))).toBeLessThan(4);
  },
);
