import type {PhotoStep} from '../print/photo-step.js';

/** A photograph with all that was decided about it. */
export interface KeptPhoto {
  readonly picture: Blob;
  readonly name: string;
  readonly step: PhotoStep;
}

/** Keeps the photographs that prints were made of; a page that stores nothing has none. */
export interface PhotoKeeper {
  /** @param image the picture of the print that was made; where nothing can be kept, nothing is */
  readonly keep: (image: string, photo: KeptPhoto) => Promise<void>;
  /** What the print with that picture was made of. */
  readonly kept: (image: string) => Promise<KeptPhoto | undefined>;
}
