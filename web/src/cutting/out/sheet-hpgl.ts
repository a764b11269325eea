/** Writes a cutting sheet for plotters and cutters in HP-GL. */
import {hpglText, type PenStrokes} from '../../files/hpgl/hpgl.js';
import {boxOf} from '../../model/geometry/polyline.js';
import {between} from '../../model/geometry/vectors.js';
import type {CutSheet, LaidPiece} from '../cut-sheet.js';

/** Separate pens for cutting and drawing. */
const cutPen = 1;
const drawPen = 2;

/**
 * Strokes of pieces. Pen 2 draws all marks before pen 1 cuts, since cut pieces may shift.
 * @param mark warning on every piece
 */
export function strokesOf(
  pieces: readonly Pick<LaidPiece, 'cut' | 'marks'>[],
  mark?: string,
): readonly PenStrokes[] {
  const drawn = pieces.flatMap(({marks}) =>
    marks.flatMap((mark) => (mark.kind === 'line' && mark.layer !== 'cut' ? [mark] : [])),
  );
  // holes first, for the same reason
  const cut = pieces.flatMap((piece) =>
    [...piece.cut].reverse().map((points) => ({points, isClosed: true})),
  );
  const labels = pieces.flatMap(({cut: [outline = []]}) => {
    const {low, high} = boxOf(outline);
    return mark === undefined ? [] : [{words: mark, at: between(low, high, 0.5)}];
  });
  return [
    {pen: drawPen, strokes: drawn, labels},
    {pen: cutPen, strokes: cut},
  ];
}

/**
 * The HP-GL text.
 * @param mark warning on every piece
 * @throws {SolverError} `options` if the sheet is too wide for a plotter
 */
export const sheetHpgl = ({pieces}: CutSheet, mark?: string): string =>
  hpglText(strokesOf(pieces, mark));
