import type {Garment} from '../garment/specification.js';
import type {Method} from '../result/method.js';
import type {ProblemOptions, SolveOptions} from './options.js';
import type {Print} from '../print/repeating-print.js';
import type {MeshedPattern, Proof} from '../result/result.js';
import type {Symmetries} from '../garment/symmetries.js';
import type {PrintVariant} from '../print/print-variant.js';
import type {Standing} from '../result/visible-seams.js';

/** Complete input of a solve. Each member is an object or its JSON text. */
export interface Problem {
  readonly garment: Garment | string;
  readonly print: Print | string;
  /**
   * `'auto'`, the default: the symmetries detected on the garment; `'none'`; or a symmetry file.
   */
  readonly symmetry?: Symmetries | string;
  readonly method?: Method;
  readonly options?: ProblemOptions | string;
  /** A whole number from 0 to 4294967295. Same seed, same input, same result. Default 1. */
  readonly seed?: number;
}

/** A problem that one solve answers. */
export interface SingleProblem extends Omit<Problem, 'options'> {
  readonly options?: SolveOptions | string;
}

/**
 * Preparation reads and meshes the garment and detects its symmetries; alignment places its pieces
 * on the print; deformation shapes them.
 */
export type Phase = 'preparation' | 'alignment' | 'deformation';

export interface Progress {
  readonly phase: Phase;
  /** Share of the whole solve, from 0 to 1; it never decreases. */
  readonly fraction: number;
}

/** One of the answers among which a solve of several sizes, turns or seeds chooses. */
export interface ComparedAnswer extends Standing {
  /** Size of the print, as a multiple of its own. */
  readonly scale: number;
  /** Counter-clockwise turn of the print. [degrees] Omitted if it is not turned. */
  readonly turnDeg?: number;
  readonly seed: number;
  /** True if it is better than all answers before. */
  readonly isBest: boolean;
}

/** Callbacks to follow a solve, and a signal to end it early. */
export interface SolveHooks {
  readonly signal?: AbortSignal;
  /** Receives the garment in the form to be solved, once, as soon as it is prepared. */
  readonly onPattern?: (pattern: MeshedPattern) => void;
  readonly onProgress?: (progress: Progress) => void;
  /**
   * Receives the best alignments so far: angle, x, y per piece. [rad, cm] The callback owns the
   * array.
   */
  readonly onPartial?: (alignments: Float64Array) => void;
  /** Receives each answer to a problem with several sizes, turns or seeds. */
  readonly onCompared?: (answer: ComparedAnswer) => void;
  /** Receives each size or turn that cannot be solved, and the reason. */
  readonly onRefused?: (refused: PrintVariant & {readonly reason: unknown}) => void;
}

/** Callback to follow a proof, and a signal to end it early. */
export interface ProofHooks {
  readonly signal?: AbortSignal;
  /** Receives the proof so far, after every step that improves it. */
  readonly onProof?: (proof: Proof) => void;
}
