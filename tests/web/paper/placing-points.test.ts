/** Points by which a paper piece is placed on printed fabric. */
import {expect, it} from 'vitest';

import {onPrint, type Point} from '@/model/geometry/vectors.js';
import type {Print} from '@/model/print/repeating-print.js';
import {onSheet} from '@/paper/cell.js';
import {motifsOf, nearestMotif} from '@/paper/guide-motifs.js';
import {placingPoints} from '@/paper/placing-points.js';
import {sheetTextsIn} from '@/texts/sheet-texts.js';
import {vectorTile} from '@/paper/vector-tile.js';

import {laidRectangle} from '../../support/paper/cut-sheets.js';

const print: Print = {group: 'p1', w1: [8, 0], w2: [0, 6]};
const leavesOf = (svg: string) =>
  (vectorTile(`<svg viewBox="0 0 8 6">${svg}</svg>`, 8, 6) ?? []).flatMap(({leaves}) => leaves);
/** A flower, y down, among dots. */
const flower = leavesOf(
  `<rect width="8" height="6"/><circle cx="5" cy="4" r="1.5" fill="#c22"/><circle cx="5" cy="4" r=".4" fill="#fc3"/>${[1, 2, 3].map((x) => `<circle cx="${x}" cy="1" r=".3" fill="#22c"/>`).join('')}`,
);

const share = (value: number): number => value - Math.round(value);

it('are corners far apart, each with the middle of the nearest flower', () => {
  const alignment = {angle: 0.4, translation: [1, 2]} as const;
  const place = {angle: Math.PI, translation: [30, 20]} as const;
  const piece = laidRectangle(30, 20, {place, alignment});
  const points = placingPoints(piece, alignment, motifsOf(print, flower), {
    ...{count: 3, texts: sheetTextsIn()},
  });
  expect(points.length).toBeGreaterThanOrEqual(2);
  expect(points[0]?.name).toMatch(/^Corner, (upper|lower) (left|right)$/);
  for (const {at, motif} of points) {
    const [x, y] = onPrint(onSheet(place, alignment), motif);
    expect(share((x - 5) / 8)).toBeCloseTo(0, 9);
    expect(share((y - 2) / 6)).toBeCloseTo(0, 9);
    expect(Math.hypot(at[0] - motif[0], at[1] - motif[1])).toBeLessThan(8);
  }
});

it('have the middle of a motif at the origin of a print without shapes', () => {
  const {motifs} = motifsOf(print);
  expect(motifs.map(({at}) => at)).toEqual([[0, 0]]);
});

it('lie across stripes, along which all points are alike', () => {
  const stripes = motifsOf({group: 'pmm', w1: [7, 0], w2: [0, 0.5]});
  const from: Point = [2, 3.3];
  const {at} = nearestMotif(stripes, {angle: 0, translation: [0, 0]}, from);
  expect(at).toEqual([0, 3.3]);
});
