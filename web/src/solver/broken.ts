import {SolverError} from '../model/failure.js';

/** A failure of the solver's own, not of what it was given: what happened and why, as one sentence. */
export function internalError(what: string, cause: unknown): SolverError {
  const reason = (cause instanceof Error ? cause.message : String(cause))
    .replace(/^Aborted\((.*)\)\. Build with .*$/s, '$1') // Emscripten's advice is for its own users
    .replace(/\.$/, '');
  return new SolverError({code: 'internal', message: `${what}: ${reason}.`});
}
