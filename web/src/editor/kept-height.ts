/** Keeps a part as high as it has been, so that nothing below it moves while its words come and go. */

/** After so long without a change, nobody waits for words any more: then no gap stays below them. [ms] */
const settling = 2000;

export class KeptHeight {
  readonly #part: HTMLElement;
  readonly #observer: ResizeObserver;
  #pause: ReturnType<typeof setTimeout> | undefined;
  #about: unknown;
  #width = 0;
  #highest = 0;

  /** @param part whose own `details` may still open and close */
  constructor(part: HTMLElement) {
    this.#part = part;
    this.#observer = new ResizeObserver(([entry]) => {
      const [size] = entry?.borderBoxSize ?? [];
      if (size) this.#measured(size.inlineSize, size.blockSize);
    });
    this.#observer.observe(part);
  }

  /** What it speaks of; of something else it may be less high. */
  set about(about: string) {
    if (about === this.#about) return;
    this.#about = about;
    this.#forget();
  }

  /** Something has changed around it. @param isSettled whether all its words are there */
  stir(isSettled: boolean): void {
    clearTimeout(this.#pause);
    if (!isSettled) return;
    this.#pause = setTimeout(() => {
      // what somebody points at stays where it is
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
    // measured again, whether or not that has changed its height
    this.#observer.unobserve(this.#part);
    this.#observer.observe(this.#part);
  }
}
