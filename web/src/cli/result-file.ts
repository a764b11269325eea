/** Reads and checks result files, which may have been changed by others. */
import type {GrainRule} from '../model/garment/grain.js';
import {problemFor} from '../model/documents/design-problem.js';
import {decisionFields, decisions} from '../model/design/read-design.js';
import type {GarmentDocument} from '../model/garment/garment-document.js';
import type {SolveOptions} from '../model/design/options.js';
import {type Print} from '../model/print/repeating-print.js';
import {readPrintFile} from '../model/print/read-print-file.js';
import {fieldOf, isTooDeep, Malformed} from '../model/base/read.js';
import {checkedResult} from '../model/documents/checked-result.js';
import type {Problem} from '../model/design/solve-problem.js';
import {fabricConflict, printOfResult} from '../model/result/print-of-result.js';
import type {SolveResult} from '../model/result/result.js';
import {readBytes, readText, resultLimit, textOf} from '../node/files.js';
import {readGarment} from '../node/index.js';
import {UsageError} from './base/arguments.js';
import {inColourway, readPrint} from './base/print-files.js';

export type ResultFile = SolveResult & {
  /** Written by `order`: false if the result differs from the sold one. */
  readonly reproduced?: boolean;
  /** The solved design; unverified. */
  readonly design?: unknown;
};

const damaged = (path: string, what: string): UsageError =>
  new UsageError(
    `${path} is not a whole result file (seamwise-result/1)${what}; align the garment again with --out.`,
  );

/**
 * Checks a parsed result file.
 * @throws {UsageError} with the file and the invalid field
 */
export function asResult(value: unknown, path: string): ResultFile {
  const complain = (what: string): UsageError => damaged(path, what);
  if (fieldOf(value, 'format') !== 'seamwise-result/1' || isTooDeep(value)) throw complain('');
  try {
    return checkedResult(value, '');
  } catch (error) {
    if (error instanceof Malformed) throw complain(`: ${error.message}`);
    throw error;
  }
}

/**
 * The options of the result's design.
 * @throws {UsageError} with the file
 */
export function optionsIn({design}: ResultFile, path: string): SolveOptions {
  const options = fieldOf(design, 'options');
  try {
    return options === undefined ? {} : decisionFields.options(options, 'design.options');
  } catch (error) {
    if (error instanceof Malformed) throw damaged(path, `: ${error.message}`);
    throw error;
  }
}

/**
 * The solved problem on its print; undefined if the result has no design.
 * @throws {UsageError} with the file
 */
export function problemIn(
  {design}: ResultFile,
  path: string,
  {group, w1, w2, oneWay = false}: Print,
): Problem | undefined {
  const garment = fieldOf(fieldOf(design, 'garment'), 'text');
  if (typeof garment !== 'string') return undefined;
  try {
    return problemFor(decisions(design, 'design'), garment, {group, w1, w2, oneWay});
  } catch (error) {
    if (error instanceof Malformed) throw damaged(path, `: ${error.message}`);
    throw error;
  }
}

/**
 * The garment from a file, if given, otherwise from the result's design.
 * @throws {UsageError}, {FileError} or {SolverError} if it is invalid
 */
export async function garmentOf(
  {design}: ResultFile,
  file: string | undefined,
): Promise<{readonly garment: GarmentDocument; readonly garmentFile: string} | undefined> {
  const held = fieldOf(design, 'garment');
  const [heldText, heldName] = ['text', 'name'].map((key) => fieldOf(held, key));
  const text = file === undefined ? heldText : await readText(file);
  const garmentFile = file ?? heldName;
  if (typeof text !== 'string') return undefined;
  const called = typeof garmentFile === 'string' ? garmentFile : 'the garment';
  return {garment: await readGarment(text, called), garmentFile: called};
}

/** Pieces of plain fabric, from the result's design. */
export function plainIn({design}: ResultFile): readonly string[] {
  const plain = fieldOf(fieldOf(design, 'options'), 'plain');
  return Array.isArray(plain) ? plain.filter((name) => typeof name === 'string') : [];
}

/** Chosen grain lines of pieces, from the result's design. */
export function grainIn({design}: ResultFile): Readonly<Record<string, GrainRule>> {
  const pieces = fieldOf(fieldOf(fieldOf(design, 'options'), 'grain'), 'pieces');
  const rules = typeof pieces === 'object' && pieces !== null ? Object.entries(pieces) : [];
  return Object.fromEntries(
    rules.flatMap(([name, rule]): [string, GrainRule][] => {
      const angleDeg = fieldOf(rule, 'angleDeg');
      return typeof angleDeg === 'number' && Number.isFinite(angleDeg) ? [[name, {angleDeg}]] : [];
    }),
  );
}

/**
 * The result and its bytes.
 * @throws {UsageError} or {FileError} with the file
 */
export async function readResult(
  path: string,
): Promise<{readonly bytes: Uint8Array; readonly result: ResultFile}> {
  const bytes = await readBytes(path, resultLimit);
  return {bytes, result: asResult(parsed(textOf(bytes), path), path)};
}

/**
 * Parses JSON.
 * @throws {UsageError} with the file
 */
export function parsed(text: string, path: string): unknown {
  if (text.trim() === '') throw new UsageError(`${path} is empty; choose another file.`);
  try {
    return JSON.parse(text) as unknown;
  } catch {
    throw new UsageError(`${path} is not complete JSON; write it again.`);
  }
}

/**
 * The print of a result in its size and in one of its colourways.
 * @throws {UsageError} if it is another print
 * @throws {FileError} if it cannot be read
 */
export async function readFabricOf(
  result: SolveResult,
  resultFile: string,
  {printFile, colourway}: {readonly printFile: string; readonly colourway: string | undefined},
): Promise<Print> {
  const own = readPrintFile(textOf(await readPrint(printFile)), printFile);
  const fabric = colourway === undefined ? own : inColourway(own, colourway, printFile);
  const inSize = printOfResult(result.print, fabric);
  if (inSize) return inSize;
  const conflict = fabricConflict(result.print, fabric);
  if (conflict !== undefined) throw new UsageError(`${resultFile}: ${conflict}`);
  throw new UsageError(
    `${resultFile} was solved for another group or repeat than ${printFile}'s; name the print it was solved with.`,
  );
}
