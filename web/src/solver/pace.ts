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
