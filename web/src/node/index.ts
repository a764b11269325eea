import type {Drape, DrapeSettings} from '../model/drape.js';
import type {Garment} from '../model/garment.js';
import type {GarmentDocument} from '../model/garment-document.js';
import type {LayPlan} from '../model/lay-plan.js';
import type {MarkerHooks, MarkerProblem} from '../model/marker.js';
import type {PhotoHooks, PhotoPixels} from '../model/photo.js';
import type {Problem, SolveHooks} from '../model/problem.js';
import type {MeshedPattern, Proof, SolveResult} from '../model/result.js';
import type {StoredDesign} from '../model/stored-design.js';
import type {DetectedSymmetries, MeasuredSymmetry, Symmetry} from '../model/symmetries.js';
import type {MarkerGarment} from '../marker/pieces.js';
import type {SeamSuggestions, SuggestionSettings} from '../pairing/report.js';
import type {Remedy} from '../remedies/remedy.js';
import {
  plainNames,
  type NamedDrapeHooks,
  type NamedPrepareHooks,
  type NamedProofHooks,
  type NamedSolveHooks,
} from '../solver/requests/texts.js';
import type {Cut, CutSettings} from './cut.js';
import type {ImportedGarment, ImportOptions} from './import.js';
import type {MarkerPlanHooks, NodeMarkerSettings} from './marker.js';
import type {LayPlanFiles, LayPlanSettings} from './lay-plan.js';
import type {Order, OrderHooks} from './order.js';
import type {PrintFromPixels, PrintFromPixelsSettings} from './photo.js';
import {ThreadSolver} from './thread-solver.js';

export * from './exports.js';

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
 * Solves a stored design again, from the very files that it was made with, and lays it on `cloth` where that is given.
 * @param design an object, or its JSON text
 * @throws {FileError} when the design is damaged, or when a file cannot be read or is another one;
 *   {SolverError} for a bad garment or print; the signal's reason, when it fires
 */
