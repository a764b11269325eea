/** Proposed grain lines for pieces of a file without grain. */
import {describe, expect, it} from 'vitest';

import type {Mirror} from '@/workbench/mirrors.js';
import {grainProposals, wayOf, withImage} from '@/workbench/tools/grain-proposals.js';
import type {Placement} from '@/model/garment/garment-document.js';
import type {PanelMarks} from '@/model/garment/panel-marks.js';
import {squarePiece} from '../../support/garments/two-squares.js';

const placed = (translation: Placement['translation'], rotation: Placement['rotation']) => ({
  placement: {translation, ...(rotation && {rotation})},
});
const proposed = (
  name: string,
  marks: Partial<PanelMarks>,
  {mirrors = []}: {mirrors?: readonly Mirror[]} = {},
): number | undefined =>
  grainProposals([squarePiece(name)], new Map([[name, {label: name, ...marks}]]), mirrors).get(
    name,
  );

describe('the grain of a piece that nobody states', () => {
  it('is proposed upwards where nothing tells more', () => {
    expect(proposed('front', {})).toBe(90);
    expect(proposed('front', placed([0, 100, 20], [0, 0, 0]))).toBe(90);
    expect(proposed('back', placed([0, 100, -20], [0, 180, 0]))).toBe(90);
  });

  it('runs up on the body, also where a piece is drawn upside down or on its side', () => {
    expect(proposed('back', placed([0, 100, -20], [180, 0, 0]))).toBe(270);
    expect(proposed('front', placed([0, 100, 20], [0, 0, 90]))).toBe(0);
    expect(proposed('front', placed([0, 100, 20], [0, 0, -90]))).toBe(180);
  });

  it('runs along a sleeve that lies sideways in the drawing, however the arm is held', () => {
    for (const slope of [0, 20, 50]) {
      expect(proposed('left_sleeve_f', placed([40, 120, 5], [0, 0, -slope])), `${slope}`).toBe(180);
      expect(proposed('right_sleeve_f', placed([-40, 120, 5], [0, 0, slope])), `${slope}`).toBe(0);
    }
  });

  it('is as drawn on a sleeve that stands upright in the drawing', () => {
    expect(proposed('sleeve_left', placed([40, 120, 5], [0, 90, 45]))).toBe(90);
    expect(proposed('sleeve_right', placed([-40, 120, 5], [0, -90, -45]))).toBe(90);
  });

  it('runs the other way on a piece that is turned over', () => {
    expect(proposed('left_sleeve_b', placed([40, 120, 5], [0, 180, -20]))).toBe(0);
  });

  it('runs along the axis of a piece that mirrors onto itself', () => {
    const map = {angle: Math.PI / 9, translation: [0, 0]} as const; // the axis leans by 10 degrees
    const mirrors = [{kind: 'piece', piece: 'front', map}] as const;
    expect(proposed('front', {}, {mirrors})).toBeCloseTo(100, 9);
  });

  it('is the mirror image on the second of a pair, there and back', () => {
    const map = {angle: 0.3, translation: [1, 2]} as const;
    const mirrors = [{kind: 'pair', pieces: ['a', 'b'], map}] as const;
    const {a = NaN, b = NaN} = withImage('a', 70, mirrors);
    expect([a, b]).toEqual([70, expect.closeTo(110 + (0.3 * 180) / Math.PI, 9)]);
    expect(withImage('b', b, mirrors).a).toBeCloseTo(70, 9);
  });

  it('is not asked for where the file states it', () => {
    const grain = [
      [0, 0],
      [0, 4],
    ] as const;
    expect(proposed('front', {grain})).toBeUndefined();
  });

  it('is told by the words for its direction', () => {
    expect([90, 0, 45, 270, 180, 450].map(wayOf)).toEqual([
      ...['up', 'across', 'bias', undefined, undefined, 'up'],
    ]);
  });
});
