import {bytes as bytesCheck, checkArguments, readable} from '../model/base/arguments.js';
import {text} from '../model/base/read.js';
import {checkedResult} from '../model/documents/checked-result.js';
import type {PrintSizes} from '../model/design/options.js';
import type {MarkerGarment} from '../model/design/marker-garment.js';
import type {Drape, DrapeSettings} from '../model/result/draped-garment.js';
import type {Garment} from '../model/garment/specification.js';
import type {GarmentDocument} from '../model/garment/garment-document.js';
import type {LayPlan} from '../model/result/marker-plan.js';
import type {MarkerHooks, MarkerProblem} from '../model/result/marker-search.js';
import type {PhotoHooks, PhotoPixels} from '../model/print/photo-reading.js';
import type {Problem, SolveHooks} from '../model/design/solve-problem.js';
import type {MeshedPattern, Proof, SolveResult} from '../model/result/result.js';
import type {StoredDesign} from '../model/documents/stored-design.js';
import type {DetectedSymmetries, MeasuredSymmetry, Symmetry} from '../model/garment/symmetries.js';
import type {SeamSuggestions, SuggestionSettings} from '../pairing/report.js';
import type {PrintWithTile} from '../picture/fabric.js';
import type {Remedy} from '../remedies/remedy.js';
import {
  plainNames,
  type NamedDrapeHooks,
  type NamedPrepareHooks,
  type NamedProofHooks,
  type NamedSolveHooks,
} from '../solver/requests/requests.js';
import {pixels as pixelsCheck} from '../solver/requests/later-checks.js';
import {chosenProblem} from '../solver/search/asked-search.js';
import * as checks from './argument-checks.js';
import type {CommonSizeHooks} from './common-size.js';
import type {Cut, CutSettings} from './cut.js';
import {layPlan as planCheck, print as printCheck} from './document-checks.js';
import type {ImportedGarment, ImportOptions} from './import.js';
import type {MarkerPlanHooks, NodeMarkerSettings} from './marker.js';
import type {LayPlanFiles, LayPlanSettings} from './lay-plan.js';
import type {ConvertOptions, GarmentDxfOptions, RemedyHooks} from './options.js';
import type {Order, OrderHooks} from './order.js';
import type {OrderRecord, OrderRecordSettings} from './order-record.js';
import {drapeSettings, json} from './setting-checks.js';
import type {PrintFromPixels, PrintFromPixelsSettings} from './photo.js';
import type {RepeatForPrinting} from './repeat.js';
import {ThreadSolver} from './thread-solver.js';

export * from './exports.js';
export type * from './options.js';

const solver = new ThreadSolver();

/**
 * Aligns a print with a sewing pattern, and deforms the pattern so that the print matches at its
 * seams. Runs on this thread in slices of about 40 ms, two solves at a time, in the order of the
 * calls. On the main thread, additional threads help with long steps, which does not change the
 * result.
 * @throws {SolverError} for invalid input; the signal's reason, an `AbortError` by default, when it
 *   aborts
 */
export async function solve(problem: Problem, hooks: NamedSolveHooks = {}): Promise<SolveResult> {
  checkArguments('solve', ['hooks', hooks, checks.solveHooks]);
  return solver.solve(problem, hooks);
}

/**
 * The size of the print in which most visible seams of several garments match, for garments that are
 * cut from one fabric. Use it as `printSize` of each problem.
 * @param sizes as in the option `printSize`; the print's own size is always compared
 * @throws {SolverError} for invalid input; the signal's reason when it aborts
 */
export async function commonPrintSize(
  problems: readonly Problem[],
  sizes: PrintSizes,
  hooks: CommonSizeHooks = {},
): Promise<number> {
  checkArguments(
    'commonPrintSize',
    ['hooks', hooks, checks.commonSizeHooks],
    ['problems', problems, checks.solvedProblems],
    ['sizes', sizes, readable],
  );
  const {commonSizeOf} = await import('./common-size.js');
  return commonSizeOf(problems, sizes, (problem, its) => solve(problem, its), hooks);
}

