import {failureOf, SolverError, type Failure} from '../model/failure.js';
import type {MeshedPattern} from '../model/result.js';
import {internalError} from './broken.js';
import {Helpers} from './helpers.js';
import {LocalSolver} from './local.js';
import {nestedWorker} from './nested-worker.js';
import {protocolVersion, type FromWorker, type JobRequest, type ToWorker} from './protocol.js';
import type {QuestionHooks} from './service.js';

/** What a worker's global scope has; written out, since its types exclude those of a page. */
interface WorkerScope {
  postMessage(message: FromWorker, options?: StructuredSerializeOptions): void;
  addEventListener(type: 'message', listener: (event: {readonly data: ToWorker}) => void): void;
}

/** Solves for a page, in slices, so that a cancel is seen between any two. */
export function serve(scope: WorkerScope): void {
  const service = new Service(scope);
  scope.addEventListener('message', ({data}) => {
    service.receive(data);
  });
  scope.postMessage({kind: 'ready', version: protocolVersion});
}

class Service {
  readonly #scope: WorkerScope;
  readonly #jobs = new Map<number, AbortController>();
  /** Threads to help; none where workers cannot start any. */
  readonly #helpers = 'Worker' in globalThis ? new Helpers(nestedWorker) : undefined;
  #solver = new LocalSolver(undefined, {helpers: this.#helpers});

  constructor(scope: WorkerScope) {
    this.#scope = scope;
  }

  receive(message: ToWorker): void {
    switch (message.kind) {
      case 'locate':
        this.#solver = new LocalSolver(() => ({locateFile: () => message.wasmUrl}), {
          helpers: this.#helpers,
        });
        break;
      case 'module':
        this.#solver = new LocalSolver(() => ({module: message.module}));
        break;
      case 'ping':
        this.#scope.postMessage({kind: 'pong'});
        break;
      case 'cancel':
        this.#jobs.get(message.job)?.abort();
        break;
      case 'solve':
      case 'prepare':
      case 'prove':
      case 'mirror':
      case 'symmetries':
      case 'convert':
      case 'share':
        void this.#work(message);
        break;
      default:
        message satisfies never;
    }
  }

  async #work(request: JobRequest): Promise<void> {
    const {job} = request;
    const controller = new AbortController();
    this.#jobs.set(job, controller);
    try {
      const hooks = this.#hooks(request, controller.signal);
      const answer = await this.#solver.answer(request, hooks);
      this.#scope.postMessage({kind: 'done', job, answer});
    } catch (error) {
      const failure = toFailure(error, controller.signal);
      this.#scope.postMessage({kind: 'failed', job, failure});
    } finally {
      this.#jobs.delete(job);
    }
  }

  #hooks(request: JobRequest, signal: AbortSignal): QuestionHooks {
    const {job} = request;
    const onPattern = (pattern: MeshedPattern) => {
      this.#scope.postMessage({kind: 'pattern', job, pattern});
    };
    return {
      signal,
      ...(request.kind === 'solve' && request.showsPattern && {onPattern}),
      onProgress: (progress) => {
        this.#scope.postMessage({kind: 'progress', job, ...progress});
      },
      onProof: (proof) => {
        this.#scope.postMessage({kind: 'proof', job, proof});
      },
      onPartial: (alignments) => {
        const transfer = [alignments.buffer as ArrayBuffer];
        this.#scope.postMessage({kind: 'partial', job, alignments}, {transfer});
      },
    };
  }
}

/** As plain data; whatever is neither the caller's fault nor wish is the solver's own. */
function toFailure(error: unknown, signal: AbortSignal): Failure {
  const known = error instanceof SolverError ? error : unexpected(error, signal);
  return failureOf(known);
}

function unexpected(error: unknown, signal: AbortSignal): SolverError {
  if (error !== signal.reason) return internalError('The solver broke', error);
  return new SolverError({code: 'cancelled', message: 'The job was cancelled.'});
}
