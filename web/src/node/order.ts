/** Orders: a stored design is solved again from its files, and laid out on its fabric. */
import {SolverError} from '../model/base/failure.js';
import type {MarkerSettings} from '../marker/settings.js';
import {problemOfStored} from '../model/documents/design-problem.js';
import {onPrint} from '../model/geometry/vectors.js';
import type {Print} from '../model/print/repeating-print.js';
import type {LayPlan} from '../model/result/marker-plan.js';
import type {SolveHooks} from '../model/design/solve-problem.js';
import {checkScaled} from '../model/result/unscaled-print.js';
import {resultText, sha256Of} from '../model/documents/result-text.js';
import type {SolveResult} from '../model/result/result.js';
import {printOfStored} from '../model/documents/filed-design.js';
import {
  readStoredDesign,
  writeStoredDesign,
  type StoredDesign,
} from '../model/documents/stored-design.js';
import type {StoredFile} from '../model/design/design.js';
import {FileError} from '../model/base/versioned-file.js';
import {printDistance} from '../model/print/wallpaper.js';
import type {SolverService} from '../solver/service.js';
import {addressFrom, folderOf, readAddress, type ReadingLimits} from './addresses.js';
import {textOf} from './files.js';
import {layWith} from './marker.js';

export interface OrderHooks extends SolveHooks, ReadingLimits {
  /**
   * Returns the bytes of a file, by its URL in the design. By default they are fetched or read from
   * disk, which requires a `base`.
   */
  readonly read?: (url: string, signal?: AbortSignal) => Promise<Uint8Array>;
  /** URL or folder that relative URLs refer to. */
  readonly base?: string | URL;
  /**
   * Folders and hosts of allowed files, also for redirections. Default: the folder or host of
   * `base`.
   */
  readonly within?: readonly URL[];
  /** Name of the design in messages. Default 'design'. */
  readonly name?: string;
  /** Fabric on which the result is laid out, too. */
  readonly cloth?: MarkerSettings;
}

export interface Order {
  readonly design: StoredDesign;
  /** The text of the garment file. */
  readonly garment: string;
  /** The print with the colourway and repeat of the design. */
  readonly print: Print;
  readonly result: SolveResult;
  /**
   * The result's text for production. It begins with a remark if it differs from the sold result.
   */
  readonly text: string;
  /** True if the result equals the sold one, byte for byte. */
  readonly reproduced: boolean;
  /**
   * Greatest displacement of the print from the sold result, over all pieces' outlines and modulo
   * the print's symmetries; null if the design's alignments are of other pieces. [cm]
   */
  readonly differenceCm: number | null;
  /** The layout on `cloth`, as from the element's `layPlan()`; absent without `cloth`. */
  readonly plan?: LayPlan;
}

type OrderSolver = Pick<SolverService, 'solve' | 'garment' | 'marker'>;

/**
 * Solves an order.
 * @throws {FileError} or {SolverError} under the conditions of `order`
 */
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

/** @throws {SolverError} if the result does not fit the fabric */
async function planOf(
  solver: OrderSolver,
  {design, garment, print, result}: Pick<Order, 'design' | 'garment' | 'print' | 'result'>,
  {cloth = {widthCm: 0}, signal}: OrderHooks,
): Promise<LayPlan> {
  const ending = signal && {signal};
  const document = await solver.garment(garment, {name: design.garment.url, ...ending});
  const laid = {result, garment: document, options: design.options};
  return layWith(solver.marker.bind(solver), [laid], {...cloth, print}, {...ending});
}

function readerFrom({base, ...limits}: OrderHooks): NonNullable<OrderHooks['read']> {
  if (base === undefined) {
    throw new SolverError({
      code: 'options',
      message:
        "order() reads what the design names: give it 'read', a function that knows your files, or 'base', the folder or host they are on.",
    });
  }
  const folder = base instanceof URL ? base : folderOf(base);
  const {within = [new URL('.', folder)]} = limits;
  return (url) => readAddress(addressFrom(folder, url), {...limits, within});
}

/**
 * The text of a stored file.
 * @throws {FileError} if the file differs from the design's
 */
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
  return Math.round(greatest * 1e6) / 1e6; // removes rounding errors
}
