/** Open lines indexed by their ends. */
import {distance, type Point} from '../../model/geometry/vectors.js';

interface NextLine {
  /** Index of the line. */
  readonly line: number;
  /** True if its last point is the near one. */
  readonly isTurned: boolean;
}

export class Ends {
  readonly #ends: readonly (readonly Point[])[];
  readonly #left: Set<number>;
  readonly #cells = new Map<string, number[]>();
  readonly #reach: number;

  /**
   * @param ends first and last point of each line; empty for closed lines
   * @param reach greatest gap between ends that meet
   */
  constructor(ends: readonly (readonly Point[])[], reach: number) {
    this.#ends = ends;
    this.#reach = reach;
    this.#left = new Set(ends.keys());
    ends.forEach((both, k) => {
      for (const key of new Set(both.map((end) => this.#keyOf(end)))) {
        const cell = this.#cells.get(key);
        if (cell) cell.push(k);
        else this.#cells.set(key, [k]);
      }
    });
  }

  /** Removes a line, and returns whether it was still there. */
  take(line: number): boolean {
    return this.#left.delete(line);
  }

  /** Removes and returns the line with the end nearest to a point, of several the first. */
  next(point: Point): NextLine | undefined {
    let best: (NextLine & {readonly off: number}) | undefined;
    for (const line of this.#near(point)) {
      if (!this.#left.has(line)) continue;
      (this.#ends[line] ?? []).forEach((end, k) => {
        const off = distance(end, point);
        const isBetter = !best || off < best.off || (off === best.off && line < best.line);
        if (off <= this.#reach && isBetter) best = {line, isTurned: k === 1, off};
      });
    }
    if (best) this.#left.delete(best.line);
    return best;
  }

  /** Number of ends at a point, including those of removed lines. */
  countAt(point: Point): number {
    let count = 0;
    for (const line of this.#near(point)) {
      for (const end of this.#ends[line] ?? []) if (distance(end, point) <= this.#reach) count++;
    }
    return count;
  }

  #near([x, y]: Point): Set<number> {
    const [column, row] = [Math.floor(x / this.#reach), Math.floor(y / this.#reach)];
    const found = new Set<number>();
    for (const i of [column - 1, column, column + 1]) {
      for (const j of [row - 1, row, row + 1]) {
        for (const line of this.#cells.get(`${i} ${j}`) ?? []) found.add(line);
      }
    }
    return found;
  }

  #keyOf([x, y]: Point): string {
    return `${Math.floor(x / this.#reach)} ${Math.floor(y / this.#reach)}`;
  }
}