/**
 * Changes that reduce the mismatch at seams of a result, the most likely first. Each is tested by
 * another solve, and kept only if it clearly helps. At most four are tried; none if all seams match
 * within 3 mm, or for other methods than `best`.
 * @param problem the problem of the result
 * @throws the signal's reason, an `AbortError` by default, when it aborts
 */
export async function remedies(
  problem: Problem,
  result: SolveResult,
  hooks: RemedyHooks = {},
): Promise<readonly Remedy[]> {
  checkArguments(
    'remedies',
    ['problem', problem, checks.solvedProblem],
    ['hooks', hooks, checks.remedyHooks],
    ['result', result, checkedResult],
  );
  const {signal, names, onRemedy} = hooks;
  const {remediesOf} = await import('../remedies/remedies.js');
  return remediesOf(
    chosenProblem(problem, result),
    result,
    (changed, stop) => solve(changed, {...(stop && {signal: stop}), ...(names && {names})}),
    {signal, ...(onRemedy && {onRemedy})},
  );
}

/**
 * Solves each visible seam that is off by itself, at most four. What is off even then gets the state
 * `cannot` and the reason `reach`.
 * @param problem the problem of the result
 * @returns the result with these states; it is not what a stored design is compared with
 * @throws the signal's reason, an `AbortError` by default, when it aborts
 */
export async function withReach(
  problem: Problem,
  result: SolveResult,
  hooks: NamedPrepareHooks = {},
): Promise<SolveResult> {
  checkArguments(
    'withReach',
    ['problem', problem, checks.solvedProblem],
    ['hooks', hooks, checks.prepareHooks],
    ['result', result, checkedResult],
  );
  const {signal, names} = hooks;
  const {withReach: tried} = await import('../remedies/reach.js');
  return tried(
    chosenProblem(problem, result),
    result,
    (changed, stop) => solve(changed, {...(stop && {signal: stop}), ...(names && {names})}),
    {signal},
  );
}

/**
 * Solves a stored design again from its original files, and lays it out on `cloth` if given.
 * @param design an object, or its JSON text
 * @throws {FileError} if the design is damaged, or if a file cannot be read or has changed;
 *   {SolverError} for an invalid garment or print; the signal's reason when it aborts
 */
export async function order(design: StoredDesign | string, hooks: OrderHooks = {}): Promise<Order> {
  const asked = typeof design === 'string' ? text() : json;
  checkArguments('order', ['hooks', hooks, checks.orderHooks], ['design', design, asked]);
  const {orderWith} = await import('./order.js');
  return orderWith(solver, design, hooks);
}

/**
 * The record of a solved order for the cart and the workshop, as an object for JSON: how many visible
 * seams match, the length of fabric, and the pieces in their print as SVG text.
 * @throws {SolverError} if the order is not one of `order`
 */
export async function orderRecord(
  solved: Order,
  settings: OrderRecordSettings = {},
): Promise<OrderRecord> {
  checkArguments(
    'orderRecord',
    ['solved', solved, checks.solvedOrder],
    ['settings', settings, checks.orderRecordSettings],
  );
  const {recordOf} = await import('./order-record.js');
  return recordOf(solver, solved, settings);
}

/**
 * Drapes a solved garment on a form. `drapeFile` converts the drape to a file, `glb` to a 3D model
 * for other programs. Runs on this thread in slices, one drape at a time.
 * @throws {SolverError} for invalid input, such as a garment without placements; the signal's
 *   reason when it aborts
 */
export async function drape(
  result: SolveResult | string,
  settings: DrapeSettings = {},
  hooks: NamedDrapeHooks = {},
): Promise<Drape> {
  checkArguments(
    'drape',
    ['hooks', hooks, checks.drapeHooks],
    ['settings', settings, drapeSettings],
  );
  return solver.drape(result, settings, hooks);
}

/**
 * Lays the pieces of a result out on a cutting sheet at true scale, and divides it among pages. PDF
 * and SVG files are written on demand.
 * @throws {SolverError} `options` for invalid settings, such as an unknown paper
 */
export async function cut(result: SolveResult, settings: CutSettings): Promise<Cut> {
  checkArguments(
    'cut',
    ['result', result, checkedResult],
    ['settings', settings, checks.cutSettings],
  );
  const {cutWith} = await import('./cut.js');
  return cutWith(result, settings);
}

