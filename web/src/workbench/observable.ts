/** Interval between notifications of frequent changes. [ms] */
const pace = 100;

/** Observables that were read, while reads are recorded. */
let read: Set<Observable> | undefined;
/** Observables that have changed so far in a joint change. */
let changing: Set<Observable> | undefined;

/** An object whose changes can be observed. */
export class Observable {
  readonly #listeners = new Set<() => void>();
  #telling: ReturnType<typeof setTimeout> | undefined;

  /** Joins several changes: each listener is called once, after all of them. */
  static together(act: () => void): void {
    if (changing) {
      act();
      return;
    }
    const changed = (changing = new Set());
    try {
      act();
    } finally {
      changing = undefined;
      Observable.#tell(changed);
    }
  }

  /** @returns all observables whose `read` was accessed by `act` */
  static readBy(act: () => void): ReadonlySet<Observable> {
    const before = read;
    const noted = (read = new Set());
    try {
      act();
    } finally {
      read = before;
    }
    return noted;
  }

  static #tell(changed: Iterable<Observable>): void {
    const told = new Set<() => void>();
    const before = read;
    read = undefined; // reads of listeners are not reads of the code that made the change
    try {
      for (const one of changed) {
        for (const listener of one.#listeners) {
          if (told.has(listener)) continue;
          told.add(listener);
          listener();
        }
      }
    } finally {
      read = before;
    }
  }

  /** The object itself, recorded as read. */
  get read(): this {
    read?.add(this);
    return this;
  }

  /** Calls back after every change of the object. @returns the function that ends this */
  subscribe(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Removes all listeners. */
  dispose(): void {
    clearTimeout(this.#telling);
    this.#listeners.clear();
  }

  protected changed(): void {
    clearTimeout(this.#telling);
    this.#telling = undefined;
    if (changing) changing.add(this);
    else Observable.#tell([this]);
  }

  /** Notifies of changes that occur many times a second, at a limited rate. */
  protected changedOften(): void {
    this.#telling ??= setTimeout(() => {
      this.changed();
    }, pace);
  }

  /** Notifies after the present task, which may be long already. */
  protected changedNext(): void {
    clearTimeout(this.#telling);
    this.#telling = setTimeout(() => {
      this.changed();
    });
  }
}
