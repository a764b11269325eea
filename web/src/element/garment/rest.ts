/** Delay after an element leaves the document, since it may only be moving within it. [ms] */
const grace = 1000;

/** Calls `begin` once an element has been out of the document for a while. */
export class Rest {
  readonly #isAway: () => boolean;
  readonly #begin: () => void;
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** @param isAway whether the element is still unused at that time */
  constructor(isAway: () => boolean, begin: () => void) {
    this.#isAway = isAway;
    this.#begin = begin;
  }

  soon(): void {
    this.not();
    this.#timer = setTimeout(() => {
      if (this.#isAway()) this.#begin();
    }, grace);
  }

  not(): void {
    clearTimeout(this.#timer);
  }
}
