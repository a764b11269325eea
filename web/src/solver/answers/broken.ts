import {SolverError} from '../../model/failure.js';
import {policyName} from '../../model/trusted.js';

/** A failure of the solver's own, not of what it was given: what happened and why, as one sentence. */
export function internalError(what: string, cause: unknown): SolverError {
  return new SolverError({code: 'internal', message: `${what}: ${reasonOf(cause)}.`});
}

/** The module broke, and cannot be used again: what it is said to its user. */
export function brokenModule(cause: WebAssembly.RuntimeError): SolverError {
  if (cause.message !== 'out of memory') return internalError('The solver broke', cause);
  const message = 'There is not enough memory for this problem.';
  return new SolverError({code: 'internal', message});
}

/**
 * A module could not be loaded; why, and what to do about it, as one sentence.
 * @param file its name
 */
export function loadingError(cause: unknown, file: string): SolverError {
  const reason = reasonOf(cause);
  if (/memory/i.test(reason)) return internalError('The solver could not be loaded', cause);
  const message = `The solver could not be loaded: ${reason}; ${remedyFor(reason, file)}.`;
  return new SolverError({code: 'no-wasm', message});
}

/** @param reason why the worker's `script` does not run, if anything is known */
export function workerBlocked(script: string | URL, reason = ''): SolverError {
  const because = reason === '' ? '' : ` (${reason})`;
  return new SolverError({
    code: 'worker-blocked',
    message:
      `The solver's worker could not be started from '${String(script)}'${because}; serve this script ` +
      "from the page's own origin and let the page's policy allow it: worker-src 'self'.",
  });
}

/** The page demands Trusted Types, and knows none of ours. */
export function workerNotTrusted(script: string | URL, reason: string): SolverError {
  return new SolverError({
    code: 'worker-blocked',
    message:
      `The solver's worker could not be started from '${String(script)}' (${reason}): the page's policy demands ` +
      `trusted types; let it allow ours: trusted-types ${policyName} lit-html.`,
  });
}

/** Without the full stop, to be part of a sentence. */
export function reasonOf(cause: unknown): string {
  return (cause instanceof Error ? cause.message : String(cause))
    .replace(/^Aborted\((.*)\)\. Build with .*$/s, '$1') // Emscripten's advice is for its own users
    .replace(/\.$/, '');
}

function remedyFor(reason: string, file: string): string {
  if (typeof WebAssembly === 'undefined') {
    return 'this browser runs no WebAssembly, so use a current one, or allow it in its settings';
  }
  // Chromium's and WebKit's words, then Firefox's
  if (/Content Security Policy|unsafe-eval|disallowed by embedder|blocked by CSP/i.test(reason)) {
    return "let the page's policy allow WebAssembly: script-src 'wasm-unsafe-eval'";
  }
  return `check the connection, and that ${file} is served where the page looks for it`;
}
