/**
 * The parts of a page that no other page shows, too: its own cell of the grid, and the overlap that
 * reaches into cells without a page. Lengths in mm, in coordinates of the page.
 */
import type {Box} from '../../../model/geometry/polyline.js';
import type {Arrangement} from './arrange.js';
import type {Cell} from './page-names.js';

/** @param isTaken returns whether a cell has a page */
export function regionsOf(
  {window: {low, high}, overlap, splits}: Pick<Arrangement, 'window' | 'overlap' | 'splits'>,
  {row, column}: Cell,
  isTaken: (row: number, column: number) => boolean,
): Box[] {
  const [left, top] = [splits[0] * overlap[0], splits[1] * overlap[1]];
  const [right, below] = [overlap[0] - left, overlap[1] - top];
  const [x0, x1] = [low[0] + left, high[0] - right];
  const [y0, y1] = [low[1] + below, high[1] - top];
  // in a cell without a page, strips of pages beside it go before those of pages above and below it
  const widthOf = (r: number): readonly [number, number] => [
    isTaken(r, column - 1) ? x0 + right : x0,
    isTaken(r, column + 1) ? x1 - left : x1,
  ];
  const [[a0, a1], [b0, b1]] = [widthOf(row - 1), widthOf(row + 1)];
  const boxes: Box[] = [
    {low: [x0, y0], high: [x1, y1]},
    ...(isTaken(row, column - 1) ? [] : [{low: [low[0], y0], high: [x0, y1]} as const]),
    ...(isTaken(row, column + 1) ? [] : [{low: [x1, y0], high: [high[0], y1]} as const]),
    ...(isTaken(row - 1, column) ? [] : [{low: [a0, y1], high: [a1, high[1]]} as const]),
    ...(isTaken(row + 1, column) ? [] : [{low: [b0, low[1]], high: [b1, y0]} as const]),
  ];
  return boxes.filter((box) => box.high[0] > box.low[0] && box.high[1] > box.low[1]);
}
