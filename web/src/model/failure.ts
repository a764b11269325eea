/** Why a solve could not deliver. Names and numbers only ever grow: both are part of the API. */
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
} as const;

export type FailureCode = keyof typeof failureCodes;

/** A failure as plain data, fit to be posted between threads. */
export interface Failure {
  readonly code: FailureCode;
  /** One sentence for people: it names the piece or seam and the remedy. */
  readonly message: string;
  /** Index of the piece in the garment, if one is to blame. */
  readonly piece: number | null;
  /** Number of the seam in the garment, if one is to blame. */
  readonly seam: number | null;
}

/** The one error the solver throws for what it was given. */
export class SolverError extends Error implements Failure {
  override readonly name = 'SolverError';
  readonly code: FailureCode;
  readonly piece: number | null;
  readonly seam: number | null;

  constructor(failure: Pick<Failure, 'code' | 'message'> & Partial<Failure>) {
    super(failure.message);
    this.code = failure.code;
    this.piece = failure.piece ?? null;
    this.seam = failure.seam ?? null;
  }
}

/** The name of a failure number from the core. */
export function failureCode(number: number): FailureCode {
  for (const [name, value] of Object.entries(failureCodes)) {
    if (value === number) return name as FailureCode;
  }
  return 'internal';
}
