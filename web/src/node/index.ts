import {readFile} from 'node:fs/promises';

import {SolverError} from '../model/failure.js';
import type {Garment} from '../model/garment.js';
import type {Problem, SolveHooks} from '../model/problem.js';
import type {SolveResult} from '../model/result.js';
import type {DetectedSymmetries} from '../model/symmetries.js';
import {SharedModule, type SeamwiseModule} from '../solver/load.js';
import {run} from '../solver/run.js';
import {convertGarment, detectSymmetries, Solver} from '../solver/solver.js';
import {jsonText, plainNames, problemTexts, type ProblemNames} from '../solver/texts.js';

export type {Alignment, Point} from '../model/geometry.js';
export type * from '../model/garment.js';
export type * from '../model/options.js';
export type * from '../model/print.js';
export type * from '../model/problem.js';
export type * from '../model/result.js';
export type * from '../model/symmetries.js';
export type {ProblemNames} from '../solver/texts.js';
export {SolverError, type Failure, type FailureCode} from '../model/failure.js';

const shared = new SharedModule(async () => ({
  wasmBinary: await readFile(new URL('../solver/module/seamwise.wasm', import.meta.url)),
}));

/** Hooks for programs that read files. */
export interface NodeSolveHooks extends SolveHooks {
  /** What to call the problem's parts in error messages: the names of their files. */
  readonly names?: Partial<ProblemNames>;
}

/**
 * Aligns a print with a sewing pattern and deforms the pattern so that the print matches at its seams.
 * Runs on this thread in slices of about 40 ms; several solves share it fairly.
 * @throws {SolverError} for bad input; the signal's reason, an `AbortError` by default, when it fires
 */
export async function solve(problem: Problem, hooks: NodeSolveHooks = {}): Promise<SolveResult> {
  hooks.signal?.throwIfAborted();
  const texts = problemTexts(problem, hooks.names);
  return withModule(async (module) => {
    hooks.signal?.throwIfAborted();
    const solver = new Solver(module, texts);
    try {
      return await run(solver, hooks);
    } finally {
      solver[Symbol.dispose]();
    }
  });
}

/** The symmetries a garment shows by itself: what `symmetry: 'auto'` would impose, group permitting. */
export async function symmetries(
  garment: Garment | string,
  name = plainNames.garment,
): Promise<DetectedSymmetries> {
  const text = jsonText(garment, name);
  return withModule(
    (module) => JSON.parse(detectSymmetries(module, text, name)) as DetectedSymmetries,
  );
}

/** A garment of any readable format as the text of a seamwise-garment/1 file. */
export async function convert(
  garment: Garment | string,
  name = plainNames.garment,
): Promise<string> {
  const text = jsonText(garment, name);
  return withModule((module) => convertGarment(module, text, name));
}

/** Memory of the shared module: its size, and what is in use of it. [bytes] */
export async function memory(): Promise<{readonly heap: number; readonly live: number}> {
  return withModule((module) => ({heap: module.heapBytes(), live: module.liveBytes()}));
}

/** Runs `work` on the shared module. After a trap the instance is not trusted again. */
async function withModule<T>(work: (module: SeamwiseModule) => T | Promise<T>): Promise<T> {
  const module = await shared.load();
  try {
    return await work(module);
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) {
      shared.discard();
      throw new SolverError({code: 'internal', message: `The solver broke: ${error.message}.`});
    }
    throw error;
  }
}
