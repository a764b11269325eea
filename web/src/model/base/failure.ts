/**
 * Reasons of a failed solve, with the numbers that the core uses. Names and numbers are part of the
 * API: new ones may be added, but none may change.
 */
export const failureCodes = {
  cancelled: 1,
  internal: 2,
  notJson: 10,
  tooLarge: 11,
  notAGarment: 12,
  noPanels: 13,
  units: 14,
  number: 15,
  edgeIndex: 16,
  edgeZeroLength: 17,
  curvature: 18,
  outlineOpen: 19,
  outlineSelfIntersects: 20,
  seamUnknownPiece: 21,
  seamUnknownEdge: 22,
  seamEdgeTwice: 23,
  seamMalformed: 24,
  mesh: 25,
  notAPrint: 40,
  groupUnknown: 41,
  lattice: 42,
  symmetryMalformed: 60,
  symmetryUnknownPiece: 61,
  symmetryDoesNotMirror: 62,
  symmetryGroup: 63,
  symmetryConflict: 64,
  options: 80,
  picture: 90,
} as const;

/** Codes of failures outside the core. The names are part of the API, too. */
export const pageFailureCodes = [
  /** The solver's worker cannot be started; solving continues on the page's own thread. */
  'worker-blocked',
  /** WebAssembly, or the solver's .wasm file, is missing or not allowed. */
  'no-wasm',
  /** A file is missing at its address. */
  'not-found',
  'network',
  'timeout',
  'no-webgl',
  /** A file is larger than the page reads. */
  'too-large',
  'not-an-image',
  /** A file differs from the one that a design was made with. */
  'file-changed',
  /** A file cannot be read or written, or is damaged or of another kind. */
  'file',
  /** A print of unmeasured size cannot be cut. */
  'unscaled',
] as const;

export type FailureCode = keyof typeof failureCodes | (typeof pageFailureCodes)[number];

/** Failures that a second attempt may avoid; all others are caused by the input. */
export const passingFailures: ReadonlySet<string> = new Set(['internal', 'network', 'timeout']);

/**
 * Reasons why a symmetry does not hold: codes of notes on detected symmetries, and the `reason` of
 * failures of requested ones.
 */
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

/**
 * Reasons why no print can be read from an image. `object`: no coin or card is visible at the given
 * place; `misplaced`: the print does not repeat by the given cell.
 */
export const photoFaults = [
  ...(['plain', 'noRepeat', 'fewRepeats', 'twoPrints', 'changes'] as const),
  ...(['blurred', 'moire', 'uneven', 'edges', 'small', 'object', 'misplaced'] as const),
] as const;
export type PhotoFault = (typeof photoFaults)[number];

/** Reasons why a file of another program is no pattern that can be read. */
export const drawingFaults = [
  ...(['unreadable', 'empty', 'damaged', 'complex', 'locked'] as const),
  /** No line is closed, as the outline of a piece is. */
  'outline',
  /** The kind of the file. */
  ...(['archive', 'binary', 'illustrator', 'model', 'picture', 'plotter', 'postScript'] as const),
  ...(['webPage', 'valentina', 'measurements', 'scan', 'noPattern'] as const),
] as const;
export type DrawingFault = (typeof drawingFaults)[number];

/**
 * Reasons why pieces cannot be laid on the fabric, or why a garment cannot be draped. They are part
 * of the API, too.
 */
export const layReasons = [
  /** The upper end of a piece cannot be up on a one-way print. */
  'layUpright',
  /** A piece is wider than the fabric between its selvedges. */
  'layTooWide',
  /** A pinned piece is over another pin, a flaw or the edge. */
  'layPinned',
  'layFlaws',
  /** No place of a piece in the print fits on the width of the fabric. */
  'layNowhere',
] as const;

export const drapeReasons = [
  /** A piece is placed far from any body. */
  'drapeFar',
  /** No seam joins a piece without a placement. */
  'drapeUnsewn',
  /** The garment takes more fabric than any garment. */
  'drapeTooLarge',
  'drapeSlides',
  'drapeTooSmall',
  'drapeTangled',
] as const;

/** Reason of a failure within its code. */
type FailureReason =
  | SymmetryReason
  | PhotoFault
  | DrawingFault
  | (typeof layReasons)[number]
  | (typeof drapeReasons)[number];

/** A failure as plain data that can be posted between threads. */
export interface Failure {
  readonly code: FailureCode;
  /** One sentence for people, which names the piece or seam and the remedy. */
  readonly message: string;
  /** Index of the affected piece in the garment, or among the pieces to lay; null without one. */
  readonly piece: number | null;
  /** Number of the affected seam in the garment; null without one. */
  readonly seam: number | null;
  /** Reason within the code, if the core gives one. */
  readonly reason?: FailureReason;
  /**
   * A length in the message: what a garment lacks at a girth (`drapeTooSmall`), or the least width of
   * the fabric (`layTooWide`, `layNowhere`). [cm]
   */
  readonly lengthCm?: number;
  /** Measurement of the body where a garment is too small. */
  readonly measure?: string;
  /** The largest size of the form that such a garment fits. */
  readonly fits?: string;
}

/** The only kind of error for input that cannot be used. */
export class SolverError extends Error implements Failure {
  override readonly name: string = 'SolverError';
  readonly code: FailureCode;
  readonly piece: number | null;
  readonly seam: number | null;
  declare readonly reason?: FailureReason;
  declare readonly lengthCm?: number;
  declare readonly measure?: string;
  declare readonly fits?: string;

  constructor(
    failure: Pick<Failure, 'code' | 'message'> & Partial<Failure>,
    options?: ErrorOptions,
  ) {
    super(failure.message, options);
    this.code = failure.code;
    this.piece = failure.piece ?? null;
    this.seam = failure.seam ?? null;
    Object.assign(this, detailsOf(failure));
  }
}

type Details = Pick<Failure, 'reason' | 'lengthCm' | 'measure' | 'fits'>;

/** The parts that not every failure has, without those that are missing. */
const detailsOf = ({reason, lengthCm, measure, fits}: Details): Details => ({
  ...(reason && {reason}),
  ...(lengthCm !== undefined && {lengthCm}),
  ...(measure && {measure}),
  ...(fits && {fits}),
});

/** The failure of an error as plain data. */
export const failureOf = (error: SolverError): Failure => {
  const {code, message, piece, seam} = error;
  return {...{code, message, piece, seam}, ...detailsOf(error)};
};

/** Name of a failure number from the core; `internal` for an unknown number. */
export function failureCode(number: number): FailureCode {
  for (const [name, value] of Object.entries(failureCodes)) {
    if (value === number) return name as FailureCode;
  }
  return 'internal';
}
