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
