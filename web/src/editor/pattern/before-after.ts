/** The share of a view that shows the garment before the solve. */
export class BeforeAfter {
  readonly #changed: () => void;
  #split: number | undefined;
  #isHeld = false;

  /** @param changed called after every change */
  constructor(changed: () => void) {
    this.#changed = changed;
  }

  /** Position of the handle as a share of the width; undefined without a handle. */
  get split(): number | undefined {
    return this.#split;
  }

  set split(split: number | undefined) {
    this.#split = split;
    this.#changed();
  }

  /** True to show the garment before the solve on the whole width, as while a key is held. */
  get isHeld(): boolean {
    return this.#isHeld;
  }

  set isHeld(isHeld: boolean) {
    this.#isHeld = isHeld;
    this.#changed();
  }

  /** Share of the width that shows the garment before the solve; undefined for none. */
  get shown(): number | undefined {
    return this.#isHeld ? 1 : this.#split;
  }

  /** Shows or hides the garment before the solve on one half. */
  toggle(): void {
    this.split = this.#split === undefined ? 0.5 : undefined;
  }
}
