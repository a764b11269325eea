/** Stores the design of an element with its answer. */
import type {Design} from '../../model/design/design.js';
import {filedDesign} from '../../model/documents/design-problem.js';
import {SolverError} from '../../model/result/failure.js';
import type {SolveResult} from '../../model/result/result.js';
import {designOf, type StoredDesign} from '../../model/documents/stored-design.js';
import type {FileWords} from './files.js';

/**
 * @throws {SolverError} if the garment or the print has no URL to store; the message is one
 * sentence
 */
export function storedDesign(design: Design, result: SolveResult, words: FileWords): StoredDesign {
  const missing = !design.garment.file
    ? words.garment
    : !design.print.file?.place
      ? words.print
      : undefined;
  if (missing !== undefined) {
    throw new SolverError({code: 'options', message: words.notStorable(missing)});
  }
  return designOf(filedDesign(design), result);
}
