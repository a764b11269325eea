import {SolverError, type Failure} from '../model/failure.js';
import {SolverClient} from './client.js';
import {helpersFor, mostCores} from './cores.js';
import {MainThreadSolver} from './main-thread.js';
import type {Answers, QuestionOf} from './protocol.js';
import {TextService, type QuestionHooks, type SolverService} from './service.js';
import {warmUpProblems} from './warm-up.js';
import type {WorkerPlaces} from './watched-worker.js';

/** Where to find the solver, and who hears when it can have no worker. */
export interface LeasePlaces extends WorkerPlaces {
  /**
   * Hears at most once, with the code `worker-blocked`, that no worker can be had. The lease goes on
   * without: on the page's own thread, with the same results, and more slowly.
   */
  readonly onBlocked?: (failure: Failure) => void;
}

/** A share in a solver. */
export interface SolverLease {
  readonly solver: SolverService;
  /**
   * Starts the worker, if it has not started, and lets its engine compile what a solve needs: for the
   * time in which files are still on their way. It ends with the first question; nobody hears of it.
   */
  warm(): void;
  /** Gives it back: what is pending, and what is asked from now on, is rejected as cancelled. */
  readonly release: () => void;
}

/** A worker that nobody has leased is kept this long, for whoever comes next. [ms] */
const idlePatience = 5000;

const pools = new Map<string, SolverPool>();

/**
 * A share in the page's solvers, of which there are at most four, one core left free: the same worker for
 * all calls of a lease, since it keeps the last mesh; it starts with the first call.
 */
export function leaseSolver(places: LeasePlaces = {}): SolverLease {
  const key = JSON.stringify([placeOf(places.workerUrl), placeOf(places.wasmUrl)]);
  let pool = pools.get(key);
  if (!pool) {
    pool = new SolverPool(places, () => pools.delete(key));
    pools.set(key, pool);
  }
  return pool.lease(places.onBlocked);
}

function placeOf(url: string | URL | undefined): string | null {
  return url === undefined ? null : new URL(url, document.baseURI).href;
}

function workersWanted(): number {
  return Math.max(1, Math.min(mostCores, navigator.hardwareConcurrency - 1));
}

/** Workers with the same script and .wasm file, shared by leases. */
export class SolverPool {
  readonly #places: WorkerPlaces;
  readonly #emptied: () => void;
  readonly #workers = new Set<PooledWorker>();
  readonly #page: MainThreadSolver;

  /** @param emptied called when the last worker has been ended */
  constructor(places: WorkerPlaces = {}, emptied: () => void = () => undefined) {
    this.#places = places;
    this.#emptied = emptied;
    this.#page = new MainThreadSolver(places);
  }

  lease(onBlocked?: (failure: Failure) => void): SolverLease {
    const pooled = this.#freest();
    pooled.leases += 1;
    clearTimeout(pooled.ending);
    const solver = new LeasedSolver(pooled, this.#page, onBlocked);
    let released = false;
    const release = () => {
      if (released) return;
      released = true;
      solver.end();
      pooled.leases -= 1;
      if (pooled.leases > 0) return;
      pooled.ending = setTimeout(() => {
        this.#close(pooled);
      }, idlePatience);
    };
    const warm = () => {
      if (!released) pooled.warm();
    };
    return {solver, warm, release};
  }

  /** The worker with the fewest leases; a new one only if all have some. */
  #freest(): PooledWorker {
    const [freest] = [...this.#workers].sort((a, b) => a.leases - b.leases);
    if (freest && (freest.leases === 0 || this.#workers.size >= workersWanted())) return freest;
    const blocked = [...this.#workers].find((pooled) => pooled.blocked)?.blocked;
    const client = new SolverClient(this.#places, () =>
      helpersFor(navigator.hardwareConcurrency, this.#workers.size),
    );
    const pooled = new PooledWorker(client, blocked);
    this.#workers.add(pooled);
    return pooled;
  }

  #close(pooled: PooledWorker): void {
    pooled.client.dispose();
    this.#workers.delete(pooled);
    if (this.#workers.size === 0) this.#emptied();
  }
}

/** A worker of the pool, which starts with its first job. */
class PooledWorker {
  leases = 0;
  #warming: AbortController | undefined;
  ending: ReturnType<typeof setTimeout> | undefined;

  constructor(
    readonly client: SolverClient,
    /** Why there can be no worker, once that is known. */
    public blocked: SolverError | undefined,
  ) {}

  /** Once; what goes wrong goes wrong again for the first who asks for something. */
  warm(): void {
    if (this.#warming || this.blocked) return;
    this.#warming = new AbortController();
    this.#solveAll(this.#warming.signal).catch(() => undefined);
  }

  async #solveAll(signal: AbortSignal): Promise<void> {
    for (const problem of warmUpProblems) await this.client.solve(problem, {signal});
  }

  /** Asks the worker, which is to do nothing else but what it is asked. */
  ask<K extends keyof Answers>(question: QuestionOf<K>, hooks: QuestionHooks): Promise<Answers[K]> {
    (this.#warming ??= new AbortController()).abort();
    return this.client.ask<K>(question, hooks);
  }
}

/** A pooled worker as one lease sees it; the page itself where there can be no worker. */
class LeasedSolver extends TextService {
  readonly #pooled: PooledWorker;
  readonly #page: MainThreadSolver;
  readonly #released = new AbortController();
  #onBlocked: ((failure: Failure) => void) | undefined;

  constructor(
    pooled: PooledWorker,
    page: MainThreadSolver,
    onBlocked?: (failure: Failure) => void,
  ) {
    super();
    this.#pooled = pooled;
    this.#page = page;
    this.#onBlocked = onBlocked;
  }

  async ask<K extends keyof Answers>(
    question: QuestionOf<K>,
    hooks: QuestionHooks,
  ): Promise<Answers[K]> {
    const {signal: released} = this.#released;
    const signal = hooks.signal ? AbortSignal.any([hooks.signal, released]) : released;
    signal.throwIfAborted();
    const all = {...hooks, signal};
    if (!this.#pooled.blocked) {
      try {
        return await this.#pooled.ask<K>(question, all);
      } catch (error) {
        if (!(error instanceof SolverError) || error.code !== 'worker-blocked') throw error;
        this.#pooled.blocked = error;
      }
    }
    this.#tell(this.#pooled.blocked);
    return this.#page.ask<K>(question, all);
  }

  end(): void {
    const message = 'The solver was released.';
    this.#released.abort(new SolverError({code: 'cancelled', message}));
  }

  /** In a task of its own: what the listener throws is the page's, and ends no job. */
  #tell(failure: SolverError): void {
    const tell = this.#onBlocked;
    this.#onBlocked = undefined;
    if (tell) {
      queueMicrotask(() => {
        tell(failure);
      });
    }
  }
}
