import type {History} from '../model/design/history.js';
import type {PhotoStep} from './photo-step.js';

/** A photo with all decisions about it. */
export interface KeptPhoto {
  readonly picture: Blob;
  readonly name: string;
  readonly step: PhotoStep;
}

/** A photo that no print has been made from. */
export interface UnfinishedPhoto {
  /** Image as given. */
  readonly picture: Blob;
  readonly name: string;
  /** Undefined until the photo has been read. */
  readonly history: History<PhotoStep> | undefined;
}

/** An unfinished photo that a reloaded page finds. */
export interface FoundPhoto extends UnfinishedPhoto {
  /** True if the design has the same print as when the photo was given. */
  readonly isOfPrint: boolean;
}

/**
 * Keeps the photos that prints were made from, and this tab's unfinished photo. A page without
 * storage has no keeper.
 */
export interface PhotoKeeper {
  /** Keeps a photo if possible. @param image image of the print made from it */
  readonly keep: (image: string, photo: KeptPhoto) => Promise<void>;
  /** Returns the photo that the print with this image was made from. */
  readonly kept: (image: string) => Promise<KeptPhoto | undefined>;
  /**
   * Keeps the unfinished photo for this tab's next page if possible, in place of the one before.
   * @param image image of the design's print
   */
  readonly keepUnfinished: (image: string, photo: UnfinishedPhoto) => Promise<void>;
  readonly unfinished: (image: string) => Promise<FoundPhoto | undefined>;
  readonly forgetUnfinished: () => Promise<void>;
}
