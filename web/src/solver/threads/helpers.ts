import type {Requests} from '../requests/requests.js';
import type {LentShare} from '../module/seamwise.mjs';
import {
  protocolVersion,
  type FromThread,
  type StartThread,
  type Thread,
  type ThreadOwner,
} from './thread.js';
import type {Solver} from '../answers/solve.js';

/** Delays. [ms] */
const usualDelays = {
  /**
   * A search of this duration usually takes about as long again, so it is worth starting threads.
   */
  start: 200,
  /** A search of this duration is worth lending shares to threads that have started. */
  lend: 20,
  /** A thread that is not needed for this time is ended. */
  end: 5000,
};

/**
 * Number of shares per thread. A single helper takes two of a search's four shares at once, so that
 * it does not wait in between.
 */
const sharesEach = (threads: number): number => (threads === 1 ? 2 : 1);

/** A share that was lent to a thread. */
interface Lent {
  /** Null once the share is no longer needed. */
  solver: Solver | null;
  readonly number: number;
}

/** A thread, and its shares, which it processes one after the other. */
class Helper {
  readonly #thread: Thread<Requests>;
  readonly #lent = new Map<number, Lent>();
  #lastJob = 0;

  constructor(start: StartThread<Requests>, module: WebAssembly.Module, owner: ThreadOwner) {
    this.#thread = start(owner);
    this.#thread.post({kind: 'modules', sources: {seamwise: module}});
  }

  /** Number of shares that are still needed. */
  get shares(): number {
    return [...this.#lent.values()].filter(({solver}) => solver !== null).length;
  }

  isFor(solver: Solver): boolean {
    return [...this.#lent.values()].some((lent) => lent.solver === solver);
  }

  run(solver: Solver, {number, order}: LentShare): void {
    const job = ++this.#lastJob;
    this.#lent.set(job, {solver, number});
    const share = {kind: 'request', name: 'share', request: {order}} as const;
    this.#thread.post({...share, job, hooks: [], helpers: 0});
  }

  /** Removes and returns the share of an ended job. */
  take(job: number): Lent | undefined {
    const lent = this.#lent.get(job);
    this.#lent.delete(job);
    return lent;
  }

  /** Drops the shares of a solver that are no longer needed; all of them if it is `leaving`. */
  drop(solver: Solver, leaving: boolean): void {
    for (const [job, lent] of this.#lent) {
      if (lent.solver !== solver || (!leaving && solver.awaits(lent.number))) continue;
      lent.solver = null;
      this.#thread.post({kind: 'cancel', job});
    }
  }

  end(): void {
    this.#thread.end();
  }
}

/**
 * Threads that run shares of the searches of solvers on this thread. Results do not depend on them:
 * shares that a thread does not deliver are computed here. Threads start when a search takes long,
 * and end when there has been no search for a while.
 */
export class Helpers {
  readonly #start: StartThread<Requests>;
  readonly #delays: typeof usualDelays;
  /** Number of threads that have broken; so many fewer are started afterwards. */
  #broken = 0;
  readonly #helpers = new Set<Helper>();
  #ending: ReturnType<typeof setTimeout> | undefined;

  constructor(start: StartThread<Requests>, delays = usualDelays) {
    this.#start = start;
    this.#delays = delays;
  }

  /**
   * Lends the solver's shares to free threads.
   * @param module the module that the solver runs; another one might give other answers
   * @param most greatest number of threads
   * @returns whether any thread works for the solver
   */
  help(solver: Solver, module: WebAssembly.Module | undefined, most: number): boolean {
    for (const helper of this.#helpers) helper.drop(solver, false);
    const {alignment} = solver.milliseconds;
    const allowed = alignment < this.#delays.start ? 0 : most - this.#broken;
    while (module && alignment >= this.#delays.lend) {
      const free = [...this.#helpers].find(({shares}) => shares < sharesEach(most));
      const lent = (free ?? this.#helpers.size < allowed) ? solver.lend() : null;
      if (!lent) break;
      clearTimeout(this.#ending);
      (free ?? this.#started(module, most))?.run(solver, lent);
    }
    return [...this.#helpers].some((helper) => helper.isFor(solver));
  }

  /** Drops all shares of a solver. Call it at the end of a solve, whatever the outcome. */
  leave(solver: Solver): void {
    for (const helper of this.#helpers) helper.drop(solver, true);
    clearTimeout(this.#ending);
    if (this.#helpers.size === 0) return;
    this.#ending = setTimeout(() => {
      for (const helper of this.#helpers) {
        if (helper.shares > 0) continue; // another solve is still running
        this.#helpers.delete(helper);
        helper.end();
      }
    }, this.#delays.end);
    // the timer must not keep a program from ending
    if (typeof this.#ending === 'object') (this.#ending as {unref?: () => void}).unref?.();
  }

  #started(module: WebAssembly.Module, most: number): Helper | undefined {
    const lost = () => {
      if (!this.#helpers.delete(helper)) return;
      this.#broken += 1;
      helper.end();
    };
    const receive = (message: FromThread) => {
      if (message.kind === 'ready' && message.version !== protocolVersion) lost();
      if (message.kind === 'failed' && message.failure.code !== 'cancelled') lost();
      if (message.kind !== 'done' && message.kind !== 'failed') return;
      const lent = helper.take(message.job);
      if (message.kind === 'failed' || !lent?.solver) return;
      lent.solver.take(lent.number, message.answer as Float64Array);
      this.help(lent.solver, module, most);
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
