import {SolverError} from '../model/failure.js';
import type {GarmentDocument} from '../model/garment-document.js';
import type {ProofHooks, SolveHooks} from '../model/problem.js';
import type {MeshedPattern, Proof, SolveResult} from '../model/result.js';
import type {DetectedSymmetries, MeasuredSymmetry} from '../model/symmetries.js';
import {brokenModule, loadingError} from './broken.js';
import type {Helpers} from './helpers.js';
import {SharedModule, type SeamwiseModule, type Settings} from './load.js';
import type {Answer, Answers, Question, QuestionOf} from './protocol.js';
import {ownThread, type Pace} from './pace.js';
import {run, runInSlices, runPreparation} from './run.js';
import {Share} from './share.js';
import {convertGarment, Detection, garmentDocument, measureSymmetry, Solver} from './solver.js';
import type {QuestionHooks} from './service.js';
import type {MirrorTexts, ProblemTexts} from './texts.js';
import {TaskQueue} from './task-queue.js';
import {unlessAborted} from './unless-aborted.js';

/** A small solve need not wait for a large one before it; more at once would only keep all waiting. */
const solvesAtOnce = 2;

/** A share that is of no use any more must not keep others waiting. [ms] */
const shareSlice = 20;

interface LocalWays {
  readonly pace?: Pace;
  readonly patience?: number | undefined;
  readonly helpers?: Helpers | undefined;
}

/**
 * The solver on the thread that calls it, with one module instance. Solves take turns in the order they
 * came, two of them in slices side by side; everything else is answered at once.
 */
export class LocalSolver {
  readonly #shared: SharedModule;
  readonly #pace: Pace;
  readonly #queue = new TaskQueue(solvesAtOnce);
  /** The sooner one share has ended, the sooner it is of use. */
  readonly #shareQueue = new TaskQueue(1);
  readonly #helpers: Helpers | undefined;

  /**
   * @param settings how to find the .wasm file; in a page or worker it is found by itself
   * @param patience how long that may take [ms]
   * @param helpers other threads for what takes long; none, unless said otherwise
   */
  constructor(
    settings?: () => Settings | Promise<Settings>,
    {pace = ownThread, patience, helpers}: LocalWays = {},
  ) {
    this.#shared = new SharedModule(settings, patience);
    this.#pace = pace;
    this.#helpers = helpers;
  }

  /** Answers any question. @throws {SolverError}; the signal's reason, as soon as it fires */
  answer<K extends keyof Answers>(
    question: QuestionOf<K>,
    hooks: QuestionHooks,
  ): Promise<Answers[K]> {
    return this.#answer(question, hooks) as Promise<Answers[K]>;
  }

