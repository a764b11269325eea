/** How a solve shares its thread with everything else. */
export interface Pace {
  /** How long it works at a stretch. [ms] */
  readonly slice: number;
  /** Lets pending events run. */
  readonly pause: () => Promise<void>;
}

/**
 * Lets everything run that waits already. Not setTimeout: in a browser it would wait 4 ms or more, a second in a hidden
 * page. A message queues behind what is there, but would starve other events in Node, which has something better.
 */
const afterAllElse = (): Promise<void> =>
  new Promise((resolve) => {
    if ('setImmediate' in globalThis) {
      setImmediate(resolve);
      return;
    }
    const {port1, port2} = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });

/** Long enough for pauses not to matter. */
export const ownThread: Pace = {slice: 40, pause: afterAllElse};

/** Half a frame, to leave the other half to the page. */
export const besideThePage: Pace = {slice: 8, pause: afterAllElse};
