import type {FromWorker, ToWorker} from './protocol.js';
import {protocolVersion} from './protocol.js';
import type {Solver} from './solver.js';

/** Another thread, with a solver of its own. */
export interface HelperThread {
  post(message: ToWorker): void;
  /** Ends it, whatever it is at. */
  end(): void;
}

/** What is heard of a thread. */
export interface HelperOwner {
  receive(message: FromWorker): void;
  /** The thread has broken. */
  lost(): void;
}

/** @throws anything where there can be no thread */
export type StartHelper = (owner: HelperOwner) => HelperThread;

/** What is waited for. [ms] */
const usualDelays = {
  /** What has been sought for so long goes on for about as long again, as a rule: threads are worth their start. */
  start: 120,
  /** And those that have started are worth being told. */
  lend: 20,
  /** A thread that nobody has needed for so long is ended. */
  end: 5000,
};

/** Shares of a search that are out take part in slices of this length: what has come is wanted soon. [ms] */
export const sliceWhileHelped = 15;

/** A thread and the share that it is at. */
class Helper {
  readonly #thread: HelperThread;
  #lastJob = 0;
  /** Of the share that was lent; null once nobody waits for it. */
  solver: Solver | null = null;
  /** Of the share that is lent, in the solver; undefined when the thread is idle. */
  number: number | undefined;

  constructor(start: StartHelper, module: WebAssembly.Module, owner: HelperOwner) {
    this.#thread = start(owner);
    this.#thread.post({kind: 'module', module});
  }

  run(
    solver: Solver,
    {number, order}: {readonly number: number; readonly order: Float64Array},
  ): void {
    this.solver = solver;
    this.number = number;
    this.#lastJob += 1;
    this.#thread.post({kind: 'share', job: this.#lastJob, order});
  }

  drop(): void {
    this.solver = null;
    this.#thread.post({kind: 'cancel', job: this.#lastJob});
  }

  end(): void {
    this.#thread.end();
  }
}

/**
 * Threads that run shares of the searches of a solver on this thread. Results do not depend on them: what a thread
 * does not bring is done here. They start when a search takes long, and end when none has for a while.
 */
export class Helpers {
  readonly #start: StartHelper;
  readonly #delays: typeof usualDelays;
  /** Threads that have broken: so many fewer are started from then on. */
  #broken = 0;
  readonly #helpers = new Set<Helper>();
  #ending: ReturnType<typeof setTimeout> | undefined;

  constructor(start: StartHelper, delays = usualDelays) {
    this.#start = start;
    this.#delays = delays;
  }

  /**
   * Lends what the solver has to lend to whoever is free.
   * @param module what the solver runs: others might find other answers
   * @param most how many threads there may be
   * @returns whether somebody is at work for it
   */
  help(solver: Solver, module: WebAssembly.Module | undefined, most: number): boolean {
    const {alignment} = solver.milliseconds;
    const allowed = alignment < this.#delays.start ? 0 : most - this.#broken;
    while (module && alignment >= this.#delays.lend) {
      const idle = [...this.#helpers].find(({number}) => number === undefined);
      const lent = (idle ?? this.#helpers.size < allowed) ? solver.lend() : null;
      if (!lent) break;
      clearTimeout(this.#ending);
      (idle ?? this.#started(module, most))?.run(solver, lent);
    }
    return [...this.#helpers].some((helper) => helper.solver === solver);
  }

  /** To be called at the end of a solve, however it came: nobody works for it any more. */
  leave(solver: Solver): void {
    for (const helper of this.#helpers) if (helper.solver === solver) helper.drop();
    clearTimeout(this.#ending);
    if (this.#helpers.size === 0) return;
    this.#ending = setTimeout(() => {
      for (const helper of this.#helpers) {
        if (helper.solver) continue; // another solve is not at its end
        this.#helpers.delete(helper);
        helper.end();
      }
    }, this.#delays.end);
    // it keeps no program from ending
    if (typeof this.#ending === 'object') (this.#ending as {unref?: () => void}).unref?.();
  }

  #started(module: WebAssembly.Module, most: number): Helper | undefined {
    const lost = () => {
      if (!this.#helpers.delete(helper)) return;
      this.#broken += 1;
      helper.end();
    };
    const receive = (message: FromWorker) => {
      if (message.kind === 'ready' && message.version !== protocolVersion) lost();
      if (message.kind === 'failed' && message.failure.code !== 'cancelled') lost();
      if (message.kind !== 'done' && message.kind !== 'failed') return;
      const {solver, number} = helper;
      helper.solver = null;
      helper.number = undefined;
      if (message.kind === 'failed' || !solver || number === undefined) return;
      solver.take(number, message.answer as Float64Array);
      this.help(solver, module, most);
    };
    let helper: Helper;
    try {
      helper = new Helper(this.#start, module, {receive, lost});
    } catch {
      this.#broken = most;
      return undefined;
    }
    this.#helpers.add(helper);
    return helper;
  }
}
