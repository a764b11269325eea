import {failureCode, SolverError} from '../../model/result/failure.js';
import {symmetryReasons} from '../../model/result/notes.js';
import {photoFaults} from '../../model/print/photo-reading.js';
import {documentValue} from '../json/document.js';
import type {ModuleFailure} from '../module/module.js';
import type {ModuleDocument} from '../module/seamwise.mjs';

/** Value of a document from the module. @throws {SolverError} if there is none */
export function valueOf({document, failure}: ModuleDocument): unknown {
  if (failure) throw toError(failure);
  return documentValue(document);
}

export function toError({code, message, piece, seam, reason}: ModuleFailure): SolverError {
  const why = [...symmetryReasons, ...photoFaults].find((known) => known === reason);
  return new SolverError({
    code: failureCode(code),
    message,
    piece: piece < 0 ? null : piece,
    seam: seam < 0 ? null : seam,
    ...(why && {reason: why}),
  });
}
