import type {Garment} from './garment.js';
import type {Method} from './method.js';
import type {SolveOptions} from './options.js';
import type {Print} from './print.js';
import type {MeshedPattern, Proof} from './result.js';
import type {Symmetries} from './symmetries.js';

/** Everything a solve needs. An object, or the JSON text of one. */
export interface Problem {
  readonly garment: Garment | string;
  readonly print: Print | string;
  /** `'auto'`, the default: what the garment shows by itself; `'none'`; or a symmetry file. */
  readonly symmetry?: Symmetries | string;
  readonly method?: Method;
  readonly options?: SolveOptions | string;
  /** A whole number from 0 to 4294967295. Same seed, same input, same result. Default 1. */
  readonly seed?: number;
}

/** Reading and meshing the garment, looking for its symmetries; laying its pieces on the print; shaping them. */
export type Phase = 'preparation' | 'alignment' | 'deformation';

export interface Progress {
  readonly phase: Phase;
  /** Of the whole solve, from 0 to 1; never falls. */
  readonly fraction: number;
}

/** How to follow a solve and how to end it early. */
export interface SolveHooks {
  readonly signal?: AbortSignal;
  /** The garment as it is going to be solved; once, as soon as it is prepared. */
  readonly onPattern?: (pattern: MeshedPattern) => void;
  readonly onProgress?: (progress: Progress) => void;
  /** The best alignments so far: angle, x, y per piece. [rad, cm] The array is the listener's own. */
  readonly onPartial?: (alignments: Float64Array) => void;
}

/** What a proof reports while it runs. */
export interface ProofHooks {
  readonly signal?: AbortSignal;
  /** What is proven by then; with every step that proves more. */
  readonly onProof?: (proof: Proof) => void;
}
