/**
 * Polling interval: browsers report `online` before any server can be reached, or not at all. [ms]
 */
const pause = 5000;

/** Calls `act` once when the network may be back, unless `signal` aborts first. */
export function onceOnline(act: () => void, signal: AbortSignal): void {
  const done = new AbortController();
  const end = AbortSignal.any([done.signal, signal]);
  const attempt = (): void => {
    done.abort();
    act();
  };
  addEventListener('online', attempt, {signal: end});
  const timer = setInterval(() => {
    if (navigator.onLine) attempt();
  }, pause);
  end.addEventListener('abort', () => {
    clearInterval(timer);
  });
}
