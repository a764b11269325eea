/** Which tab works on a project: two that saved the same one would undo each other's work. */

/** The tab that was here a moment ago may still be closing, as when a page is loaded again. [ms] */
const patience = 400;
const prefix = 'seamwise-project-';

/** Holds one project at a time, until the page is left. */
export class Claim {
  #release = (): void => undefined;
  #last: Promise<unknown> = Promise.resolve();

  /** Lets go of what was held before. @returns false when another tab holds the project */
  take(id: string): Promise<boolean> {
    const taken = this.#last.then(() => this.#take(id));
    this.#last = taken;
    return taken;
  }

  #take(id: string): Promise<boolean> {
    this.#release();
    return new Promise((resolve) => {
      navigator.locks
        .request(`${prefix}${id}`, {signal: AbortSignal.timeout(patience)}, () => {
          resolve(true);
          return new Promise<void>((release) => {
            this.#release = release;
          });
        })
        .catch(() => {
          resolve(false);
        });
    });
  }

  /** What any tab holds. */
  async all(): Promise<ReadonlySet<string>> {
    if (!('locks' in navigator)) return new Set();
    const {held = []} = await navigator.locks.query();
    const names = held.flatMap(({name}) => (name?.startsWith(prefix) ? [name] : []));
    return new Set(names.map((name) => name.slice(prefix.length)));
  }
}
