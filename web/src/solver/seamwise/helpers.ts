import type {Requests} from '../requests/requests.js';
import type {LentShare} from '../module/seamwise.mjs';
import {protocolVersion, type FromThread} from '../threads/protocol.js';
import type {StartThread, Thread, ThreadOwner} from '../threads/thread.js';
import type {Solver} from './solver.js';

/** What is waited for. [ms] */
const usualDelays = {
  /** What has been sought for so long goes on for about as long again, as a rule: threads are worth their start. */
  start: 200,
  /** And those that have started are worth being told. */
  lend: 20,
  /** A thread that nobody has needed for so long is ended. */
  end: 5000,
};

/** One that helps alone takes two of the four shares of a search at once, not to wait in between. */
const sharesEach = (threads: number): number => (threads === 1 ? 2 : 1);

/** What a thread has been asked for. */
interface Lent {
  /** Null once it is of no use any more. */
  solver: Solver | null;
  readonly number: number;
}

/** A thread, and the shares that it is at, one after the other. */
class Helper {
  readonly #thread: Thread<Requests>;
  readonly #lent = new Map<number, Lent>();
  #lastJob = 0;

  constructor(start: StartThread<Requests>, module: WebAssembly.Module, owner: ThreadOwner) {
    this.#thread = start(owner);
    this.#thread.post({kind: 'modules', sources: {seamwise: module}});
  }

  /** How many somebody waits for. */
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

  /** A job that has ended. */
  take(job: number): Lent | undefined {
    const lent = this.#lent.get(job);
    this.#lent.delete(job);
    return lent;
  }

  /** Drops the shares of a solver that are of no use, all of them if it is `leaving`. */
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
 * Threads that run shares of the searches of a solver on this thread. Results do not depend on them: what a thread
 * does not bring is done here. They start when a search takes long, and end when none has for a while.
 */
export class Helpers {
  readonly #start: StartThread<Requests>;
  readonly #delays: typeof usualDelays;
  /** Threads that have broken: so many fewer are started from then on. */
  #broken = 0;
  readonly #helpers = new Set<Helper>();
  #ending: ReturnType<typeof setTimeout> | undefined;

  constructor(start: StartThread<Requests>, delays = usualDelays) {
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

  /** To be called at the end of a solve, however it came: nobody works for it any more. */
  leave(solver: Solver): void {
    for (const helper of this.#helpers) helper.drop(solver, true);
    clearTimeout(this.#ending);
    if (this.#helpers.size === 0) return;
    this.#ending = setTimeout(() => {
      for (const helper of this.#helpers) {
        if (helper.shares > 0) continue; // another solve is not at its end
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
