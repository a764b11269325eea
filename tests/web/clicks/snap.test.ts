import {describe, expect, it} from 'vitest';

import {pickIndex} from '@/clicks/pick-index.js';
import {snap, type Snapped} from '@/clicks/pick.js';
import type {Point} from '@/model/geometry/vectors.js';
import {rectangle, sheetOf, type DrawnPiece} from '../../support/clickable-sheet.js';

/** A square of 20 cm, with a vertex in the middle of its lower side. */
const square: DrawnPiece = {
  loop: [
    [0, 0],
    [10, 0],
    [20, 0],
    [20, 20],
    [0, 20],
  ],
  edges: [0, 0, 1, 2, 3],
};

const snapped = (
  point: Point,
  {piece = square, notches = []}: {piece?: DrawnPiece; notches?: readonly Point[]} = {},
): Snapped => snap(pickIndex(sheetOf([piece])), 0, point, 2, {notches});

/** A circle of one edge, or of two halves. */
const circle = (edges: (k: number) => number): DrawnPiece => ({
  loop: Array.from({length: 40}, (_, k): Point => {
    const angle = (2 * Math.PI * k) / 40;
    return [10 * Math.cos(angle), 10 * Math.sin(angle)];
  }),
  edges: Array.from({length: 40}, (_, k) => edges(k)),
});

describe('a point of a piece', () => {
  it('snaps to a corner nearby', () => {
    expect(snapped([19, 19])).toEqual({point: [20, 20], snapped: 'corner'});
  });

  it('snaps to a corner nearby from outside', () => {
    expect(snapped([-1, -1])).toEqual({point: [0, 0], snapped: 'corner'});
  });

  it('does not snap to a corner out of reach', () => {
    expect(snapped([17.5, 20])).toEqual({point: [17.5, 20], snapped: 'outline'});
  });

  it('finds corners on a smooth outline where another edge of the file begins', () => {
    const piece = circle((k) => (k < 20 ? 0 : 1));
    expect(snapped([9, 0], {piece})).toEqual({point: [10, 0], snapped: 'corner'});
  });

  it('finds corners where one edge of the file turns sharply', () => {
    const piece = {loop: rectangle(20, 20), edges: [0, 0, 1, 2]};
    expect(snapped([19, 1], {piece})).toEqual({point: [20, 0], snapped: 'corner'});
  });

  it('finds sharp corners without the numbers of edges', () => {
    const piece = {loop: rectangle(20, 20)};
    expect(snapped([19, 1], {piece}).snapped).toBe('corner');
    expect(snapped([10, 1], {piece})).toEqual({point: [10, 0], snapped: 'midpoint'});
  });

  it('finds no new corner where a straight edge was deformed', () => {
    const lowerSide = (middle: Point): readonly Point[] => [
      [0, 0],
      middle,
      [20, 0],
      [20, 20],
      [0, 20],
    ];
    const piece = {loop: lowerSide([5, -8]), rest: lowerSide([5, 0])};
    expect(snapped([5, -9], {piece})).toEqual({point: [5, -8], snapped: 'outline'});
  });

  it('finds no corner on a round piece of one edge', () => {
    const piece = circle(() => 0);
    expect(snapped([9.5, 0], {piece}).snapped).toBe('outline');
  });

  it('snaps to the middle of an edge of the file, which need not be a vertex', () => {
    expect(snapped([19, 9.5])).toEqual({point: [20, 10], snapped: 'midpoint'});
  });

  it('does not take the middle between vertices within an edge for a midpoint', () => {
    expect(snapped([5, 1])).toEqual({point: [5, 0], snapped: 'outline'});
  });

  it('measures the middle of a bent edge along it', () => {
    const piece = circle((k) => (k < 20 ? 0 : 1));
    const {point, snapped: kind} = snapped([0.5, 9], {piece});
    expect(kind).toBe('midpoint');
    expect(point[0]).toBeCloseTo(0, 9);
    expect(point[1]).toBeCloseTo(10, 9);
  });

  it('snaps to a notch', () => {
    expect(snapped([5, 1], {notches: [[6, 0]]})).toEqual({point: [6, 0], snapped: 'notch'});
  });

  it('snaps to the ends of the grain line, but not to its middle', () => {
    const grain = [
      [10, 5],
      [10, 15],
    ] as const;
    const piece = {...square, grain};
    expect(snapped([10.5, 14.5], {piece})).toEqual({point: [10, 15], snapped: 'grain'});
    expect(snapped([10.5, 10], {piece}).snapped).toBe('none');
  });

  it('goes onto the outline where no mark is near', () => {
    expect(snapped([4, 1.5])).toEqual({point: [4, 0], snapped: 'outline'});
  });

  it('goes to a mark within reach rather than to the outline under it', () => {
    expect(snapped([18.5, 0])).toEqual({point: [20, 0], snapped: 'corner'});
  });

  it('stays where it is away from everything', () => {
    expect(snapped([5, 6])).toEqual({point: [5, 6], snapped: 'none'});
  });

  it('stays where it is on a piece that is not there', () => {
    const index = pickIndex(sheetOf([square]));
    expect(snap(index, 4, [1, 1], 2)).toEqual({point: [1, 1], snapped: 'none'});
  });
});

describe('marks in reach of one point', () => {
  const place: Point = [10, 1];

  it('go corner before notch before midpoint before grain at about the same distance', () => {
    const grain = [
      [10, 1.4],
      [10, 15],
    ] as const;
    const piece: DrawnPiece = {...square, grain};
    expect(snapped(place, {piece}).snapped).toBe('midpoint');
    expect(snapped(place, {piece, notches: [[9.2, 0]]}).snapped).toBe('notch');
    const split = {...piece, edges: [0, 1, 2, 3, 4]};
    expect(snapped(place, {piece: split, notches: [[9.2, 0]]}).snapped).toBe('corner');
  });

  it('let one that is clearly nearer go first', () => {
    // corner 1.5 away, notch 0.4: the difference exceeds half of the reach, 2
    expect(snapped([1.5, 0], {notches: [[1.9, 0]]}).snapped).toBe('notch');
    // the difference is only 0.6
    expect(snapped([1.5, 0], {notches: [[2.1, 0]]}).snapped).toBe('corner');
  });

  it('let the nearest of the same kind win', () => {
    const notches: Point[] = [
      [5, 0],
      [6, 0],
    ];
    expect(snapped([5.8, 0.1], {notches}).point).toEqual([6, 0]);
  });
});
