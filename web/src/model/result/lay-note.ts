/**
 * Codes of notes on a marker. They are part of the API: new ones may be added, but none may change.
 */
export const layNoteCodes = [
  /** `pieces` are cut from other fabric. */
  'plainPieces',
  /** The print never repeats along the fabric, so no length lets all plies start alike. */
  'pliesUnlike',
  /** Each of `counts` plies is a whole number of repeats long; one repeat is `lengthsCm`. */
  'pliesWhole',
  /** Flaws are measured from the cut, and the print is assumed to start there. */
  'flawsFromCut',
  /** The fabric is folded at `lengthsCm` from the left edge. */
  'folded',
  /** The print is not shifted under pieces on folded fabric, because the lower ply mirrors it. */
  'foldKeepsPrint',
  /** Least and greatest length (`lengthsCm`), depending on the start of the print. */
  'phaseRange',
  /**
   * Number of starts of the print at which not all pieces fit, and number of all starts (`counts`).
   */
  'phaseNowhere',
] as const;
export type LayNoteCode = (typeof layNoteCodes)[number];

/** Content of one sentence of `notes`, for translation. */
export interface LayNote {
  readonly code: LayNoteCode;
  readonly pieces: readonly string[];
  readonly lengthsCm: readonly number[];
  readonly counts: readonly number[];
}

/** Makes a note; members that are not given are empty. */
export const layNote = (
  code: LayNoteCode,
  {pieces = [], lengthsCm = [], counts = []}: Partial<LayNote> = {},
): LayNote => ({code, pieces, lengthsCm, counts});

/** Returns whether the note compares starts of the print. */
export const isOfPhases = ({code}: LayNote): boolean =>
  code === 'phaseRange' || code === 'phaseNowhere';
