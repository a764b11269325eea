import {SolverError} from '../../model/failure.js';
import {FileError} from '../../model/versioned-file.js';
import {toFailure} from '../../workbench/latest-solve.js';

/** As the one kind of error that the element knows. */
export function asError(error: unknown): SolverError {
  if (error instanceof SolverError) return error;
  if (error instanceof FileError) return new SolverError({code: 'options', message: error.message});
  return new SolverError(toFailure(error));
}
