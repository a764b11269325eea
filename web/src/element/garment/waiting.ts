/** Callers that wait for the same answer. */

interface Waiter<T> {
  readonly resolve: (answer: T) => void;
  readonly reject: (reason: unknown) => void;
}

export class Waiting<T> {
  readonly #all = new Set<Waiter<T>>();

  get isEmpty(): boolean {
    return this.#all.size === 0;
  }

  /**
   * Settles with the other callers, or when `signal` fires: with its reason.
   * @param left called when the signal fires
   */
  join(signal: AbortSignal | undefined, left: () => void): Promise<T> {
    return new Promise((resolve, reject) => {
      const listening = new AbortController();
      const waiter: Waiter<T> = {
        resolve: (answer) => {
          listening.abort();
          resolve(answer);
        },
        reject: (reason) => {
          listening.abort();
          // eslint-disable-next-line @typescript-eslint/prefer-promise-reject-errors -- may be the caller's own
          reject(reason);
        },
      };
      this.#all.add(waiter);
      const leave = (): void => {
        this.#all.delete(waiter);
        waiter.reject(signal?.reason);
        left();
      };
      signal?.addEventListener('abort', leave, {once: true, signal: listening.signal});
    });
  }

  resolve(answer: T): void {
    for (const waiter of this.#taken()) waiter.resolve(answer);
  }

  reject(reason: unknown): void {
    for (const waiter of this.#taken()) waiter.reject(reason);
  }

  #taken(): readonly Waiter<T>[] {
    const all = [...this.#all];
    this.#all.clear();
    return all;
  }
}
