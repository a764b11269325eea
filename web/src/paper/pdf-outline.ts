/** The outline of a PDF file by pieces. */
import type {CutSheet} from '../cutting/cut-sheet.js';
import {refTo, textString, type PdfDocument, type Ref} from '../files/pdf/document.js';
import {middle, type Point} from '../model/geometry/vectors.js';
import {boxOf, isInside} from '../model/geometry/polyline.js';
import {cornersOf, overlap} from './boxes.js';
import type {SheetPage} from './pages.js';

/**
 * The document outline: an entry per piece, for the page with its middle, otherwise with a part of
 * it.
 */
export function outlineOf(
  document: PdfDocument,
  {pieces}: CutSheet,
  pages: readonly SheetPage[],
  refs: readonly Ref[],
): Ref {
  const root = document.reserve();
  const items = pieces.map(() => document.reserve());
  pieces.forEach(({label, cut}, k) => {
    const around = boxOf(cut[0] ?? []);
    const centre: Point = middle(around.low, around.high);
    const shown = pages.findIndex(({frame}) => isInside(cornersOf(frame), centre));
    const touched = pages.findIndex(({frame}) => overlap(frame, around));
    const page = refs[Math.max(0, shown < 0 ? touched : shown)] ?? 0;
    const [before, next] = [items[k - 1], items[k + 1]];
    document.set(
      items[k] ?? 0,
      [
        `<</Title ${textString(label)}/Parent ${refTo(root)}/Dest[${refTo(page)}/Fit]`,
        before === undefined ? '' : `/Prev ${refTo(before)}`,
        next === undefined ? '' : `/Next ${refTo(next)}`,
        '>>',
      ].join(''),
    );
  });
  const [first = 0, last = 0] = [items[0], items.at(-1)];
  document.set(
    root,
    `<</Type/Outlines/First ${refTo(first)}/Last ${refTo(last)}/Count ${items.length}>>`,
  );
  return root;
}
