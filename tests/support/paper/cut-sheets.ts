/** Cutting sheets for tests. */
import type {CutLine, CutSheet, LaidPiece} from '@/cutting/cut-sheet.js';
import {onPiece, type Alignment, type Point} from '@/model/geometry/vectors.js';

const outline = (points: readonly Point[], layer: CutLine['layer']): CutLine => ({
  ...{kind: 'line', layer, points, isClosed: true, widthMm: 0.5},
});

/** A rectangle at the sheet's origin, or moved to its place. */
export function laidRectangle(
  width: number,
  height: number,
  {place = {angle: 0, translation: [0, 0]}, ...more}: Partial<LaidPiece> = {},
): LaidPiece {
  const corners = (from: number): Point[] =>
    [
      [from, from] as const,
      [width - from, from] as const,
      [width - from, height - from] as const,
      [from, height - from] as const,
    ].map((p) => onPiece(place, p));
  return {
    ...{name: 'front', label: 'Front', copy: 1, place, quantity: 1, words: ['Front']},
    ...{cut: [corners(0)], sewn: [corners(1)], corners: corners(1), notches: [], ticks: []},
    ...{matchPoints: [], letters: [], internalLines: [], folds: [], drillHoles: []},
    grain: [onPiece(place, [1, 1]), onPiece(place, [1, 2])],
    marks: [
      outline(corners(0), 'cut'),
      outline(corners(1), 'sew'),
      {
        ...{kind: 'text', layer: 'words', sizeMm: 5, hasPlate: true},
        ...{at: onPiece(place, [width / 2, height / 2]), lines: ['Front', 'Cut 1 (once)']},
      },
    ],
    ...more,
  };
}

export const sheetOf = (
  widthCm: number,
  heightCm: number,
  pieces: readonly LaidPiece[] = [laidRectangle(widthCm, heightCm)],
): CutSheet => ({
  ...{widthCm, heightCm, pieces, heading: 'Apron, M', ownAllowances: 'none'},
  facts: ['Checks, repeat 4 cm × 4 cm', 'Print at 100 %; measure the squares.'],
});

export const onPrintAt = (angle: number, translation: Point): {readonly alignment: Alignment} => ({
  alignment: {angle, translation},
});
