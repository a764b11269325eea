/** Runs the jobs of a batch on threads of this process. */
import {Piscina} from 'piscina';

import type {KeyedJob} from './jobs.js';
import {failedFor, failureText, type Outcome} from './outcome.js';
import type {Answer, Task} from './solve-job.js';
import type {Store} from './store.js';

export interface Crew {
  /** Greatest number of jobs submitted before the first of them is done. */
  readonly atOnce: number;
  /**
   * Runs a job.
   * @throws {Error} if the outcome cannot be written to disk, which ends the batch
   */
  run(job: KeyedJob): Promise<Outcome>;
  /** Stops within about a second, and leaves running jobs undone. */
  close(): Promise<void>;
}

/** Time for running jobs to finish on close. [ms] */
const farewell = 1000;

/**
 * Keeps threads from loading modules synchronously: Node 20 aborts the whole process if such a
 * thread is ended meanwhile.
 */
const asynchronous = ['--no-experimental-require-module'].filter((flag) =>
  process.allowedNodeEnvironmentFlags.has(flag),
);

export class Threads implements Crew {
  readonly atOnce: number;
  readonly #store: Store;
  readonly #timeout: number;
  readonly #pool: Piscina<Task, Answer>;
  /** Jobs that wait for a thread. A job's time limit starts with its thread. */
  readonly #waiting: (() => void)[] = [];
  #free: number;
  #closing: Promise<void> | undefined;

  /**
   * @param store folder of the results
   * @param timeout time limit of a job in seconds, after which its thread is ended; 0 for none
   */
  constructor(store: Store, threads: number, timeout: number) {
    this.#store = store;
    this.#timeout = timeout;
    this.#free = threads;
    this.atOnce = 2 * threads;
    this.#pool = new Piscina<Task, Answer>({
      filename: new URL('./solve-job.js', import.meta.url).href,
      ...{minThreads: threads, maxThreads: threads},
      closeTimeout: farewell,
      execArgv: [...process.execArgv, ...asynchronous],
    });
    this.#pool.on('error', () => undefined); // jobs of a broken thread reject on their own
  }

  async run(job: KeyedJob): Promise<Outcome> {
    if (this.#free > 0) this.#free -= 1;
    else await new Promise<void>((resolve) => this.#waiting.push(resolve));
    try {
      return await this.#solve(job);
    } finally {
      const next = this.#waiting.shift();
      if (next) next();
      else this.#free += 1;
    }
  }

  async #solve(job: KeyedJob): Promise<Outcome> {
    const seconds = this.#timeout;
    const late = new AbortController();
    const end = () => {
      if (!this.#closing) late.abort();
    };
    const timer = seconds > 0 ? setTimeout(end, 1000 * seconds) : undefined;
    let answer: Answer;
    try {
      answer = await this.#pool.run({job, folder: this.#store.folder}, {signal: late.signal});
    } catch (error) {
      if (late.signal.aborted) return await this.#ended(job, seconds);
      const why = error instanceof Error ? error.message : String(error);
      return failedFor('internal', `The thread that solved the job broke: ${why}.`);
    } finally {
      clearTimeout(timer);
    }
    if (answer.status === 'unwritten') throw new Error(answer.reason);
    return answer;
  }

  /** Records a timeout as final, so that later runs do not repeat the job unless requested. */
  async #ended(job: KeyedJob, seconds: number): Promise<Outcome> {
    const message = `The job was not done within ${seconds} s; give it more with --job-timeout, and --retry-timeouts.`;
    const failure = {code: 'timeout', message, piece: null, seam: null} as const;
    await this.#store.write(job.key, 'failed', failureText(failure));
    return {status: 'failed', failure, milliseconds: 1000 * seconds, isFinal: true};
  }

  close(): Promise<void> {
    return (this.#closing ??= this.#pool.close({force: true}));
  }
}
