/** The grid of pages that a user changes by dragging pages. */
import type {AssembledPages, PagePlace} from '../../model/garment/imported-drawing.js';
import type {Point} from '../../model/geometry/vectors.js';

type Cell = PagePlace['cell'];

/** The places of the pages on the sheet; pages without joints are in one row. */
export const placesOf = ({placed}: Pick<AssembledPages, 'placed'>): readonly PagePlace[] =>
  placed.map(({number, cell}, k) => ({number, cell: cell ?? [k, 0]}));

const isSame = (a: Cell, b: Cell): boolean => a[0] === b[0] && a[1] === b[1];

/** Moves a page to a cell. A page in that cell changes places with it. The grid begins at 0. */
export function movedPage(
  places: readonly PagePlace[],
  number: number,
  to: Cell,
): readonly PagePlace[] {
  const from = places.find((one) => one.number === number)?.cell ?? to;
  const cells = places.map((one) => {
    if (one.number === number) return to;
    return isSame(one.cell, to) ? from : one.cell;
  });
  const [left, top] = [0, 1].map((axis) => Math.min(...cells.map((cell) => cell[axis] ?? 0)));
  return places.map((one, k) => {
    const [column, row] = cells[k] ?? one.cell;
    return {number: one.number, cell: [column - (left ?? 0), row - (top ?? 0)]};
  });
}

/** Adds a page below the others. */
export function addedPage(places: readonly PagePlace[], number: number): readonly PagePlace[] {
  const below = Math.max(-1, ...places.map(({cell}) => cell[1])) + 1;
  return [...places, {number, cell: [0, below]}];
}

/**
 * The cell at a point of the sheet, inside the grid or one cell beside it.
 * @param at [mm]
 */
export function cellAt({placed, columns, rows}: AssembledPages, [x, y]: Point): Cell {
  const index = placed.findIndex(
    ({low, high}) => x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1],
  );
  const places = placesOf({placed});
  const found = places[index]?.cell;
  if (found) return found;
  const [first] = placed;
  const cell = places[0]?.cell ?? [0, 0];
  if (!first) return cell;
  const steps = [first.high[0] - first.low[0], first.high[1] - first.low[1]] as const;
  const middle = [(first.low[0] + first.high[0]) / 2, (first.low[1] + first.high[1]) / 2] as const;
  const within = (value: number, most: number): number => Math.max(-1, Math.min(most, value));
  return [
    within(cell[0] + Math.round((x - middle[0]) / steps[0]), columns),
    within(cell[1] - Math.round((y - middle[1]) / steps[1]), rows),
  ];
}
