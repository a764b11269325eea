import {SolverError, type Failure} from '../model/base/failure.js';
import {MainThreadSolver, SolverClient, type WorkerPlaces} from './page-solvers.js';
import {helpersFor, mostCores, type HooksOf, type Requests} from './requests/requests.js';
import {TextService} from './service.js';
import {warmUpProblems} from './warm-up.js';

/** URLs of the solver, and a callback for a page that cannot have a worker. */
export interface LeasePlaces extends WorkerPlaces {
  /**
   * Called at most once, with the code `worker-blocked`, if no worker can be started. The lease
   * continues on the page's own thread, with the same results, but more slowly.
   */
  readonly onBlocked?: (failure: Failure) => void;
}

/** A lease on a pooled worker. */
export interface SolverLease {
  readonly solver: TextService;
  /**
   * Starts the worker, if it has not started, and lets its engine compile the code of a solve while
   * files are still loading. The first request ends it; its failures are not reported.
   */
  warm(): void;
  /** Ends the lease. Pending requests and all later ones are rejected as cancelled. */
  readonly release: () => void;
}

/** Time for which an unused worker is kept for the next lease. [ms] */
const idlePatience = 5000;

const pools = new Map<string, SolverPool>();

/**
 * Leases one of the page's solvers. There are at most four, and one core stays free. All calls of a
 * lease use the same worker, since it keeps the last mesh; the worker starts with the first call.
 * Drapes, layouts and photos of all leases share one more worker. They wait for each other there
 * and never delay a solve.
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

/** Kinds of requests that a separate worker answers, so that no solve waits for them. */
const besideSolves: ReadonlySet<keyof Requests> = new Set([
  'drape',
  'marker',
  'photo',
  'photoTile',
  'photoObject',
]);

/** Workers with the same script and .wasm file, shared by leases. */
export class SolverPool {
  readonly #places: WorkerPlaces;
  readonly #emptied: () => void;
  readonly #workers = new Set<PooledWorker>();
  readonly #shared: Shared;

  /** @param emptied called when the last worker has ended */
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

  /**
   * The worker with the fewest leases; a new one only if all workers have leases and more are
   * allowed.
   */
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

/** Solvers that all leases of a pool share; each starts with its first request. */
interface Shared {
  readonly page: MainThreadSolver;
  /** Worker for long requests other than solves. */
  readonly aside: SolverClient;
}

/** A worker of the pool, which starts with its first job. */
interface PooledWorker {
  readonly client: SolverClient;
  leases: number;
  ending: ReturnType<typeof setTimeout> | undefined;
  /** Reason why no worker can be started, once it is known. */
  blocked: SolverError | undefined;
  /**
   * Controls the warm-up. It is set by the warm-up or the first request, and every request aborts
   * it.
   */
  warming: AbortController | undefined;
}

/** A pooled worker for one lease; the page's own thread if no worker can be started. */
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
    (pooled.warming ??= new AbortController()).abort(); // the worker must do nothing else
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

  /**
   * Warms the worker up, once for all leases. Failures are ignored, because they recur at the first
   * request.
   */
  warm(): void {
    const {client, blocked, warming} = this.#pooled;
    if (this.#released.signal.aborted || warming || blocked) return;
    const {signal} = (this.#pooled.warming = new AbortController());
    const solveAll = async () => {
      for (const problem of warmUpProblems) await client.solve(problem, {signal});
    };
    solveAll().catch(() => undefined);
  }

  /** Ends the lease. @returns whether it had not ended before */
  end(): boolean {
    if (this.#released.signal.aborted) return false;
    const message = 'The solver was released.';
    this.#released.abort(new SolverError({code: 'cancelled', message}));
    return true;
  }

  /**
   * Calls the callback in a separate microtask, so that its errors are the page's and end no job.
   */
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

/**
 * A solver that outlives its lease: it takes one for each request, and may release it in between.
 */
export class LastingSolver extends TextService implements SolverLease {
  readonly solver = this;
  readonly #places: () => LeasePlaces;
  #lease: SolverLease | undefined;

  /** @param places called for each new lease */
  constructor(places: () => LeasePlaces) {
    super();
    this.#places = places;
  }

  get #leased(): SolverLease {
    return (this.#lease ??= leaseSolver(this.#places()));
  }

  warm(): void {
    this.#leased.warm();
  }

  release(): void {
    this.#lease?.release();
    this.#lease = undefined;
  }

  ask<K extends keyof Requests>(
    kind: K,
    request: Requests[K]['request'],
    hooks: HooksOf<Requests[K]>,
  ): Promise<Requests[K]['answer']> {
    return this.#leased.solver.ask(kind, request, hooks);
  }
}
