import {readFile} from 'node:fs/promises';
import {availableParallelism} from 'node:os';
import {isMainThread} from 'node:worker_threads';

import type {Drape, DrapeSettings} from '../model/drape.js';
import type {Garment} from '../model/garment.js';
import type {GarmentDocument} from '../model/garment-document.js';
import type {Problem} from '../model/problem.js';
import type {MeshedPattern, Proof, SolveResult} from '../model/result.js';
import type {StoredDesign} from '../model/stored-design.js';
import type {DetectedSymmetries, MeasuredSymmetry, Symmetry} from '../model/symmetries.js';
import type {Remedy} from '../remedies/remedy.js';
import {localAnswerer} from '../solver/answering.js';
import {helpersFor} from '../solver/cores.js';
import type {HooksOf} from '../solver/requests/kinds.js';
import type {Requests} from '../solver/requests/requests.js';
import {
  plainNames,
  type NamedDrapeHooks,
  type NamedPrepareHooks,
  type NamedProofHooks,
  type NamedSolveHooks,
} from '../solver/requests/texts.js';
import {Helpers} from '../solver/seamwise/helpers.js';
import {TextService} from '../solver/service.js';
import {thread} from './thread.js';
import type {Order, OrderHooks} from './order.js';

export type {Alignment, MirrorMap, Point} from '../model/geometry.js';
export * from '../model/drape.js';
export * from '../model/drape-file.js';
export * from '../model/glb.js';
export type * from '../model/garment.js';
export type * from '../model/garment-document.js';
export {garmentFile} from '../model/garment-file.js';
export type * from '../model/options.js';
export type * from '../model/print.js';
export type * from '../model/method.js';
export type * from '../model/problem.js';
export type {NoteCode, NoteDetail, SymmetryReason} from '../model/notes.js';
export type * from '../model/result.js';
export type * from '../model/symmetries.js';
export type {
  NamedDrapeHooks as NodeDrapeHooks,
  NamedPrepareHooks as NodePrepareHooks,
  NamedProofHooks as NodeProofHooks,
  NamedSolveHooks as NodeSolveHooks,
  ProblemNames,
} from '../solver/requests/texts.js';
export {SolverError, type Failure, type FailureCode} from '../model/failure.js';
export {problemOfStored} from '../model/design-problem.js';
export * from '../model/stored-design.js';
export type * from '../model/stored-file.js';
export {resultText, sha256Of} from '../model/result-text.js';
export {FileError} from '../model/versioned-file.js';
export type {Order, OrderHooks} from './order.js';
export type {Remedy, RemedyChange, RemedyKind} from '../remedies/remedy.js';

/** For a program that solves on threads of its own, as a batch does, all cores are at work already. */
const most = isMainThread ? helpersFor(availableParallelism()) : 0;

const wasmFile = (name: string) =>
  readFile(new URL(`../solver/module/${name}.wasm`, import.meta.url));

/** The solver on this thread. */
class ThreadSolver extends TextService {
  readonly #answerer = localAnswerer(
    {sources: {seamwise: () => wasmFile('seamwise'), drape: () => wasmFile('drape')}},
    new Helpers(thread),
  );

  ask<K extends keyof Requests>(
    kind: K,
    request: Requests[K]['request'],
    hooks: HooksOf<Requests[K]>,
  ): Promise<Requests[K]['answer']> {
    return this.#answerer.answer(kind, request, {...hooks, helpers: most});
  }
}

const solver = new ThreadSolver();

/**
 * Aligns a print with a sewing pattern and deforms the pattern so that the print matches at its seams.
 * Runs on this thread in slices of about 40 ms, two solves at a time, in the order they came. Called on the main
 * thread, it has threads of its own help with what takes long, which changes no result.
 * @throws {SolverError} for bad input; the signal's reason, an `AbortError` by default, when it fires
 */
