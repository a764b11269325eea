import {SolverError} from '../../model/result/failure.js';
import {FileError} from '../../model/base/versioned-file.js';
import {toFailure} from '../../workbench/latest-solve.js';

/** Converts any error to the element's only kind of error. */
export function asError(error: unknown): SolverError {
  if (error instanceof SolverError) return error;
  if (error instanceof FileError) return new SolverError({code: 'options', message: error.message});
  return new SolverError(toFailure(error));
}
