import {expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import {movementOf, movementStrokes} from '@/viewer/movement.js';
import {sceneOf} from '@/scene/scene.js';
import {
  plainPrint as print,
  square,
  squarePair,
  squarePiece,
} from '../../support/garments/two-squares.js';

/** The upper right corner of the second square is pulled to the right by 4 mm. */
const shape: Point[] = square.map(([x, y], k) => [k === 2 ? x + 0.4 : x, y]);
const pieces = [squarePiece('left_half'), squarePiece('right_half', {shape})];

it('finds where a pattern moved most, and a factor that shows it', () => {
  const {factor, greatest} = movementOf(pieces);
  expect(greatest).toMatchObject({piece: 1, point: [4, 4]});
  expect(greatest.cm).toBeCloseTo(0.4, 12);
  expect(factor).toBe(10);
});

it('has nothing to exaggerate where nothing moved', () => {
  expect(movementOf([squarePiece('only')]).greatest.cm).toBe(0);
});

it('draws an arrow from the drafted outline, as many times as long as the way', () => {
  const scene = sceneOf(squarePair({pieces}), print);
  const [x, y] = scene.pieces[1]?.offset ?? [NaN, NaN];
  const arrows = movementStrokes(scene, 5, 'light').filter(
    ({points, closed}) => !closed && points.length === 2,
  );
  for (const {points} of arrows) {
    expect(points[0]).toEqual([4 + x, 4 + y]);
    expect((points[1]?.[0] ?? NaN) - (points[0]?.[0] ?? NaN)).toBeCloseTo(2, 12);
    expect(points[1]?.[1]).toBeCloseTo(4 + y, 12);
  }
  expect(arrows.length).toBeGreaterThan(0);
});
