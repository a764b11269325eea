/** Keeps an element at its greatest height so far, so that content below it does not move. */

/** Time without a change after which the element releases the height it no longer needs. [ms] */
const settling = 2000;

export class KeptHeight {
  readonly #part: HTMLElement;
  readonly #observer: ResizeObserver;
  #pause: ReturnType<typeof setTimeout> | undefined;
  #about: unknown;
  #width = 0;
  #highest = 0;

  /** @param part element to keep; heights with an open `details` are not counted */
  constructor(part: HTMLElement) {
    this.#part = part;
    this.#observer = new ResizeObserver(([entry]) => {
      const [size] = entry?.borderBoxSize ?? [];
      if (size) this.#measured(size.inlineSize, size.blockSize);
    });
    this.#observer.observe(part);
  }

  /** Subject of the element's text; a new subject resets the height. */
  set about(about: string) {
    if (about === this.#about) return;
    this.#about = about;
    this.#forget();
  }

  /** Restarts the pause after a change. @param isSettled true if the element has all its text */
  stir(isSettled: boolean): void {
    clearTimeout(this.#pause);
    if (!isSettled) return;
    this.#pause = setTimeout(() => {
      // nothing moves under the pointer
      if (this.#part.parentElement?.matches(':hover')) this.stir(true);
      else this.#forget();
    }, settling);
  }

  dispose(): void {
    clearTimeout(this.#pause);
    this.#observer.disconnect();
  }

  #measured(width: number, height: number): void {
    if (Math.abs(width - this.#width) > 1) {
      this.#width = width;
      this.#forget();
      return;
    }
    const isOpen = this.#part.shadowRoot?.querySelector('details[open]');
    if (isOpen || height <= this.#highest) return;
    this.#highest = height;
    this.#part.style.minHeight = `${height}px`;
  }

  #forget(): void {
    this.#highest = 0;
    this.#part.style.minHeight = '';
    // observing again causes a measurement, even of an unchanged height
    this.#observer.unobserve(this.#part);
    this.#observer.observe(this.#part);
  }
}
