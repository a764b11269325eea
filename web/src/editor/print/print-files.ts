/** Files that may be opened as prints. */

/** Of pictures. */
export const pictureEndings: readonly string[] = ['png', 'jpg', 'jpeg', 'webp', 'svg'];

/** What a file picker is to offer. */
export const printFiles = `.json,${pictureEndings.map((ending) => `.${ending}`).join()}`;

/** A picture that does not meet its copies: whoever opened it has to decide what becomes of it. */
export class OpenEdgesError extends Error {
  override readonly name = 'OpenEdgesError';
}

/** A picture that a print is to be read off, and what it is called. */
export interface PhotoOfCloth {
  readonly picture: Blob;
  readonly name: string;
}

/** Asks whoever shows the print's panel to make a print of a photograph. */
export type PhotoWanted = CustomEvent<PhotoOfCloth | null>;
