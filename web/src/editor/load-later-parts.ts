/** Loads what the first answer does not wait for. A part that is shown before is drawn once it is there. */

let loading: Promise<void> | undefined;

async function load(): Promise<void> {
  try {
    const {defineLaterParts} = await import('./later-parts.js');
    defineLaterParts();
  } catch {
    loading = undefined; // without network: to be tried again
  }
}

/** Once; what fails is tried again by the next call. */
export const loadLaterParts = (): Promise<void> => (loading ??= load());
