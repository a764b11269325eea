/** Limits of the work and memory that the reading of one file takes. */

/** Greatest counts, far above those of a pattern in ten sizes. */
const most = {
  /** Operators of the pages, with those of forms each time that they are drawn. */
  operators: 3_000_000,
  /** Points as written, on each page that draws them. */
  points: 1_200_000,
  /** Points of visible lines, with curves as points. */
  'visible points': 260_000,
  /** Lines between moves of the pen, after clipping. */
  'visible lines': 55_000,
  /** Points of filled marks; letters drawn as outlines look like them. */
  'points of marks': 300_000,
  texts: 100_000,
  /**
   * States and layers that are begun and not ended. pdf.js takes time for each of them at every
   * operator.
   */
  'nested groups': 2_000,
} as const;

type Counted = keyof typeof most;

export class ReadingBudget {
  readonly #left: Record<Counted, number> = {...most};
  #exceeded: Counted | undefined;

  /** Returns whether the budget has a count, and spends it then. A negative count is given back. */
  take(what: Counted, count: number): boolean {
    if (this.#left[what] < count) return false;
    this.#left[what] -= count;
    return true;
  }

  /** @throws {RangeError} if more is spent than the budget has */
  spend(what: Counted, count: number): void {
    if (this.take(what, count)) return;
    this.#exceeded ??= what;
    throw new RangeError(`too many ${what}`);
  }

  /** The exceeded limit in words, such as `1.2 million points`. */
  get exceeded(): string | undefined {
    const what = this.#exceeded;
    if (what === undefined) return undefined;
    const count = most[what];
    return `${count >= 1e6 ? `${count / 1e6} million` : count.toLocaleString('en')} ${what}`;
  }
}
