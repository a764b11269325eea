import {describe, expect, it} from 'vitest';

import type {Alignment} from '../../web/src/model/geometry.js';
import type {ResultSymmetry, SolveResult} from '../../web/src/model/result.js';
import {mismatchColour, mismatchWidth} from '../../web/src/picture/colours.js';
import {drawResult} from '../../web/src/picture/draw-result.js';
import {fitOf} from '../../web/src/picture/fit.js';
import {plainPrint as print, squarePair, squarePiece} from '../support/two-squares.js';

/** Two squares on a 10 x 10 cm print in p1, as a result. */
function twoSquares(second: Alignment, symmetries: readonly ResultSymmetry[] = []): SolveResult {
  return {
    format: 'seamwise-result/1',
    units: 'cm',
    ...squarePair({
      pieces: [squarePiece('left_half'), squarePiece('right_half', {alignment: second})],
      symmetries,
    }),
    search: [],
    metrics: {
      fitRandom: 1,
      fitSearch: 1,
      fitAligned: 1,
      fit: 1,
      fitStrict: 1,
      fitSeam: 1,
      maxMovedCm: 0.25,
      iterations: 1,
      factorisations: 1,
      milliseconds: {alignment: 1, deformation: 1, total: 2},
      method: 'best',
      seed: 1,
    },
    notes: [],
  };
}
/** The print runs on when the second square lies 4 cm further along it. */
const runsOn: Alignment = {angle: 0, translation: [-4, 0]};
const alignments = ({pieces}: SolveResult): Alignment[] => pieces.map(({alignment}) => alignment);

describe('the fit of a result', () => {
  it('is zero where the print runs on across the seam', () => {
    const result = twoSquares(runsOn);
    expect(fitOf(result, 'shape', alignments(result)).total).toBeCloseTo(0, 12);
  });

  it('is length times mismatch where it does not', () => {
    const result = twoSquares({angle: 0, translation: [-4, 0.5]});
    const fit = fitOf(result, 'shape', alignments(result));
    expect(fit.seams[0]?.mismatch[0]).toBeCloseTo(0.5, 12);
    expect(fit.total).toBeCloseTo(4 * 0.5, 12);
    expect(fit.mean).toBeCloseTo(0.5, 12);
  });

  it('does not change with a whole repeat, nor when print and pieces turn together', () => {
    const result = twoSquares({angle: 0, translation: [-4 + 20, 0.5 - 10]});
    expect(fitOf(result, 'shape', alignments(result)).mean).toBeCloseTo(0.5, 12);
  });

  it('leaves out a seam that joins a piece to its own mirror twin', () => {
    const map = {angle: 0, translation: [4, 0]} as const;
    const result = twoSquares({angle: 0, translation: [1, 2]}, [
      {
        kind: 'pair',
        pieces: [0, 1],
        map,
        pairs: [
          [0, 1],
          [1, 0],
          [2, 3],
          [3, 2],
        ],
      },
    ]);
    const fit = fitOf(result, 'shape', alignments(result));
    expect(fit.seams[0]?.counts).toBe(false);
    expect(fit.total).toBe(0);
  });
});

describe('the picture', () => {
  const result = twoSquares({angle: Math.PI / 2, translation: [1, 2]});
  const svg = drawResult(
    result,
    {...print, tile: '<svg xmlns="http://www.w3.org/2000/svg"/>'},
    {title: 'Shirt & <tie>', id: 'x'},
  );

  it('opens and closes its elements in order', () => {
    const open: string[] = [];
    for (const [, closing, name, selfClosing] of svg.matchAll(/<(\/?)([a-zA-Z]+)[^>]*?(\/?)>/g)) {
      if (closing) expect(open.pop()).toBe(name);
      else if (!selfClosing) open.push(name ?? '');
    }
    expect(open).toEqual([]);
  });

  it('shows text as text', () => {
    expect(svg).not.toContain('<tie>');
    expect(svg).toContain('left half');
  });

  it('is free of NaN and of ids used twice', () => {
    expect(svg).not.toMatch(/NaN|undefined|Infinity/);
    const ids = [...svg.matchAll(/ id="([^"]+)"/g)].map(([, id]) => id);
    expect(new Set(ids).size).toBe(ids.length);
    expect(ids).toHaveLength(5);
  });

  it('lays the print under a piece as the piece lies on it', () => {
    // p = R w + t: the print's origin is at (1, 2) of the piece, and w1 points up it, which is down in pixels
    const corner = /fill="url\(#x-after-1\)"/.exec(svg)?.index ?? 0;
    const path = svg.slice(svg.lastIndexOf('<path', corner), corner);
    const [x0 = NaN, y0 = NaN] = (/M([\d.]+) ([\d.]+)/.exec(path) ?? []).slice(1).map(Number);
    const [x1 = NaN] = (/L([\d.]+) /.exec(path) ?? []).slice(1).map(Number);
    const scale = (x1 - x0) / 4;
    const matrix =
      /id="x-after-1"[^>]*matrix\(([^)]*)\)/.exec(svg)?.[1]?.split(' ').map(Number) ?? [];
    const expected = [0, -1, 1, 0, x0 + scale, y0 - 2 * scale];
    matrix.forEach((value, k) => {
      expect(value).toBeCloseTo(expected[k] ?? NaN, 1);
    });
    expect(matrix).toHaveLength(6);
  });

  it('says the figures in words', () => {
    expect(svg).toMatch(/<desc>Mean print mismatch along seams [\d.]+ mm before, [\d.]+ mm after/);
  });
});

it('colours from green at 0 to red at 2 cm and beyond, and thickens', () => {
  expect(mismatchColour(0)).toBe('#2b9358');
  expect(mismatchColour(2)).toBe('#c83028');
  expect(mismatchColour(7)).toBe(mismatchColour(2));
  expect(mismatchWidth(2)).toBeGreaterThan(mismatchWidth(0));
});
