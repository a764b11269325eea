/** An order: a stored design, solved again from the files that it names, and laid on the cloth that it is cut from. */
import {layPlan} from '../marker/plan.js';
import {markerOrder} from '../marker/problem.js';
import type {MarkerSettings} from '../marker/settings.js';
import {problemOfStored} from '../model/design-problem.js';
import {onPrint} from '../model/geometry.js';
import type {Print} from '../model/print.js';
import type {LayPlan} from '../model/lay-plan.js';
import type {SolveHooks} from '../model/problem.js';
import {checkScaled} from '../model/scaled.js';
import {resultText, sha256Of} from '../model/result-text.js';
import type {SolveResult} from '../model/result.js';
import {
  printOfStored,
  readStoredDesign,
  writeStoredDesign,
  type StoredDesign,
} from '../model/stored-design.js';
import type {StoredFile} from '../model/stored-file.js';
import {FileError} from '../model/versioned-file.js';
import {printDistance} from '../model/wallpaper.js';
import type {SolverService} from '../solver/service.js';
import {addressFrom, folderOf, readAddress, type ReadingLimits} from './addresses.js';
import {textOf} from './files.js';

export interface OrderHooks extends SolveHooks, ReadingLimits {
  /**
   * The bytes of a file, by its URL as the design gives it. Without it they are fetched, or read from disk, which
   * takes a `base`.
   */
  readonly read?: (url: string, signal?: AbortSignal) => Promise<Uint8Array>;
  /** URL or folder that relative URLs count from. */
  readonly base?: string | URL;
  /** Folders and hosts that files may come from, redirections included; the folder or host of `base` by default. */
  readonly within?: readonly URL[];
  /** What messages call the design. Default 'design'. */
  readonly name?: string;
  /** A bolt of the print to lay the answer on, too. */
  readonly cloth?: MarkerSettings;
}

export interface Order {
  readonly design: StoredDesign;
  /** The text of the garment's file. */
  readonly garment: string;
  /** In the colourway and the repeat of the design. */
  readonly print: Print;
  readonly result: SolveResult;
  /** What production takes: the result's text, which says so first where it is not the one that was sold. */
  readonly text: string;
  /** Whether the result is, byte for byte, the one that was sold. */
  readonly reproduced: boolean;
  /**
   * How far the print lies, at most, from where it was sold, over all pieces' outlines and modulo the print's
   * symmetries; null when the design's alignments are not those of the garment's pieces. [cm]
   */
  readonly differenceCm: number | null;
  /** How the answer lies on `cloth`, as `layPlan()` of the element tells it; absent where none was asked for. */
  readonly plan?: LayPlan;
}

type OrderSolver = Pick<SolverService, 'solve' | 'garment' | 'marker'>;

/** @throws as `order` does */
export async function orderWith(
  solver: OrderSolver,
  stored: StoredDesign | string,
  hooks: OrderHooks,
): Promise<Order> {
  const {name = 'design'} = hooks;
  const text = typeof stored === 'string' ? stored : writeStoredDesign(stored);
  const design = readStoredDesign(text, name);
  const read = hooks.read ?? readerFrom(hooks);
  const garment = await textAt(design.garment, name, read, hooks.signal);
  const printText = await textAt(design.print, name, read, hooks.signal);
  const print = printOfStored(design, printText);
  checkScaled({title: design.print.url, ...print});
  const result = await solver.solve(problemOfStored(design, {garment, print: printText}), {
    ...hooks,
    names: {garment: design.garment.url, print: design.print.url, symmetry: name, options: name},
  });
  const production = resultText(result);
  const reproduced = sha256Of(production) === design.result;
  return {
    ...{design, garment, print, result, reproduced},
    text: reproduced ? production : production.replace('{', '{"reproduced":false,'),
    differenceCm: greatestDifference(design, result),
    ...(hooks.cloth && {plan: await planOf(solver, {design, garment, print, result}, hooks)}),
  };
}

/** @throws {SolverError} for cloth on which the answer cannot lie */
async function planOf(
  solver: OrderSolver,
  {design, garment, print, result}: Pick<Order, 'design' | 'garment' | 'print' | 'result'>,
  {cloth = {widthCm: 0}, signal}: OrderHooks,
): Promise<LayPlan> {
  const ending = signal && {signal};
  const document = await solver.garment(garment, {name: design.garment.url, ...ending});
  const laid = {result, garment: document, options: design.options};
  const order = markerOrder([laid], cloth, print);
  return layPlan(order, await solver.marker(order.problem, ending));
}

function readerFrom({base, ...limits}: OrderHooks): NonNullable<OrderHooks['read']> {
  if (base === undefined) {
    throw new TypeError(
      "order() reads what the design names: give it 'read', a function that knows your files, or 'base', the folder or host they are on.",
    );
  }
  const folder = base instanceof URL ? base : folderOf(base);
  const {within = [new URL('.', folder)]} = limits;
  return (url) => readAddress(addressFrom(folder, url), {...limits, within});
}

/** @throws {FileError} when it is not the file that the design was made with */
async function textAt(
  {url, sha256}: StoredFile,
  design: string,
  read: NonNullable<OrderHooks['read']>,
  signal: AbortSignal | undefined,
): Promise<string> {
  const bytes = await read(url, signal);
  if (sha256Of(bytes) !== sha256) {
    throw new FileError(
      url,
      `is not the file that ${design} was made with, whose sha256 is ${sha256}; put the earlier file back, or make the design again.`,
    );
  }
  return textOf(bytes);
}

function greatestDifference({alignments}: StoredDesign, result: SolveResult): number | null {
  const sold = new Map(Object.entries(alignments));
  const apart = printDistance(result.print);
  let greatest = 0;
  for (const {name, alignment, rest, outline} of result.pieces) {
    const before = sold.get(name);
    if (!before) return null;
    for (const vertex of outline) {
      const point = rest[vertex];
      if (point)
        greatest = Math.max(greatest, apart(onPrint(alignment, point), onPrint(before, point)));
    }
  }
  return Math.round(greatest * 1e6) / 1e6; // below lies the rounding of the calculation
}
