/** Folds on the cutting sheet. */
import {expect, it} from 'vitest';

import {cutFold, foldArrows, toCutLine} from '@/cutting/fold-marks.js';
import type {DraftedFold} from '@/model/garment/garment-document.js';
import type {Point} from '@/model/geometry/vectors.js';

const fold = (changes: Partial<DraftedFold> = {}): DraftedFold => ({
  kind: 'knife',
  line: [
    [4, 10],
    [4, 0],
  ],
  to: [
    [8, 10],
    [8, 0],
  ],
  ...changes,
});
const drawn = (changes: Partial<DraftedFold> = {}) =>
  cutFold(fold(changes), (p) => p, {units: 'cm', locale: 'en'});

it('names the kind and the fabric between the lines', () => {
  expect(drawn().name).toBe('Knife pleat, 4 cm');
  expect(drawn({kind: 'press'}).name).toBe('Press line');
});

it('lays a knife pleat from one line onto the other', () => {
  const [shaft, head] = foldArrows(drawn());
  expect(shaft).toEqual([
    [4, 5],
    [8, 5],
  ]);
  expect(head?.[1]).toEqual([8, 5]);
});

it('lets the lines of an inverted pleat meet in the middle', () => {
  const tips = foldArrows(drawn({kind: 'inverted'}))
    .filter((line) => line.length === 2)
    .map((line) => line[1]);
  expect(tips).toEqual([
    [6, 5],
    [6, 5],
  ]);
});

it('draws no arrow at a crease', () => {
  expect(foldArrows(drawn({kind: 'roll'}))).toEqual([]);
});

it('extends a line to the cut line where it ends at the sewn line', () => {
  const square = (low: number, high: number): Point[] => [
    [low, low],
    [high, low],
    [high, high],
    [low, high],
  ];
  const lines = {sewn: [square(0, 10)], cut: [square(-1, 11)]};
  const [from, to] = toCutLine(
    [
      [4, 10],
      [4, 3],
    ],
    lines,
  );
  expect(from).toEqual([4, 11]);
  expect(to).toEqual([4, 3]);
});
