/**
 * Codes of notes on a marker. They are part of the API: new ones may be added, but none may change.
 */
export type LayNoteCode =
  /** `pieces` are cut from other fabric. */
  | 'plainPieces'
  /** No length lets all plies start at the same place of the print. */
  | 'pliesUnlike'
  /** Each of `counts` plies is whole repeats long (`lengthsCm`). */
  | 'pliesWhole'
  /** The distance from the cut to the start of the print is not given. */
  | 'flawsFromCut'
  /** The fabric is folded at `lengthsCm` from the left edge. */
  | 'folded'
  /** The print is not moved on folded fabric. */
  | 'foldKeepsPrint'
  /** Least and greatest length (`lengthsCm`), depending on the start of the print. */
  | 'phaseRange'
  /**
   * Number of starts of the print at which not all pieces fit, and number of all starts (`counts`).
   */
  | 'phaseNowhere';

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
