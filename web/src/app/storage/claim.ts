/**
 * Locks a project to one tab: two tabs that save the same project would undo each other's changes.
 */

/** Time limit for a lock: the previous page may still be closing, as in a reload. [ms] */
const patience = 400;
const prefix = 'seamwise-project-';

/** Locks one project at a time, until the page is left. */
export class Claim {
  #release = (): void => undefined;
  #last: Promise<unknown> = Promise.resolve();

  /** Unlocks the previous project. @returns false if another tab has locked this one */
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

  /** Returns the projects locked by any tab. */
  async all(): Promise<ReadonlySet<string>> {
    if (!('locks' in navigator)) return new Set();
    const {held = []} = await navigator.locks.query();
    const names = held.flatMap(({name}) => (name?.startsWith(prefix) ? [name] : []));
    return new Set(names.map((name) => name.slice(prefix.length)));
  }
}
