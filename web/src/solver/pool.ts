import {SolverError, type Failure} from '../model/failure.js';
import {SolverClient} from './client.js';
import {helpersFor, mostCores} from './cores.js';
import {MainThreadSolver} from './main-thread.js';
import type {WorkerPlaces} from './page-worker.js';
import type {HooksOf} from './requests/kinds.js';
import type {Requests} from './requests/requests.js';
import {TextService} from './service.js';
import {warmUpProblems} from './warm-up.js';

/** Where to find the solver, and who hears when it can have no worker. */
export interface LeasePlaces extends WorkerPlaces {
  /**
   * Hears at most once, with the code `worker-blocked`, that no worker can be had. The lease goes on
   * without: on the page's own thread, with the same results, and more slowly.
   */
  readonly onBlocked?: (failure: Failure) => void;
}

/** A lease on a pooled worker. */
export interface SolverLease {
  readonly solver: TextService;
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
 * all calls of a lease, since it keeps the last mesh; it starts with the first call. Drapes and
 * layouts on cloth of all leases have one worker more, where they wait for their like and never hold up a solve.
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
/** Kinds of requests that a worker of their own answers, so that no solve waits for them. */
const besideSolves: ReadonlySet<keyof Requests> = new Set([
  'drape',
  'marker',
  'photo',
  'photoTile',
  'photoObject',
]);

export class SolverPool {
  readonly #places: WorkerPlaces;
  readonly #emptied: () => void;
  readonly #workers = new Set<PooledWorker>();
  readonly #shared: Shared;

  /** @param emptied called when the last worker has been ended */
  constructor(places: WorkerPlaces = {}, emptied: () => void = () => undefined) {
    this.#places = places;
    this.#emptied = emptied;
    this.#shared = {page: new MainThreadSolver(places), aside: new SolverClient(places)};
  }

  lease(onBlocked?: (failure: Failure) => void): SolverLease {
    const pooled = this.#freest();
    pooled.leases += 1;
    clearTimeout(pooled.ending);
    const solver = new LeasedSolver(pooled, this.#shared, onBlocked);
    const release = () => {
      if (!solver.end()) return;
      pooled.leases -= 1;
      if (pooled.leases > 0) return;
      pooled.ending = setTimeout(() => {
        this.#close(pooled);
      }, idlePatience);
    };
    const warm = () => {
      solver.warm();
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
    const pooled = {client, leases: 0, ending: undefined, blocked, warming: undefined};
    this.#workers.add(pooled);
    return pooled;
  }

  #close(pooled: PooledWorker): void {
    pooled.client.dispose();
    this.#workers.delete(pooled);
    if (this.#workers.size > 0) return;
    this.#shared.aside.dispose();
    this.#emptied();
  }
}

/** What all leases of a pool have in common; what they never ask is never started. */
interface Shared {
  readonly page: MainThreadSolver;
  /** For what takes long and is no solve. */
  readonly aside: SolverClient;
}

/** A worker of the pool, which starts with its first job. */
interface PooledWorker {
  readonly client: SolverClient;
  leases: number;
  ending: ReturnType<typeof setTimeout> | undefined;
  /** Why there can be no worker, once that is known. */
  blocked: SolverError | undefined;
  /** What it solves to be warm, from when it is told to, or is asked anything; aborted by the latter. */
  warming: AbortController | undefined;
}

/** A pooled worker as one lease sees it; the page itself where there can be no worker. */
class LeasedSolver extends TextService {
  readonly #pooled: PooledWorker;
  readonly #shared: Shared;
  readonly #released = new AbortController();
  #onBlocked: ((failure: Failure) => void) | undefined;

  constructor(pooled: PooledWorker, shared: Shared, onBlocked?: (failure: Failure) => void) {
    super();
    this.#pooled = pooled;
    this.#shared = shared;
    this.#onBlocked = onBlocked;
  }

  async ask<K extends keyof Requests>(
    kind: K,
    request: Requests[K]['request'],
    hooks: HooksOf<Requests[K]>,
  ): Promise<Requests[K]['answer']> {
    const pooled = this.#pooled;
    const {signal: released} = this.#released;
    const signal = hooks.signal ? AbortSignal.any([hooks.signal, released]) : released;
    signal.throwIfAborted();
    const all = {...hooks, signal};
    (pooled.warming ??= new AbortController()).abort(); // the worker is to do nothing else
    if (!pooled.blocked) {
      const client = besideSolves.has(kind) ? this.#shared.aside : pooled.client;
      try {
        return await client.ask(kind, request, all);
      } catch (error) {
        if (!(error instanceof SolverError) || error.code !== 'worker-blocked') throw error;
        pooled.blocked = error;
      }
    }
    this.#tell(pooled.blocked);
    return this.#shared.page.ask(kind, request, all);
  }

  /** Once for all leases; what goes wrong goes wrong again for the first who asks for something. */
  warm(): void {
    const {client, blocked, warming} = this.#pooled;
    if (this.#released.signal.aborted || warming || blocked) return;
    const {signal} = (this.#pooled.warming = new AbortController());
    const solveAll = async () => {
      for (const problem of warmUpProblems) await client.solve(problem, {signal});
    };
    solveAll().catch(() => undefined);
  }

  /** @returns whether it has not been ended before */
  end(): boolean {
    if (this.#released.signal.aborted) return false;
    const message = 'The solver was released.';
    this.#released.abort(new SolverError({code: 'cancelled', message}));
    return true;
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
