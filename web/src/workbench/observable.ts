/** Between two changes that are told at a pace. [ms] */
const pace = 100;

/** Something that others follow. */
export class Observable {
  readonly #listeners = new Set<() => void>();
  #telling: ReturnType<typeof setTimeout> | undefined;

  /** Calls back after every change of anything here. @returns what ends that */
  subscribe(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Nobody is told anything more. */
  dispose(): void {
    clearTimeout(this.#telling);
    this.#listeners.clear();
  }

  protected changed(): void {
    clearTimeout(this.#telling);
    this.#telling = undefined;
    for (const listener of this.#listeners) listener();
  }

  /** What comes many times a second is told at a pace that can be followed. */
  protected changedOften(): void {
    this.#telling ??= setTimeout(() => {
      this.changed();
    }, pace);
  }

  /** Not before the present task is done, which may have had enough to do. */
  protected changedNext(): void {
    clearTimeout(this.#telling);
    this.#telling = setTimeout(() => {
      this.changed();
    });
  }
}