  #answer(question: Question, hooks: QuestionHooks): Promise<Answer> {
    switch (question.kind) {
      case 'solve':
        return this.solve(question.texts, hooks, question.helpers);
      case 'prove':
        return this.prove(question.texts, hooks);
      case 'prepare':
        return this.prepare(question.texts, hooks.signal);
      case 'mirror':
        return this.mirror(question.texts, hooks.signal);
      case 'share':
        return this.share(question.order, hooks.signal);
      case 'garment':
      case 'symmetries':
      case 'convert':
        return this[question.kind](question.garment, question.name, hooks.signal);
      default:
        return question satisfies never;
    }
  }

  /**
   * @param most how many threads may help
   * @throws {SolverError} for bad input; the signal's reason, as soon as it fires
   */
  solve(texts: ProblemTexts, hooks: SolveHooks, most = 0): Promise<SolveResult> {
    const solve = () =>
      this.#withSolver(texts, hooks.signal, async (solver) => {
        const help = () => this.#helpers?.help(solver, this.#shared.compiled, most) ?? false;
        try {
          return await run(solver, hooks, this.#pace, help);
        } finally {
          this.#helpers?.leave(solver);
        }
      });
    return this.#queue.take(solve, hooks.signal);
  }

  /** The garment as a solve would begin with it. @throws {SolverError}; the signal's reason */
  prepare(texts: ProblemTexts, signal?: AbortSignal): Promise<MeshedPattern> {
    return this.#withSolver(texts, signal, async (solver) => {
      await runPreparation(solver, {...(signal && {signal})}, this.#pace);
      return solver.pattern();
    });
  }

  /** Until no more can be proven, or the signal fires; while nothing is solved. @throws {SolverError} */
  prove(texts: ProblemTexts, {signal, onProof}: ProofHooks): Promise<Proof> {
    return this.#withSolver(texts, signal, async (solver) => {
      await runPreparation(solver, {...(signal && {signal})}, this.#pace);
      let told = 0;
      const work = (slice: number): boolean => {
        if (!this.#queue.isIdle) return true;
        const more = solver.prove(slice);
        const proof = solver.proof();
        if (proof.bound > told) onProof?.(proof);
        told = proof.bound;
        return more;
      };
      await runInSlices(work, signal, this.#pace);
      return solver.proof();
    });
  }

  /** @throws {SolverError} */
  symmetries(garment: string, name: string, signal?: AbortSignal): Promise<DetectedSymmetries> {
    const find = async (detection: Detection) => {
      await runInSlices((slice) => detection.advance(slice), signal, this.#pace);
      return detection.result();
    };
    return this.#withModule(
      (module) => freeing(new Detection(module, garment, name), find),
      signal,
    );
  }

  /** One symmetry, measured on the garment whether or not it mirrors. @throws {SolverError} */
  mirror(texts: MirrorTexts, signal?: AbortSignal): Promise<MeasuredSymmetry> {
    return this.#withModule((module) => measureSymmetry(module, texts), signal);
  }

  /** Runs a share of another thread's search. @throws {SolverError}; the signal's reason */
  share(order: Float64Array, signal?: AbortSignal): Promise<Float64Array> {
    const pace = {...this.#pace, slice: shareSlice};
    const work = async (share: Share) => {
      await runInSlices((slice) => share.advance(slice), signal, pace);
      return share.answers();
    };
    const run = () => this.#withModule((module) => freeing(new Share(module, order), work), signal);
    return this.#shareQueue.take(run, signal);
  }

  /** @throws {SolverError} */
  garment(garment: string, name: string, signal?: AbortSignal): Promise<GarmentDocument> {
    return this.#withModule((module) => garmentDocument(module, garment, name), signal);
  }

  /** @throws {SolverError} */
  convert(garment: string, name: string, signal?: AbortSignal): Promise<string> {
    return this.#withModule((module) => convertGarment(module, garment, name), signal);
  }

  /** Memory of the module: its size, and what is in use of it. [bytes] */
  memory(): Promise<{readonly heap: number; readonly live: number}> {
    return this.#withModule((module) => ({heap: module.heapBytes(), live: module.liveBytes()}));
  }

  #withSolver<T>(
    texts: ProblemTexts,
    signal: AbortSignal | undefined,
    work: (solver: Solver) => T | Promise<T>,
  ): Promise<T> {
    return this.#withModule((module) => freeing(new Solver(module, texts), work), signal);
  }

  /** Runs `work` on the shared module. An instance that broke, or ran out of memory, is not trusted again. */
  async #withModule<T>(
    work: (module: SeamwiseModule) => T | Promise<T>,
    signal?: AbortSignal,
  ): Promise<T> {
    const module = await unlessAborted(this.#load(), signal);
    try {
      return await work(module);
    } catch (error) {
      if (error instanceof WebAssembly.RuntimeError) {
        this.#shared.discard();
        throw brokenModule(error);
      }
      if (error instanceof SolverError && error.code === 'internal') this.#shared.discard();
      throw error;
    }
  }

  async #load(): Promise<SeamwiseModule> {
    try {
      return await this.#shared.load();
    } catch (error) {
      throw loadingError(error);
    }
  }
}

/** Frees memory of the module when `work` has ended, unless the module broke: all of it goes then. */
async function freeing<O extends Disposable, T>(
  owner: O,
  work: (owner: O) => T | Promise<T>,
): Promise<T> {
  let broken = false;
  try {
    return await work(owner);
  } catch (error) {
    broken = error instanceof WebAssembly.RuntimeError;
    throw error;
  } finally {
    if (!broken) owner[Symbol.dispose]();
  }
}
