/** An element that is taken out of the document may only be on its way to another place. [ms] */
const grace = 1000;

/** Rests once an element has been out of the document for a while. */
export class Rest {
  readonly #isAway: () => boolean;
  readonly #begin: () => void;
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** @param isAway whether nobody needs the element when the time has come */
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
