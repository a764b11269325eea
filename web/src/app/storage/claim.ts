/** Which tab works on a project: two that saved the same one would undo each other's work. */

/** The tab that was here a moment ago may still be closing, as when a page is loaded again. [ms] */
const patience = 400;

/** Holds one project at a time, until the page is left. */
export class Claim {
  #release = (): void => undefined;

  /** Lets go of what was held before. @returns false when another tab holds the project */
  async take(id: string): Promise<boolean> {
    this.#release();
    return new Promise((resolve) => {
      navigator.locks
        .request(`seamwise-project-${id}`, {signal: AbortSignal.timeout(patience)}, () => {
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

  release(): void {
    this.#release();
  }
}
