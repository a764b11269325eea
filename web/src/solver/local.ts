import type {SolveHooks} from '../model/problem.js';
import type {SolveResult} from '../model/result.js';
import type {DetectedSymmetries} from '../model/symmetries.js';
import {internalError} from './broken.js';
import {SharedModule, type SeamwiseModule} from './load.js';
import {run} from './run.js';
import {convertGarment, detectSymmetries, Solver} from './solver.js';
import type {ProblemTexts} from './texts.js';
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
    return this.#withModule(async (module) => {
      hooks.signal?.throwIfAborted();
      const solver = new Solver(module, texts);
      try {
        return await run(solver, hooks);
      } finally {
        solver[Symbol.dispose]();
      }
    });
  }

  /** @throws {SolverError} */
  symmetries(garment: string, name: string): Promise<DetectedSymmetries> {
    return this.#withModule(
      (module) => JSON.parse(detectSymmetries(module, garment, name)) as DetectedSymmetries,
    );
  }

  /** @throws {SolverError} */
  convert(garment: string, name: string): Promise<string> {
    return this.#withModule((module) => convertGarment(module, garment, name));
  }

  /** Memory of the module: its size, and what is in use of it. [bytes] */
  memory(): Promise<{readonly heap: number; readonly live: number}> {
    return this.#withModule((module) => ({heap: module.heapBytes(), live: module.liveBytes()}));
  }

  /** Runs `work` on the shared module. After a trap the instance is not trusted again. */
  async #withModule<T>(work: (module: SeamwiseModule) => T | Promise<T>): Promise<T> {
    const module = await this.#load();
    try {
      return await work(module);
    } catch (error) {
      if (error instanceof WebAssembly.RuntimeError) {
        this.#shared.discard();
        throw internalError('The solver broke', error);
      }
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
