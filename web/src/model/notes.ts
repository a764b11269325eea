/** Why a symmetry does not hold: as the code of a note on a found one, and as the `reason` of a failure of one that was asked for. */
export const symmetryReasons = [
  'symmetryPins',
  'symmetryGrain',
  'symmetryChange',
  'symmetryKinks',
  'symmetryLengths',
  'symmetryCrossing',
  'symmetrySewn',
] as const;

export type SymmetryReason = (typeof symmetryReasons)[number];

/** What a note of a result says. The names only ever grow: they are part of the API. */
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
  'partOfTheWay',
  'leftAsDrafted',
  ...symmetryReasons,
] as const;

export type NoteCode = (typeof noteCodes)[number];

/** What one of the sentences in `notes` says, for who writes it in another language. */
export interface NoteDetail {
  /** One that is not known here comes from a newer solver. */
  readonly code: string;
  /** Indices of the pieces that it is about; of pairs, two after each other. */
  readonly pieces: readonly number[];
  /** Numbers of the seams that it is about. */
  readonly seams: readonly number[];
  /** Of `lengthRatio`: as stated, as drafted. Of `symmetryChange` and `symmetryLengths`: the greatest change that would do. [cm] */
  readonly numbers: readonly number[];
}
