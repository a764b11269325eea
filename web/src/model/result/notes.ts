import {symmetryReasons} from '../base/failure.js';

/**
 * Codes of a result's notes. They are part of the API: new ones may be added, but none may change.
 */
export const noteCodes = [
  'noSeams',
  'noMatchedSeams',
  'gathered',
  'unitsAssumed',
  'curvesAssumed',
  'lengthRatio',
  'noMirrors',
  'noGlides',
  'symmetriesStated',
  'ws19',
  'grainAssumed',
  'pleatsFitted',
  'pleatsOff',
  'pleatsOffGrain',
  'pleatsUndivided',
  'pleatsUneven',
  'partOfTheWay',
  'leftAsDrafted',
  ...symmetryReasons,
] as const;

export type NoteCode = (typeof noteCodes)[number];

/** Content of one sentence of `notes`, for translation. */
export interface NoteDetail {
  /** Code of the note; an unknown one comes from a newer solver. */
  readonly code: string;
  /** Indices of the affected pieces; the two pieces of a pair follow each other. */
  readonly pieces: readonly number[];
  /** Numbers of the affected seams. */
  readonly seams: readonly number[];
  /**
   * For `lengthRatio`: as stated, as drafted. For `symmetryChange` and `symmetryLengths`: the
   * greatest change that would suffice. [cm] For `pleatsFitted` and `pleatsOff`:
   * the width of the pleats as drafted, and the nearest whole repeat. [cm]
   */
  readonly numbers: readonly number[];
}
