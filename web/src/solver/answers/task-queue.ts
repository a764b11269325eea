/** Runs a limited number of tasks at a time, in the order of arrival. */
export class TaskQueue {
  readonly #atOnce: number;
  #free: number;
  /** Functions that start the waiting tasks, in order. */
  readonly #waiting = new Set<() => void>();

  /** @param atOnce greatest number of tasks that run at the same time */
  constructor(atOnce: number) {
    this.#atOnce = this.#free = atOnce;
  }

  get isIdle(): boolean {
    return this.#free === this.#atOnce;
  }

  /**
   * Runs a task in its turn.
   * @throws errors of `work`; the signal's reason, at once, when it fires before the task's turn
   */
  async take<T>(work: () => Promise<T>, signal?: AbortSignal): Promise<T> {
    signal?.throwIfAborted();
    if (this.#free > 0) this.#free -= 1;
    else await this.#wait(signal);
    try {
      return await work();
    } finally {
      this.#pass();
    }
  }

  #wait(signal: AbortSignal | undefined): Promise<void> {
    return new Promise((resolve, reject) => {
      const leave = () => {
        this.#waiting.delete(begin);
        // eslint-disable-next-line @typescript-eslint/prefer-promise-reject-errors -- the caller's own
        reject(signal?.reason);
      };
      const begin = () => {
        signal?.removeEventListener('abort', leave);
        resolve();
      };
      this.#waiting.add(begin);
      signal?.addEventListener('abort', leave, {once: true});
    });
  }

  #pass(): void {
    const [next] = this.#waiting;
    if (!next) {
      this.#free += 1;
      return;
    }
    this.#waiting.delete(next);
    next();
  }
}