/**
 * Lays the pieces of one or several results out on their printed fabric, in register with the
 * print, on the shortest length that is found. Runs on this thread in slices, one layout at a time.
 * @throws {SolverError} for settings and pieces that cannot be laid, such as a piece wider than the
 *   fabric; the signal's reason when it aborts
 */
export async function marker(
  results: readonly (SolveResult | MarkerGarment)[],
  settings: NodeMarkerSettings,
  hooks: MarkerPlanHooks = {},
): Promise<LayPlan> {
  checkArguments('marker', ['hooks', hooks, checks.markerHooks]);
  hooks.signal?.throwIfAborted();
  checkArguments(
    'marker',
    ['results', results, checks.laidGarments],
    ['settings', settings, checks.nodeMarkerSettings],
  );
  const {markerWith} = await import('./marker.js');
  const means = {
    lay: (problem: MarkerProblem, all: MarkerHooks) => solver.marker(problem, all),
    solve: (problem: Problem, all: SolveHooks) => solve(problem, all),
  };
  return markerWith(means, results, settings, hooks);
}

/**
 * Files of a layout: a reduced drawing with tables, a drawing at true scale for a plotter, and DXF
 * for cutters.
 */
export async function layPlanFiles(
  plan: LayPlan,
  settings: LayPlanSettings,
): Promise<LayPlanFiles> {
  checkArguments(
    'layPlanFiles',
    ['plan', plan, planCheck],
    ['settings', settings, checks.layPlanSettings],
  );
  const {layPlanFilesOf} = await import('./lay-plan.js');
  return layPlanFilesOf(plan, settings);
}

/** Detects the symmetries of a garment, which `symmetry: 'auto'` imposes if the group permits. */
export async function symmetries(
  garment: Garment | string,
  name = plainNames.garment,
): Promise<DetectedSymmetries> {
  checkArguments('symmetries', ['name', name, text()]);
  return solver.symmetries(garment, {name});
}

/**
 * The garment at the start of a solve: checked, meshed, and with its symmetries.
 * @throws {SolverError} under the conditions of `solve`
 */
export async function prepare(
  problem: Problem,
  hooks: NamedPrepareHooks = {},
): Promise<MeshedPattern> {
  checkArguments('prepare', ['hooks', hooks, checks.prepareHooks]);
  return solver.prepare(problem, hooks);
}

/**
 * Proves a bound for alignments of the drafted pieces. It continues until no better bound can be
 * proven, which may take minutes, or until the signal aborts. It pauses during solves.
 * @throws {SolverError} under the conditions of `solve`
 */
export async function prove(problem: Problem, hooks: NamedProofHooks = {}): Promise<Proof> {
  checkArguments('prove', ['hooks', hooks, checks.proofHooks]);
  return solver.prove(problem, hooks);
}

/**
 * Measures one symmetry on a garment, whether or not the garment has it.
 * @throws {SolverError} for invalid input, such as an unknown piece
 */
export async function mirror(
  garment: Garment | string,
  symmetry: Symmetry,
  name = plainNames.garment,
): Promise<MeasuredSymmetry> {
  checkArguments('mirror', ['name', name, text()]);
  return solver.mirror(garment, symmetry, {name});
}

/**
 * Reads a garment of any supported format as one document: pieces face up in centimetres, seams,
 * matches, symmetries, and open questions of its file. `garmentFile` writes such a document.
 * @throws {SolverError} for invalid input
 */
export async function readGarment(
  garment: Garment | string,
  name = plainNames.garment,
): Promise<GarmentDocument> {
  checkArguments('readGarment', ['name', name, text()]);
  return solver.garment(garment, {name});
}

/**
 * Imports the bytes of a pattern file of another program as a garment: DXF (AAMA, ASTM or plain),
 * or any garment's JSON.
 * @throws {FileError} or {SolverError} with the error and a remedy
 */
export async function importGarment(
  bytes: Uint8Array,
  options: ImportOptions = {},
): Promise<ImportedGarment> {
  checkArguments(
    'importGarment',
    ['bytes', bytes, bytesCheck],
    ['options', options, checks.importOptions],
  );
  const {importWith} = await import('./import.js');
  return importWith(readGarment, bytes, options);
}

