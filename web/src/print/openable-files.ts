/** Files that can be opened as prints. */

/** Endings of image files. */
export const pictureEndings: readonly string[] = ['png', 'jpg', 'jpeg', 'webp', 'svg'];

/** Files that a file picker offers. */
export const printFiles = `.json,${pictureEndings.map((ending) => `.${ending}`).join()}`;

/** An image that is not seamless; the user has to decide about it. */
export class OpenEdgesError extends Error {
  override readonly name = 'OpenEdgesError';
}

/** An image to read a print from, and its name. */
export interface PhotoOfFabric {
  readonly picture: Blob;
  readonly name: string;
}

/** Event that opens the photo dialog. */
export type PhotoWanted = CustomEvent<PhotoOfFabric | null>;
