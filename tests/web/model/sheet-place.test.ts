import {describe, expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import {offSheet, ontoSheet, wayOnSheet} from '@/model/geometry/sheet-place.js';
import {lineOf, pieceAt, sceneOf} from '@/scene/scene.js';
import {plainPrint, squarePair} from '../../support/garments/two-squares.js';

const upright = {offset: [3, 4]} as const;
const turned = {offset: [3, 4], isTurned: true} as const;

describe('the place of a piece on its sheet', () => {
  it('shifts what lies upright, and turns the rest about the origin first', () => {
    expect(ontoSheet(upright, [1, 2])).toEqual([4, 6]);
    expect(ontoSheet(turned, [1, 2])).toEqual([2, 2]);
    expect(wayOnSheet(upright, [1, 2])).toEqual([1, 2]);
    expect(wayOnSheet(turned, [1, 2])).toEqual([-1, -2]);
  });

  it.each([upright, turned])('leads back to the coordinates of the piece', (place) => {
    const point: Point = [0.5, -7];
    expect(offSheet(place, ontoSheet(place, point))).toEqual(point);
  });
});

it('is asked by whoever finds pieces and seams on a scene', () => {
  const scene = sceneOf(squarePair(), plainPrint);
  const [first, ...others] = scene.pieces;
  if (!first) throw new Error('There is no piece.');
  const [x, y] = first.points[0] ?? [NaN, NaN];
  const inside: Point = [x + 0.5, y + 0.5];
  const over = {
    ...scene,
    pieces: [{...first, isTurned: true, offset: [50, 50] as const}, ...others],
  };
  expect(pieceAt(over, [50 - inside[0], 50 - inside[1]])).toEqual({piece: 0, point: inside});
  const side = scene.seams[0]?.a ?? {piece: -1, vertices: []};
  expect(side.piece).toBe(0);
  expect(lineOf(over, side)).toEqual(
    side.vertices.map((v) => first.points[v] ?? [NaN, NaN]).map(([px, py]) => [50 - px, 50 - py]),
  );
});
