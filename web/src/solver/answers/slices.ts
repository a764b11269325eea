/** How a solve shares its thread with everything else. */
export interface Pace {
  /** How long it works at a stretch. [ms] */
  readonly slice: number;
  /** Lets pending events run. */
  readonly pause: () => Promise<void>;
}

/** Long enough for pauses not to matter. A MessageChannel would starve other events, of a worker as of Node. */
export const ownThread: Pace = {
  slice: 40,
  pause: () =>
    new Promise((resolve) => {
      if ('setImmediate' in globalThis) setImmediate(resolve);
      else setTimeout(resolve, 0);
    }),
};

/**
 * Half a frame, to leave the other half to the page. A message, because setTimeout would wait 4 ms or
 * more, a second in a hidden page; and because it queues behind what the page has to do already.
 */
export const besideThePage: Pace = {
  slice: 8,
  pause: () =>
    new Promise((resolve) => {
      const {port1, port2} = new MessageChannel();
      port1.onmessage = () => {
        port1.close();
        resolve();
      };
      port2.postMessage(null);
    }),
};

/**
 * Has something work in slices until it has ended, letting everything else run before each of them.
 * @param work for about so many milliseconds; whether there is more to do
 * @throws what `work` throws; the signal's reason, an `AbortError` by default, before the next slice
 */
export async function runInSlices(
  work: (milliseconds: number) => boolean,
  pace: Pace,
  signal: AbortSignal | undefined,
): Promise<void> {
  do await breathe(pace, signal);
  while (work(pace.slice));
  await breathe(pace, signal);
}

/** Lets pending events run. @throws the signal's reason, if it has fired by then */
async function breathe(pace: Pace, signal: AbortSignal | undefined): Promise<void> {
  await pace.pause();
  signal?.throwIfAborted();
}

/** Takes steps for about so long. @param step whether there is more to do @returns the same */
export function stepsFor(milliseconds: number, step: () => boolean): boolean {
  const end = performance.now() + milliseconds;
  let more = true;
  while (more && performance.now() < end) more = step();
  return more;
}
