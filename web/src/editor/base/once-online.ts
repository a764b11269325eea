/** A browser may say that it is online before anything can be reached, or say nothing at all. [ms] */
const pause = 5000;

/** Calls back once, when the network may be back, unless `signal` fires before. */
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
