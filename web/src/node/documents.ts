/** Functions of `seamwise/node` that convert documents at once, with checks of their arguments. */
import * as glbFiles from '../files/glb/glb.js';
import * as plans from '../marker/plan.js';
import {
  bytes,
  checkArguments,
  either,
  having,
  optional,
  readable,
} from '../model/base/arguments.js';
import {SolverError} from '../model/base/failure.js';
import {number, text, type Read} from '../model/base/read.js';
import {checkedResult} from '../model/documents/checked-result.js';
import * as problems from '../model/documents/design-problem.js';
import * as drapes from '../model/documents/drape-file.js';
import * as results from '../model/documents/result-text.js';
import * as filed from '../model/documents/filed-design.js';
import * as designs from '../model/documents/stored-design.js';
import * as garments from '../model/garment/write-garment.js';
import type {Print} from '../model/print/repeating-print.js';
import * as prints from '../model/result/print-of-result.js';
import type {SolveResult} from '../model/result/result.js';
import * as searches from '../solver/search/asked-search.js';
import {drapeSettings, glbOptions, json, title} from './setting-checks.js';
import {drape, filedDesign, garmentDocument, layPlan, print} from './document-checks.js';

/**
 * The function with checks of its arguments, in their order and by their names. Every error is a
 * `SolverError`.
 */
const checked =
  <Args extends readonly unknown[], Answer>(
    work: (...args: Args) => Answer,
    call: string,
    checks: Readonly<Record<string, Read<unknown>>>,
  ): ((...args: Args) => Answer) =>
  (...args) => {
    const given = Object.entries(checks).map(([name, check], k) => [name, args[k], check] as const);
    checkArguments(call, ...given);
    try {
      return work(...args);
    } catch (cause) {
      if (cause instanceof SolverError) throw cause;
      // the arguments are the only input: a part that no check covers is wrong
      const message = `${call}: a part of its arguments is of a wrong type or cannot be read.`;
      throw new SolverError({code: 'options', message}, {cause});
    }
  };

const printChanges = having({
  ...{group: text(), size: having({width: number(0, 1e6), height: number(0, 1e6)})},
  ...{turnDeg: number(-360, 360)},
});

/**
 * Writes the text of a garment file.
 * @throws {SolverError} `options` for a value that is no document
 */
export const garmentFile = checked(garments.garmentFile, 'garmentFile', {
  document: garmentDocument,
});

/**
 * The print of a result, in the size and turn of the result, made from the print in those or in its
 * own. Undefined if it has another group or repeat.
 * @throws {SolverError} `options` for values that are no prints
 */
export function printOfResult<P extends Print>(of: SolveResult['print'], own: P): P | undefined {
  checkArguments('printOfResult', ['of', of, print], ['own', own, print]);
  return prints.printOfResult(of, own);
}

/**
 * The problem of one solve that gives this result, byte for byte: with the size, turn and seed that
 * were chosen for it.
 * @throws {SolverError} `options` for values that are no problem or no result
 */
export const chosenProblem = checked(searches.chosenProblem, 'chosenProblem', {
  problem: readable,
  result: having({print, metrics: having({})}),
});

/**
 * Problem of a design of files, the same wherever it is solved. The second argument holds the
 * contents of the two files.
 * @throws {FileError} naming the print's file; {SolverError} `options` for other values
 */
export const problemOfStored = checked(problems.problemOfStored, 'problemOfStored', {
  design: filedDesign,
  texts: having({garment: text(), print: text()}),
});

/**
 * The text of a result file without the parts that differ between places.
 * @throws {SolverError} `options` for a value that is no result
 */
export const resultText = checked(results.resultText, 'resultText', {result: checkedResult});

/**
 * Hash of text or bytes in lower-case hexadecimal digits.
 * @throws {SolverError} `options` for other values
 */
export const sha256Of = checked(results.sha256Of, 'sha256Of', {
  content: either('text or a Uint8Array', text(), bytes),
});

/** The text of a layout's file. @throws {SolverError} `options` for a value that is no layout */
export const layPlanText = checked(plans.layPlanText, 'layPlanText', {plan: layPlan});

/**
 * Converts a drape to a file. The last argument is the duration of draping; 0 by default, so that
 * equal drapes give equal files. [ms]
 * @throws {SolverError} `options` for values that are no result or no drape
 */
export const drapeFile = checked(drapes.drapeFile, 'drapeFile', {
  result: having({}),
  drape,
  settings: optional(drapeSettings),
  milliseconds: optional(number(0, 1e12)),
});

/** The text of a drape's file. @throws {SolverError} for a value that JSON cannot hold */
export const drapeText = checked(drapes.drapeText, 'drapeText', {file: json});

/**
 * Recognises the image of a cell by its first bytes; undefined unless PNG or JPEG, the only types
 * in glTF.
 * @throws {SolverError} `options` unless it is given bytes
 */
export const cellPicture = checked(glbFiles.cellPicture, 'cellPicture', {bytes});

/**
 * Writes a draped result as binary glTF.
 * @throws {SolverError} `options` if the drape does not belong to this result
 */
export const glb = checked(glbFiles.glb, 'glb', {
  result: checkedResult,
  drape,
  print,
  options: optional(glbOptions),
});

/** Reads a stored design, called by its name in messages. @throws {FileError} if it is damaged */
export const readStoredDesign = checked(designs.readStoredDesign, 'readStoredDesign', {
  content: text(),
  called: title,
});

/** The text of a design's file. @throws {SolverError} for a value that JSON cannot hold */
export const writeStoredDesign = checked(designs.writeStoredDesign, 'writeStoredDesign', {
  design: json,
});

/**
 * Builds the stored design of a solved one; the result must be that of `problemOfStored`.
 * @throws {SolverError} `options` for values that are no design or no result
 */
export const designOf = checked(designs.designOf, 'designOf', {
  design: filedDesign,
  result: checkedResult,
});

/**
 * Differences of a print from its file.
 * @throws {SolverError} `options` for values that are no print
 */
export const changesOf = checked(filed.changesOf, 'changesOf', {
  changes: printChanges,
  file: print,
});

/**
 * The print of a design, made from the content of its file and the changes.
 * @throws {FileError} naming the print's file; {SolverError} `options` for other values
 */
export const printOfStored = checked(filed.printOfStored, 'printOfStored', {
  design: having({print: having({url: text()})}),
  content: text(),
});

/**
 * The print of a design for the solver: the content of its file if nothing in it was changed.
 * @throws {FileError} naming the print's file; {SolverError} `options` for other values
 */
export const printTextOf = checked(filed.printTextOf, 'printTextOf', {
  design: having({print: having({url: text()})}),
  content: text(),
});
