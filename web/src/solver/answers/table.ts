import type {HooksOf, RequestKind, RequestKinds} from '../requests/kinds.js';
import type {ModuleLoader, Modules} from './shared-module.js';
import type {Pace} from './slices.js';

/** Requests that wait for each other, in the order they came. */
export interface Queue {
  /** How many of them are answered side by side. */
  readonly atOnce: number;
}

/** A request at work. */
interface Job<Q extends RequestKind> {
  readonly hooks: HooksOf<Q>;
  readonly pace: Pace;
  /** What the module is made of, for other threads to run the very same. */
  readonly compiled: WebAssembly.Module | undefined;
  /** Whether nobody is at work in a queue. */
  readonly isIdle: (queue: Queue) => boolean;
}

/** How requests of one kind are answered. */
export interface Answering<Q extends RequestKind, Ms extends Modules, N extends keyof Ms> {
  readonly module: N;
  /** Where it waits for its turn; without one it begins at once. */
  readonly queue?: Queue;
  /** Whose typed arrays another thread is given, not copies of them: so they must be no views of the module's memory. */
  readonly transfers?: readonly ('answer' | keyof Q['hooks'])[];
  /** @throws {SolverError}, of which `internal` has the module replaced; the signal's reason, when it has fired */
  answer(module: Ms[N], request: Q['request'], job: Job<Q>): Q['answer'] | Promise<Q['answer']>;
}

/** All that a thread can answer: modules, each loaded when it is first needed, and what is asked of which. */
export interface AnswerTable<R extends RequestKinds, Ms extends Modules> {
  readonly modules: {readonly [N in keyof Ms]: ModuleLoader<Ms[N]>};
  readonly requests: {
    readonly [K in keyof R]: {readonly [N in keyof Ms]: Answering<R[K], Ms, N>}[keyof Ms];
  };
}
