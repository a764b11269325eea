/** Loads the parts that the first result does not need; parts in the page are drawn once loaded. */

let loading: Promise<void> | undefined;

async function load(): Promise<void> {
  try {
    const {defineLaterParts} = await import('./later-parts.js');
    defineLaterParts();
  } catch {
    loading = undefined; // offline: the next call tries again
  }
}

/** Loads the later parts once; the next call repeats a failed load. */
export const loadLaterParts = (): Promise<void> => (loading ??= load());

/** Loads the drape. @throws {Error} if its module cannot be loaded */
export async function loadDrape(): Promise<void> {
  const {defineDrape} = await import('./drape/define-drape.js');
  defineDrape();
}

/** Loads the photo dialog. @throws {Error} if its module cannot be loaded */
export async function loadPhoto() {
  const {openPhoto} = await import('./photo/define-photo.js');
  return openPhoto;
}

/** Loads the fabric layout. @throws {Error} if its module cannot be loaded */
export async function loadMarker(): Promise<void> {
  const {defineMarker} = await import('./marker/define-marker.js');
  defineMarker();
}