/**
 * Suggests partners for every unsewn edge of a garment, and the nearly certain seams, from the
 * shapes of the edges and the existing seams.
 * @throws {SolverError} for invalid input
 */
export async function seamSuggestions(
  garment: Garment | string,
  settings: SuggestionSettings = {},
  name = plainNames.garment,
): Promise<SeamSuggestions> {
  checkArguments(
    'seamSuggestions',
    ['settings', settings, checks.suggestionSettings],
    ['name', name, text()],
  );
  const {suggestionsFor} = await import('../pairing/report.js');
  return suggestionsFor(await readGarment(garment, name), settings);
}

/**
 * Converts a garment of any supported format to the text of a seamwise-garment/1 file. With
 * `plain`, writes a basic GarmentCode specification in centimetres. Each path is then split into
 * single cubics, and both sides of its seam at the same shares of their lengths, so that every
 * stitch joins one edge to one edge. Cut-outs, grain lines and marks are omitted, since that format
 * has none.
 * @param options options, or only the name
 * @throws {SolverError} for invalid input
 */
export async function convert(
  garment: Garment | string,
  options: ConvertOptions | string = {},
): Promise<string> {
  checkArguments('convert', ['options', options, checks.convertOptions]);
  const {
    name = plainNames.garment,
    plain = false,
    dividePleats = false,
  } = typeof options === 'string' ? {name: options} : options;
  if (!plain && !dividePleats) return solver.convert(garment, {name});
  const [{plainGarment}, {divideAtFolds}, {garmentFile}] = await Promise.all([
    import('../model/garment/plain-garment.js'),
    import('../model/garment/pleated-edges.js'),
    import('../model/garment/write-garment.js'),
  ]);
  const read = await solver.garment(garment, {name});
  const document = dividePleats ? divideAtFolds(read).document : read;
  return plain ? plainGarment(document) : garmentFile(document);
}

/**
 * Writes the pieces of a garment as AAMA or ASTM DXF (R12, one block per piece): the cut line
 * on layer 1, a different sewn line on 14, notches on 4, grain on 7, and so on, each within 0.02 mm
 * of its curves.
 * @throws {SolverError} for invalid input
 */
export async function garmentDxf(
  garment: Garment | string,
  options: GarmentDxfOptions = {},
): Promise<string> {
  checkArguments('garmentDxf', ['options', options, checks.garmentDxfOptions]);
  const {name = plainNames.garment, allowanceCm = 0, ...format} = options;
  const document = await readGarment(garment, name);
  const [{draftedSheet}, {sheetDxf}] = await Promise.all([
    import('../cutting/drafted-sheet.js'),
    import('../cutting/out/sheet-dxf.js'),
  ]);
  return sheetDxf(draftedSheet(document, {allowanceCm, units: 'cm'}, name), format);
}

/**
 * Reads a print from a photo or scan of its fabric: lattice, group, size, and a clean image of its
 * cell.
 * @throws {SolverError} without a recognisable print, with the reason in one sentence; the signal's
 *   reason when it aborts
 */
export async function printFromPixels(
  pixels: PhotoPixels,
  settings: PrintFromPixelsSettings = {},
  hooks: PhotoHooks = {},
): Promise<PrintFromPixels> {
  checkArguments('printFromPixels', ['hooks', hooks, checks.photoHooks]);
  hooks.signal?.throwIfAborted();
  checkArguments(
    'printFromPixels',
    ['pixels', pixels, pixelsCheck],
    ['settings', settings, checks.photoSettings],
  );
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

/**
 * The rectangular repeat of a print in its true size, for print shops.
 * @throws {SolverError} `unscaled` for a print of unknown size
 */
export async function printRepeat(print: PrintWithTile): Promise<RepeatForPrinting> {
  checkArguments('printRepeat', ['print', print, printCheck]);
  return (await import('./repeat.js')).printRepeat(print);
}

/** Memory of the shared module: its size and the part in use. [bytes] */
export async function memory(): Promise<{readonly heap: number; readonly live: number}> {
  return solver.ask('memory', {}, {});
}