export async function solve(problem: Problem, hooks: NamedSolveHooks = {}): Promise<SolveResult> {
  return solver.solve(problem, hooks);
}

/**
 * What would make the seams of a result meet that stay off, each tried by solving once more and kept only where it
 * clearly helps; the first is the most likely. At most four are tried, none where all seams meet to within 3 mm.
 * @param problem that of the result
 * @throws the signal's reason, an `AbortError` by default, when it fires
 */
export async function remedies(
  problem: Problem,
  result: SolveResult,
  {signal, names}: NamedPrepareHooks = {},
): Promise<readonly Remedy[]> {
  const {remediesOf} = await import('../remedies/remedies.js');
  return remediesOf(
    problem,
    result,
    (changed, stop) => solve(changed, {...(stop && {signal: stop}), ...(names && {names})}),
    {signal},
  );
}

/**
 * Solves a stored design again, from the very files that it was made with.
 * @param design an object, or its JSON text
 * @throws {FileError} when the design is damaged, or when a file cannot be read or is another one;
 *   {SolverError} for a bad garment or print; the signal's reason, when it fires
 */
export async function order(design: StoredDesign | string, hooks: OrderHooks = {}): Promise<Order> {
  const {orderWith} = await import('./order.js');
  return orderWith(solve, design, hooks);
}

/**
 * A solved garment as it is worn: hung on a form and left to settle. `drapeFile` makes a file of it, `glb` what other
 * programs show. Runs on this thread in slices, one drape at a time.
 * @throws {SolverError} for bad input, such as a garment whose file does not say where its pieces hang; the signal's
 *   reason, when it fires
 */
export async function drape(
  result: SolveResult | string,
  settings: DrapeSettings = {},
  hooks: NamedDrapeHooks = {},
): Promise<Drape> {
  return solver.drape(result, settings, hooks);
}

/** The symmetries a garment shows by itself: what `symmetry: 'auto'` would impose, group permitting. */
export async function symmetries(
  garment: Garment | string,
  name = plainNames.garment,
): Promise<DetectedSymmetries> {
  return solver.symmetries(garment, {name});
}

/**
 * The garment as a solve would begin with it: checked, meshed, its symmetries settled.
 * @throws {SolverError} as `solve` does
 */
export async function prepare(
  problem: Problem,
  hooks: NamedPrepareHooks = {},
): Promise<MeshedPattern> {
  return solver.prepare(problem, hooks);
}

/**
 * How good alignments of the pieces as drafted can be: looked into until no more can be proven, which may take
 * minutes, or until the signal fires. While something is solved it waits.
 * @throws {SolverError} as `solve` does
 */
export async function prove(problem: Problem, hooks: NamedProofHooks = {}): Promise<Proof> {
  return solver.prove(problem, hooks);
}

/**
 * Measures one symmetry on a garment, whether or not the garment mirrors so.
 * @throws {SolverError} for bad input, such as a piece that the garment does not have
 */
export async function mirror(
  garment: Garment | string,
  symmetry: Symmetry,
  name = plainNames.garment,
): Promise<MeasuredSymmetry> {
  return solver.mirror(garment, symmetry, {name});
}

/**
 * A garment of any readable format as one document: pieces face side up in centimetres, seams, matches, symmetries, and
 * what its file leaves open. `garmentFile` writes one.
 * @throws {SolverError} for bad input
 */
export async function readGarment(
  garment: Garment | string,
  name = plainNames.garment,
): Promise<GarmentDocument> {
  return solver.garment(garment, {name});
}

/** A garment of any readable format as the text of a seamwise-garment/1 file. */
export async function convert(
  garment: Garment | string,
  name = plainNames.garment,
): Promise<string> {
  return solver.convert(garment, {name});
}

/** Memory of the shared module: its size, and what is in use of it. [bytes] */
export async function memory(): Promise<{readonly heap: number; readonly live: number}> {
  return solver.ask('memory', {}, {});
}
