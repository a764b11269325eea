/** Finds values by the places of their points, in a grid of square cells. */
import {between, distance, nearestShare, type Point} from '../../model/geometry/vectors.js';
import type {Near} from '../../model/geometry/nearest.js';

/** Number of rows, beyond which cells share their lists. */
const rows = 2 ** 26;

export class PointGrid<T> {
  readonly #side: number;
  readonly #cells = new Map<number, T[]>();
  /** The last answer, as neighbouring points are often in one cell. */
  #last:
    {readonly column: number; readonly row: number; readonly found: readonly T[][]} | undefined;

  /** @param side length of a cell; all values within it of a point are found */
  constructor(side: number) {
    this.#side = side;
  }

  add([x, y]: Point, value: T): void {
    this.#last = undefined;
    const key = this.#keyOf(Math.floor(x / this.#side), Math.floor(y / this.#side));
    const cell = this.#cells.get(key);
    if (cell) cell.push(value);
    else this.#cells.set(key, [value]);
  }

  /** The lists of the cells around a point, each in the order in which values were added. */
  around([x, y]: Point): readonly (readonly T[])[] {
    const [column, row] = [Math.floor(x / this.#side), Math.floor(y / this.#side)];
    const last = this.#last;
    if (last?.column === column && last.row === row) return last.found;
    const found: T[][] = [];
    for (let i = column - 1; i <= column + 1; i++) {
      for (let j = row - 1; j <= row + 1; j++) {
        const cell = this.#cells.get(this.#keyOf(i, j));
        if (cell && !found.includes(cell)) found.push(cell);
      }
    }
    this.#last = {column, row, found};
    return found;
  }

  #keyOf(column: number, row: number): number {
    return column * rows + row;
  }
}

/** The side of the cells for `pointsOnLine`, in reaches. */
const sidesPerReach = 8;

/** A grid of points that are looked for along lines. */
export function gridOfPoints<T extends {readonly at: Point}>(
  points: readonly T[],
  reach: number,
): PointGrid<T> {
  const grid = new PointGrid<T>(sidesPerReach * reach);
  for (const one of points) grid.add(one.at, one);
  return grid;
}

/**
 * The points within reach of a line, each with its nearest place on the line.
 * @param grid from `gridOfPoints` with the same reach
 */
export function pointsOnLine<T extends {readonly at: Point}>(
  line: readonly Point[],
  isClosed: boolean,
  grid: PointGrid<T>,
  reach: number,
): ReadonlyMap<T, Near> {
  const found = new Map<T, Near>();
  line.forEach((from, step) => {
    const to = line[step + 1] ?? (isClosed ? line[0] : undefined);
    if (!to) return;
    const compare = (one: T): void => {
      const at = between(from, to, nearestShare(from, to, one.at));
      const off = distance(at, one.at);
      if (off <= reach && off < (found.get(one)?.off ?? Infinity)) found.set(one, {at, off, step});
    };
    const parts = Math.ceil(distance(from, to) / (sidesPerReach * reach));
    for (let part = 0; part <= parts; part++) {
      const place = parts === 0 ? from : between(from, to, part / parts);
      for (const cell of grid.around(place)) for (const one of cell) compare(one);
    }
  });
  return found;
}
