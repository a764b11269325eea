/** Waits for times in which background work does not disturb the user. */

/** Long enough for a user who reads the result and acts on it. [ms] */
const pause = 1500;

/** A page that is busy for longer than this counts as idle. [ms] */
const patience = 2000;

const inputs = ['keydown', 'pointerdown', 'pointermove', 'wheel', 'input'];

/**
 * Waits until the user has paused for a while, counted from the call, and the page is idle.
 * @param signal ends the wait early, so that waits of superseded work do not add up
 */
export async function paused(signal: AbortSignal): Promise<void> {
  if (typeof document !== 'undefined') await noInput(pause, signal);
  await idle();
}

/** Waits until the page is idle. */
export const idle = (): Promise<void> =>
  new Promise((resolve) => {
    const done = (): void => {
      resolve();
    };
    // Safari lacks requestIdleCallback
    if (typeof requestIdleCallback === 'function') requestIdleCallback(done, {timeout: patience});
    else setTimeout(done, 100);
  });

function noInput(time: number, signal: AbortSignal): Promise<void> {
  return new Promise((resolve) => {
    const listening = new AbortController();
    const end = (): void => {
      clearTimeout(timer);
      listening.abort();
      resolve();
    };
    let timer = setTimeout(end, time);
    signal.addEventListener('abort', end, {signal: listening.signal});
    const restart = (): void => {
      clearTimeout(timer);
      timer = setTimeout(end, time);
    };
    for (const kind of inputs) {
      addEventListener(kind, restart, {capture: true, passive: true, signal: listening.signal});
    }
  });
}
