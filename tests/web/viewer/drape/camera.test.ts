/** Camera positions for a drape, and the piece under a point of its image. */
import {expect, it} from 'vitest';

import {
  eyeOf,
  facing,
  keyTurn,
  movedBy,
  nearer,
  nearestPreset,
  onTheWay,
  presetNames,
  presetOrbit,
  turned,
} from '@/viewer/drape/camera.js';
import {firstHit, nearestSeam, projected, rayThrough} from '@/viewer/drape/drape-picker.js';
import type {Box3, Vector} from '@/viewer/drape/space.js';

const box: Box3 = {low: [-30, 60, -15], high: [30, 150, 18]};
const size = {width: 600, height: 450};
const corners: Vector[] = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [
  k & 1 ? 30 : -30,
  k & 2 ? 150 : 60,
  k & 4 ? 18 : -15,
]);

it('sees the wearer’s left from the left, and all of the garment from everywhere', () => {
  const aspect = size.width / size.height;
  expect(eyeOf(presetOrbit('front', box, aspect))[2]).toBeGreaterThan(100);
  expect(eyeOf(presetOrbit('back', box, aspect))[2]).toBeLessThan(-100);
  expect(eyeOf(presetOrbit('left', box, aspect))[0]).toBeGreaterThan(100);
  expect(eyeOf(presetOrbit('right', box, aspect))[0]).toBeLessThan(-100);
  for (const preset of presetNames)
    for (const room of [size, {width: 390, height: 700}]) {
      const orbit = presetOrbit(preset, box, room.width / room.height);
      for (const corner of corners) {
        const [x, y] = projected(corner, orbit, room).at;
        expect(x).toBeGreaterThan(0);
        expect(x).toBeLessThan(room.width);
        expect(y).toBeGreaterThan(0);
        expect(y).toBeLessThan(room.height);
      }
    }
});

it('turns a whole turn by 24 keys, never over the top, and goes the shorter way', () => {
  const start = presetOrbit('right', box, 1);
  let orbit = start;
  for (let k = 0; k < 24; k++) orbit = turned(orbit, keyTurn);
  expect(orbit.azimuth).toBeCloseTo(start.azimuth, 10);
  expect(turned(orbit, 0, 9).elevation).toBeLessThan(Math.PI / 2);
  const [one, other] = [
    {...start, azimuth: 3},
    {...start, azimuth: -3},
  ];
  expect(Math.abs(onTheWay(one, other, 0.5).azimuth)).toBeCloseTo(Math.PI, 6);
  expect(onTheWay(one, other, 1).azimuth).toBeCloseTo(-3, 10);
});

it('calls a view by the preset that is nearest', () => {
  for (const preset of presetNames) expect(nearestPreset(presetOrbit(preset, box, 1))).toBe(preset);
  expect(nearestPreset(turned(presetOrbit('back', box, 1), 0.3))).toBe('back');
  expect(nearestPreset(facing(presetOrbit('front', box, 1), [1, 0.2, 0]))).toBe('left');
});

it('comes no nearer than to see cloth, and goes no further than to see it', () => {
  const orbit = presetOrbit('front', box, 1);
  expect(nearer(orbit, 1e6, orbit.distance).distance).toBeGreaterThan(10);
  expect(nearer(orbit, 1e-6, orbit.distance).distance).toBeLessThan(3 * orbit.distance);
});

it('moves in the plane of the picture, and keeps the garment in it', () => {
  const orbit = turned(presetOrbit('left', box, 1), 0.3, 0.2);
  const [before] = [projected(orbit.target, orbit, size).at];
  const moved = projected(orbit.target, movedBy(orbit, box, 5, -3), size).at;
  expect(moved[0]).toBeLessThan(before[0] - 5);
  expect(moved[1]).toBeLessThan(before[1] - 3);
  const far = movedBy(orbit, box, 1e4, 1e4).target;
  expect(far.every((one, k) => one >= (box.low[k] ?? 0) && one <= (box.high[k] ?? 0))).toBe(true);
});

it('looks along the ray that a point of the picture is seen by', () => {
  const orbit = turned(presetOrbit('three-quarter', box, 4 / 3), 0.4, 0.2);
  const point: Vector = [7, 111, 13];
  const {at, distance} = projected(point, orbit, size);
  const {origin, way} = rayThrough(at, orbit, size);
  for (const k of [0, 1, 2] as const)
    expect(origin[k] + distance * way[k]).toBeCloseTo(point[k], 6);
});

it('hits the nearest triangle from either side, and seams within reach on this side alone', () => {
  // two squares, one behind the other, a seam along the left side of each
  const positions = Float32Array.of(
    ...[-10, 90, 10, 10, 90, 10, 10, 110, 10, -10, 110, 10],
    ...[-10, 90, -10, 10, 90, -10, 10, 110, -10, -10, 110, -10],
  );
  const triangles = [0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6];
  const orbit = {azimuth: 0, elevation: 0, distance: 200, target: [0, 100, 0] as const};
  const look = (x: number, y: number) =>
    firstHit(rayThrough([x, y], orbit, size), positions, triangles);
  const hit = look(301, 220);
  expect(hit?.triangle).toBeLessThan(2);
  expect(hit?.distance).toBeCloseTo(190, 0);
  expect(look(20, 20)).toBeUndefined();
  if (!hit) return;
  const edge = projected([-10, 100, 10], orbit, size).at;
  const lines = [
    {seam: 4, vertices: [0, 3]},
    {seam: 7, vertices: [4, 7]},
  ];
  const near = (px: number) =>
    nearestSeam(lines, positions, [edge[0] + px, edge[1]], hit, 6, (point) =>
      projected(point, orbit, size),
    );
  expect(near(5)).toBe(4);
  expect(near(7)).toBeUndefined();
});
