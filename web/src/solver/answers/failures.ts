/** Errors of the solver itself, and the end of a wait by a signal. */
import {SolverError} from '../../model/base/failure.js';
import {policyName} from '../../model/base/trusted.js';

/**
 * Waits for a promise until the signal fires; the promise's outcome is then ignored.
 * @throws the signal's reason, as soon as it fires
 */
export function unlessAborted<T>(promise: Promise<T>, signal: AbortSignal | undefined): Promise<T> {
  if (!signal) return promise;
  return new Promise((resolve, reject) => {
    const abort = () => {
      // eslint-disable-next-line @typescript-eslint/prefer-promise-reject-errors -- the caller's own
      reject(signal.reason);
    };
    if (signal.aborted) abort();
    else signal.addEventListener('abort', abort, {once: true});
    const stopListening = () => {
      signal.removeEventListener('abort', abort);
    };
    promise.then(resolve, reject).finally(stopListening);
  });
}

/** A failure of the solver itself, not of its input: event and reason in one sentence. */
export function internalError(what: string, cause: unknown): SolverError {
  return new SolverError({code: 'internal', message: `${what}: ${reasonOf(cause)}.`});
}

/** Error for a broken module, which cannot be used again. */
export function brokenModule(cause: WebAssembly.RuntimeError): SolverError {
  if (cause.message !== 'out of memory') return internalError('The solver broke', cause);
  const message = 'There is not enough memory for this problem.';
  return new SolverError({code: 'internal', message});
}

/**
 * Error for a module that could not be loaded: reason and remedy in one sentence.
 * @param file name of the module's file
 */
export function loadingError(cause: unknown, file: string): SolverError {
  const reason = reasonOf(cause);
  if (/memory/i.test(reason)) return internalError('The solver could not be loaded', cause);
  const message = `The solver could not be loaded: ${reason}; ${remedyFor(reason, file)}.`;
  return new SolverError({code: 'no-wasm', message});
}

/**
 * Error for a worker that cannot be started.
 * @param reason reason why the worker's `script` does not run, if known
 */
export function workerBlocked(script: string | URL, reason = ''): SolverError {
  const because = reason === '' ? '' : ` (${reason})`;
  return new SolverError({
    code: 'worker-blocked',
    message:
      `The solver's worker could not be started from '${String(script)}'${because}; serve this script ` +
      "from the page's own origin and let the page's policy allow it: worker-src 'self'.",
  });
}

/** Error for a page that requires Trusted Types and does not allow this package's policy. */
export function workerNotTrusted(script: string | URL, reason: string): SolverError {
  return new SolverError({
    code: 'worker-blocked',
    message:
      `The solver's worker could not be started from '${String(script)}' (${reason}): the page's policy demands ` +
      `trusted types; let it allow ours: trusted-types ${policyName} lit-html.`,
  });
}

/** Reason of an error without the full stop, as part of a sentence. */
export function reasonOf(cause: unknown): string {
  return (cause instanceof Error ? cause.message : String(cause))
    .replace(/^Aborted\((.*)\)\. Build with .*$/s, '$1') // Emscripten's advice is for its own users
    .replace(/\.$/, '');
}

function remedyFor(reason: string, file: string): string {
  if (typeof WebAssembly === 'undefined') {
    return 'this browser runs no WebAssembly, so use a current one, or allow it in its settings';
  }
  // messages of Chromium and WebKit, then of Firefox
  if (/Content Security Policy|unsafe-eval|disallowed by embedder|blocked by CSP/i.test(reason)) {
    return "let the page's policy allow WebAssembly: script-src 'wasm-unsafe-eval'";
  }
  return `check the connection, and that ${file} is served where the page looks for it`;
}
