/** Open lines indexed by their ends. */
import {distance, type Point} from '../../model/geometry/vectors.js';
import {PointGrid} from './point-grid.js';

interface NextLine {
  /** Index of the line. */
  readonly line: number;
  /** True if its last point is the near one. */
  readonly isTurned: boolean;
}

interface LineEnd extends NextLine {
  readonly at: Point;
}

/** Ends within this share of the greatest gap lie at one place. */
const samePlace = 1 / 30;

export class Ends {
  readonly #left: Set<number>;
  readonly #grid: PointGrid<LineEnd>;
  readonly #reach: number;
  /** Number of ends at the beginning of a cell whose lines are removed. */
  readonly #removed = new Map<readonly LineEnd[], number>();

  /**
   * @param ends first and last point of each line; empty for closed lines
   * @param reach greatest gap between ends that meet
   */
  constructor(ends: readonly (readonly Point[])[], reach: number) {
    this.#reach = reach;
    this.#left = new Set(ends.keys());
    this.#grid = new PointGrid(reach);
    ends.forEach((both, line) => {
      both.forEach((at, k) => {
        this.#grid.add(at, {at, line, isTurned: k === 1});
      });
    });
  }

  /** Removes a line, and returns whether it was still there. */
  take(line: number): boolean {
    return this.#left.delete(line);
  }

  /** Removes and returns the line with the end nearest to a point, of several the first. */
  next(point: Point): NextLine | undefined {
    let best: (LineEnd & {readonly off: number}) | undefined;
    for (const cell of this.#grid.around(point)) {
      for (let k = this.#firstOf(cell); k < cell.length; k++) {
        const end = cell[k];
        if (!end || !this.#left.has(end.line)) continue;
        const off = distance(end.at, point);
        const isBetter = !best || off < best.off || (off === best.off && end.line < best.line);
        if (off <= this.#reach && isBetter) best = {...end, off};
        if (off <= samePlace * this.#reach) break;
      }
    }
    if (best) this.#left.delete(best.line);
    return best;
  }

  /** Number of ends at a point, including those of removed lines, up to a greatest number. */
  countAt(point: Point, most: number): number {
    let count = 0;
    for (const cell of this.#grid.around(point)) {
      for (const {at} of cell) {
        if (distance(at, point) <= this.#reach && ++count === most) return count;
      }
    }
    return count;
  }

  /** The index of the first end in a cell whose line is left. */
  #firstOf(cell: readonly LineEnd[]): number {
    let first = this.#removed.get(cell) ?? 0;
    for (let end = cell[first]; end && !this.#left.has(end.line); end = cell[first]) first++;
    this.#removed.set(cell, first);
    return first;
  }
}
