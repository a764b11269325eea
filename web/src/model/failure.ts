import type {SymmetryReason} from './notes.js';
import type {PhotoFault} from './photo.js';

/** Why a solve could not deliver, as the core counts it. Names and numbers only ever grow: both are part of the API. */
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

/** Codes of failures that a page raises without the core. The names are part of the API, too. */
export const pageFailureCodes = [
  /** The solver's worker cannot be started; solving goes on in the page itself. */
  'worker-blocked',
  /** WebAssembly, or the solver's .wasm file, is missing or not allowed. */
  'no-wasm',
  /** A file is not where it was looked for. */
  'not-found',
  'network',
  'timeout',
  'no-webgl',
  /** A file is larger than the page reads. */
  'too-large',
  'not-an-image',
  /** A file is not the one that a design was made with. */
  'file-changed',
  /** Of a print whose size nobody has measured, nothing is cut. */
  'unscaled',
] as const;

export type FailureCode = keyof typeof failureCodes | (typeof pageFailureCodes)[number];

/** A failure as plain data, fit to be posted between threads. */
export interface Failure {
  readonly code: FailureCode;
  /** One sentence for people: it names the piece or seam and the remedy. */
  readonly message: string;
  /** Index of the piece in the garment, if one is to blame. */
  readonly piece: number | null;
  /** Number of the seam in the garment, if one is to blame. */
  readonly seam: number | null;
  /** Why a symmetry that was asked for cannot hold, or no print be read off a picture. */
  readonly reason?: SymmetryReason | PhotoFault;
}

/** The one error the solver throws for what it was given. */
export class SolverError extends Error implements Failure {
  override readonly name = 'SolverError';
  readonly code: FailureCode;
  readonly piece: number | null;
  readonly seam: number | null;
  declare readonly reason?: SymmetryReason | PhotoFault;

  constructor(failure: Pick<Failure, 'code' | 'message'> & Partial<Failure>) {
    super(failure.message);
    this.code = failure.code;
    this.piece = failure.piece ?? null;
    this.seam = failure.seam ?? null;
    if (failure.reason) this.reason = failure.reason;
  }
}

/** An error's failure as plain data. */
export const failureOf = ({code, message, piece, seam, reason}: SolverError): Failure => ({
  ...{code, message, piece, seam},
  ...(reason && {reason}),
});

/** The name of a failure number from the core. */
export function failureCode(number: number): FailureCode {
  for (const [name, value] of Object.entries(failureCodes)) {
    if (value === number) return name as FailureCode;
  }
  return 'internal';
}
