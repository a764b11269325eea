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

/** Loads what shows the garment as it is worn. @throws {Error} where it cannot be had */
export async function loadWorn(): Promise<void> {
  const {defineWorn} = await import('./worn/define-worn.js');
  defineWorn();
}

/** Loads what makes prints of photographs. @throws {Error} where it cannot be had */
export async function loadPhoto() {
  const {openPhoto} = await import('./photo/define-photo.js');
  return openPhoto;
}

/** Loads what shows the pieces on their cloth. @throws {Error} where it cannot be had */
export async function loadCloth(): Promise<void> {
  const {defineCloth} = await import('./cloth/define-cloth.js');
  defineCloth();
}
