/** When nobody minds. */

/** However busy a page is, after this it is idle enough. [ms] */
const patience = 2000;

export const idle = (): Promise<void> =>
  new Promise((resolve) => {
    const done = (): void => {
      resolve();
    };
    // Safari has none
    if (typeof requestIdleCallback === 'function') requestIdleCallback(done, {timeout: patience});
    else setTimeout(done, 100);
  });
