/** Between two changes that are told at a pace. [ms] */
const pace = 100;

/** What is being read of, while somebody notes it. */
let read: Set<Observable> | undefined;
/** What has changed by now of a change that is told as one. */
let changing: Set<Observable> | undefined;

/** Something that others follow. */
export class Observable {
  readonly #listeners = new Set<() => void>();
  #telling: ReturnType<typeof setTimeout> | undefined;

  /** Changes of several that belong together: each listener is called once, when all are made. */
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

  /** @returns all whose `read` was asked for by `act` */
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
    read = undefined; // what listeners read, whoever has made the change has not
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

  /** The same, noted as read. */
  get read(): this {
    read?.add(this);
    return this;
  }

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
    if (changing) changing.add(this);
    else Observable.#tell([this]);
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
