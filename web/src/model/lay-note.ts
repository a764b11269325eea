/** What there is to know of a lay plan besides its figures. The names only ever grow: they are part of the API. */
export type LayNoteCode =
  /** `pieces` are cut from other cloth. */
  | 'plainPieces'
  /** No length makes plies start alike. */
  | 'pliesUnlike'
  /** Of how many plies (`counts`) each is whole repeats (`lengthsCm`) long. */
  | 'pliesWhole'
  /** Nobody has said how far from the cut the print starts. */
  | 'flawsFromCut'
  /** How far from the left edge (`lengthsCm`) the cloth is folded. */
  | 'folded'
  /** On folded cloth no print is moved. */
  | 'foldKeepsPrint'
  /** From the least to the most (`lengthsCm`), by where the print starts. */
  | 'phaseRange'
  /** At how many of how many places (`counts`) of the print not all pieces fit. */
  | 'phaseNowhere';

/** What one of the sentences in `notes` says, for who writes it in another language. */
export interface LayNote {
  readonly code: LayNoteCode;
  readonly pieces: readonly string[];
  readonly lengthsCm: readonly number[];
  readonly counts: readonly number[];
}

/** With nothing where nothing is given. */
export const layNote = (
  code: LayNoteCode,
  {pieces = [], lengthsCm = [], counts = []}: Partial<LayNote> = {},
): LayNote => ({code, pieces, lengthsCm, counts});

/** It compares places where the print may start. */
export const isOfPhases = ({code}: LayNote): boolean =>
  code === 'phaseRange' || code === 'phaseNowhere';
