/** Runs work in slices, so that other events get their turn, and frees its memory at the end. */
/** An object on a module's heap, which stays there until it is deleted. */
interface ModuleObject {
  delete(): void;
}

/**
 * Deletes an object of a module at the end of `work`, unless the module broke: then all of its
 * memory is freed.
 */
export async function owning<O extends ModuleObject, T>(
  object: O,
  work: (object: O) => T | Promise<T>,
): Promise<T> {
  let broken = false;
  try {
    return await work(object);
  } catch (error) {
    broken = error instanceof WebAssembly.RuntimeError;
    throw error;
  } finally {
    if (!broken) object.delete();
  }
}

/** Division of a thread's time between a solve and other work. */
export interface Pace {
  /** Duration of one slice of work. [ms] */
  readonly slice: number;
  /** Lets pending events run. */
  readonly pause: () => Promise<void>;
}

/**
 * Long enough for pauses not to matter. A MessageChannel would starve other events, both in a
 * worker and in Node.
 */
export const ownThread: Pace = {
  slice: 40,
  pause: () =>
    new Promise((resolve) => {
      if ('setImmediate' in globalThis) setImmediate(resolve);
      else setTimeout(resolve, 0);
    }),
};

/**
 * Half a frame, so that the page gets the other half. The pause uses a message, because setTimeout
 * would wait 4 ms or more, a second in a hidden page. A message also queues behind the page's
 * pending work.
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
 * Runs work in slices until it has ended; pending events run before each slice.
 * @param work works for about so many milliseconds; returns whether there is more to do
 * @throws errors of `work`; the signal's reason, an `AbortError` by default, before the next slice
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

/**
 * Takes steps for about this time.
 * @param step returns whether there is more to do
 * @returns the same
 */
export function stepsFor(milliseconds: number, step: () => boolean): boolean {
  const end = performance.now() + milliseconds;
  let more = true;
  while (more && performance.now() < end) more = step();
  return more;
}
