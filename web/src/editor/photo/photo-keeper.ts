import type {History} from '../../model/history.js';
import type {PhotoStep} from '../print/photo-step.js';

/** A photograph with all that was decided about it. */
export interface KeptPhoto {
  readonly picture: Blob;
  readonly name: string;
  readonly step: PhotoStep;
}

/** A photograph that no print was made of yet. */
export interface UnfinishedPhoto {
  /** As it was given. */
  readonly picture: Blob;
  readonly name: string;
  /** Undefined until something was read. */
  readonly history: History<PhotoStep> | undefined;
}

/** What a page that is loaded again finds of it. */
export interface FoundPhoto extends UnfinishedPhoto {
  /** The design has the print that it had when the photograph was given. */
  readonly isOfPrint: boolean;
}

/** Keeps the photographs that prints were made of, and this tab's unfinished one; a page that stores nothing has none. */
export interface PhotoKeeper {
  /** @param image the picture of the print that was made; where nothing can be kept, nothing is */
  readonly keep: (image: string, photo: KeptPhoto) => Promise<void>;
  /** What the print with that picture was made of. */
  readonly kept: (image: string) => Promise<KeptPhoto | undefined>;
  /**
   * For this tab's next page, in place of the one before; what cannot be kept is not.
   * @param image the picture of the design's print
   */
  readonly keepUnfinished: (image: string, photo: UnfinishedPhoto) => Promise<void>;
  readonly unfinished: (image: string) => Promise<FoundPhoto | undefined>;
  readonly forgetUnfinished: () => Promise<void>;
}
