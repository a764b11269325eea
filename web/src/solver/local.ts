import {SolverError} from '../model/failure.js';
import type {SolveHooks} from '../model/problem.js';
import type {MeshedPattern, SolveResult} from '../model/result.js';
import type {DetectedSymmetries, MeasuredSymmetry} from '../model/symmetries.js';
import {internalError} from './broken.js';
import {SharedModule, type SeamwiseModule} from './load.js';
import {run} from './run.js';
import {convertGarment, detectSymmetries, measureSymmetries, Solver} from './solver.js';
import {plainNames, type MirrorTexts, type ProblemTexts} from './texts.js';
import type {ModuleSettings} from './module/seamwise.mjs';

/** The solver on the thread that calls it; several calls share the thread, and one module instance. */
export class LocalSolver {
  readonly #shared: SharedModule;

  /** @param settings how to find the .wasm file; in a page or worker it is found by itself */
  constructor(settings?: () => ModuleSettings | Promise<ModuleSettings>) {
    this.#shared = new SharedModule(settings);
  }

  /** @throws {SolverError} for bad input; the signal's reason, as soon as it fires */
  solve(texts: ProblemTexts, hooks: SolveHooks): Promise<SolveResult> {
    return this.#withSolver(texts, hooks.signal, (solver) => run(solver, hooks));
  }

  /** The garment as a solve would begin with it. @throws {SolverError}; the signal's reason */
  prepare(texts: ProblemTexts, signal?: AbortSignal): Promise<MeshedPattern> {
    return this.#withSolver(texts, signal, (solver) => solver.pattern());
  }

  /** @throws {SolverError} */
  symmetries(garment: string, name: string): Promise<DetectedSymmetries> {
    return this.#withModule(
      (module) => JSON.parse(detectSymmetries(module, garment, name)) as DetectedSymmetries,
    );
  }

  /** One symmetry, measured on the garment whether or not it mirrors. @throws {SolverError} */
  mirror({garment, name, symmetries}: MirrorTexts): Promise<MeasuredSymmetry> {
    return this.#withModule((module) => {
      const text = measureSymmetries(module, garment, name, symmetries, plainNames.symmetry);
      const [measured] = (JSON.parse(text) as {symmetries: [MeasuredSymmetry]}).symmetries;
      return measured;
    });
  }

  /** @throws {SolverError} */
  convert(garment: string, name: string): Promise<string> {
    return this.#withModule((module) => convertGarment(module, garment, name));
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
    return this.#withModule(async (module) => {
      signal?.throwIfAborted();
      const solver = new Solver(module, texts);
      try {
        return await work(solver);
      } finally {
        solver[Symbol.dispose]();
      }
    });
  }

  /** Runs `work` on the shared module. An instance that broke, or ran out of memory, is not trusted again. */
  async #withModule<T>(work: (module: SeamwiseModule) => T | Promise<T>): Promise<T> {
    const module = await this.#load();
    try {
      return await work(module);
    } catch (error) {
      if (error instanceof WebAssembly.RuntimeError) {
        this.#shared.discard();
        throw internalError('The solver broke', error);
      }
      if (error instanceof SolverError && error.code === 'internal') this.#shared.discard();
      throw error;
    }
  }

  async #load(): Promise<SeamwiseModule> {
    try {
      return await this.#shared.load();
    } catch (error) {
      throw internalError('The solver could not be loaded', error);
    }
  }
}
