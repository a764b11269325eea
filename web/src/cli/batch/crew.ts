/** Who works on the jobs of a batch: threads of this process. */
import {Piscina} from 'piscina';

import type {KeyedJob} from './jobs.js';
import {failedFor, type Outcome} from './outcome.js';
import type {Answer, Task} from './solve-job.js';

export interface Crew {
  /** How many jobs may be handed over before the first of them has ended. */
  readonly atOnce: number;
  /** @throws {Error} when the outcome cannot be put on disk: there is no use in going on */
  run(job: KeyedJob): Promise<Outcome>;
  /** Ends it within about a second, whatever it is at; jobs at work are left undone. */
  close(): Promise<void>;
}

/** Time for the jobs at work to end by themselves. [ms] */
const farewell = 1000;

export class Threads implements Crew {
  readonly atOnce: number;
  readonly #folder: string;
  readonly #pool: Piscina<Task, Answer>;
  #closing: Promise<void> | undefined;

  /** @param folder where the results lie */
  constructor(folder: string, threads: number) {
    this.#folder = folder;
    this.atOnce = 2 * threads;
    this.#pool = new Piscina<Task, Answer>({
      filename: new URL('./solve-job.js', import.meta.url).href,
      ...{minThreads: threads, maxThreads: threads},
      closeTimeout: farewell,
    });
    this.#pool.on('error', () => undefined); // a job whose thread broke, or was not waited for, rejects by itself
  }

  async run(job: KeyedJob): Promise<Outcome> {
    let answer: Answer;
    try {
      answer = await this.#pool.run({job, folder: this.#folder});
    } catch (error) {
      const why = error instanceof Error ? error.message : String(error);
      return failedFor('internal', `The thread that solved the job broke: ${why}.`);
    }
    if (answer.status === 'unwritten') throw new Error(answer.reason);
    return answer;
  }

  close(): Promise<void> {
    return (this.#closing ??= this.#pool.close({force: true}));
  }
}