export async function order(design: StoredDesign | string, hooks: OrderHooks = {}): Promise<Order> {
  const {orderWith} = await import('./order.js');
  return orderWith(solver, design, hooks);
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

/**
 * The pieces of a result to cut, laid on a sheet at true scale, and how that is divided among pages. Files of it, as PDF
 * and as SVG, are made when they are asked for.
 * @throws {RangeError} for a paper that is none
 */
export async function cut(result: SolveResult, settings: CutSettings): Promise<Cut> {
  const {cutWith} = await import('./cut.js');
  return cutWith(result, settings);
}

/**
 * The pieces of one or several results on a bolt of their print: each so that the cloth shows on it what the result asks
 * for, on as little cloth as can be found. Runs on this thread in slices, one layout at a time.
 * @throws {SolverError} for settings and pieces that cannot be laid, such as one that is wider than the cloth; the
 *   signal's reason, when it fires
 */
export async function marker(
  results: readonly (SolveResult | MarkerGarment)[],
  settings: NodeMarkerSettings,
  hooks: MarkerPlanHooks = {},
): Promise<LayPlan> {
  const {markerWith} = await import('./marker.js');
  const means = {
    lay: (problem: MarkerProblem, all: MarkerHooks) => solver.marker(problem, all),
    solve: (problem: Problem, all: SolveHooks) => solve(problem, all),
  };
  return markerWith(means, results, settings, hooks);
}

/** Files of a lay plan: drawn small with its tables, at true scale for a plotter, and as DXF for cutters. */
export async function layPlanFiles(
  plan: LayPlan,
  settings: LayPlanSettings,
): Promise<LayPlanFiles> {
  const {layPlanFilesOf} = await import('./lay-plan.js');
  return layPlanFilesOf(plan, settings);
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

/**
 * A pattern of another program as a garment, by the bytes of its file: DXF (AAMA, ASTM or plain), or any garment's JSON.
 * @throws {FileError} or {SolverError} naming what is wrong and what to do
 */
export async function importGarment(
  bytes: Uint8Array,
  options: ImportOptions = {},
): Promise<ImportedGarment> {
  const {importWith} = await import('./import.js');
  return importWith(readGarment, bytes, options);
}

/**
 * What every edge of a garment that is not sewn may be sewn to, and which seams are as good as certain. Shapes decide, and
 * the seams that the garment has.
 * @throws {SolverError} for bad input
 */
export async function seamSuggestions(
  garment: Garment | string,
  settings: SuggestionSettings = {},
  name = plainNames.garment,
): Promise<SeamSuggestions> {
  const {suggestionsFor} = await import('../pairing/report.js');
  return suggestionsFor(await readGarment(garment, name), settings);
}

export interface ConvertOptions {
  /** What failures call the garment. */
  readonly name?: string;
  /** As a plain GarmentCode specification; see `convert`. */
  readonly plain?: boolean;
}

/**
 * A garment of any readable format as the text of a seamwise-garment/1 file. With `plain`, as a GarmentCode
 * specification for programs that know no more than that, in centimetres: each path is split into single cubics, and
 * both sides of its seam at the same shares of their lengths, so that every stitch joins one edge to one edge. What
 * that format has no place for is left out: cut-outs, grain lines, marks.
 * @param options or only the name
 * @throws {SolverError} for bad input
 */
export async function convert(
  garment: Garment | string,
  options: ConvertOptions | string = {},
): Promise<string> {
  const {name = plainNames.garment, plain = false} =
    typeof options === 'string' ? {name: options} : options;
  if (!plain) return solver.convert(garment, {name});
  const {plainGarment} = await import('../model/plain-garment.js');
  return plainGarment(await solver.garment(garment, {name}));
}

export interface GarmentDxfOptions {
  /** What failures call the garment, and what it is called where it gives no title. */
  readonly name?: string;
  /** Beyond edges whose garment states none. Default 0. [cm] */
  readonly allowanceCm?: number;
  /** The sewn line on layer 1 and the cut line on 14, as CLO expects them. Default false. */
  readonly sewAsBoundary?: boolean;
}

/**
 * The pieces of a garment as AAMA DXF (R12, millimetres, a block per piece): the cut line on layer 1, the line that is
 * sewn on 14 where it is another one, notches on 4, grain on 7, and so on, each within 0.02 mm of its curves.
 * @throws {SolverError} for bad input
 */
export async function garmentDxf(
  garment: Garment | string,
  {name = plainNames.garment, allowanceCm = 0, sewAsBoundary = false}: GarmentDxfOptions = {},
): Promise<string> {
  const document = await readGarment(garment, name);
  const [{draftedSheet}, {sheetDxf}] = await Promise.all([
    import('../cutting/drafted-sheet.js'),
    import('../cutting/out/sheet-dxf.js'),
  ]);
  return sheetDxf(draftedSheet(document, {allowanceCm, units: 'cm'}, name), {sewAsBoundary});
}

/**
 * Reads a print off a photograph or scan of its cloth: lattice, group, size, and a clean picture of its cell.
 * @throws {SolverError} where there is none to be found, with one sentence that says why; the signal's reason, when it fires
 */
export async function printFromPixels(
  pixels: PhotoPixels,
  settings: PrintFromPixelsSettings = {},
  hooks: PhotoHooks = {},
): Promise<PrintFromPixels> {
  hooks.signal?.throwIfAborted();
  const {printWith} = await import('./photo.js');
  return printWith(
    {
      photo: (request, its) => solver.photo(request, its),
      photoTile: (request, its) => solver.photoTile(request, its),
    },
    pixels,
    settings,
    hooks,
  );
}

/** Memory of the shared module: its size, and what is in use of it. [bytes] */
export async function memory(): Promise<{readonly heap: number; readonly live: number}> {
  return solver.ask('memory', {}, {});
}
