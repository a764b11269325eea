/** Writes a cutting sheet for plotters and cutters in HP-GL. */
import {hpglText, type PenStrokes} from '../../files/hpgl/hpgl.js';
import type {CutSheet, LaidPiece} from '../cut-sheet.js';

/** Separate pens for cutting and drawing. */
const cutPen = 1;
const drawPen = 2;

/** Strokes of pieces. Pen 2 draws all marks before pen 1 cuts, since cut pieces may shift. */
export function strokesOf(
  pieces: readonly Pick<LaidPiece, 'cut' | 'marks'>[],
): readonly PenStrokes[] {
  const drawn = pieces.flatMap(({marks}) =>
    marks.flatMap((mark) => (mark.kind === 'line' && mark.layer !== 'cut' ? [mark] : [])),
  );
  // holes first, for the same reason
  const cut = pieces.flatMap((piece) =>
    [...piece.cut].reverse().map((points) => ({points, isClosed: true})),
  );
  return [
    {pen: drawPen, strokes: drawn},
    {pen: cutPen, strokes: cut},
  ];
}

/**
 * The HP-GL text.
 * @throws {SolverError} `options` if the sheet is too wide for a plotter
 */
export const sheetHpgl = ({pieces}: CutSheet): string => hpglText(strokesOf(pieces));
