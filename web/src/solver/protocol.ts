import type {Failure} from '../model/failure.js';
import type {GarmentDocument} from '../model/garment-document.js';
import type {Phase} from '../model/problem.js';
import type {MeshedPattern, Proof, SolveResult} from '../model/result.js';
import type {DetectedSymmetries, MeasuredSymmetry} from '../model/symmetries.js';
import type {MirrorTexts, ProblemTexts} from './texts.js';

/** Grows with every change of the messages: a page must not talk to a worker from an old cache. */
export const protocolVersion = '5';

/** What the answer to each kind of question is. */
export interface Answers {
  readonly solve: SolveResult;
  readonly prepare: MeshedPattern;
  readonly prove: Proof;
  readonly mirror: MeasuredSymmetry;
  readonly symmetries: DetectedSymmetries;
  readonly garment: GarmentDocument;
  readonly convert: string;
  /** Of a share, for `Solver.take`. */
  readonly share: Float64Array;
}

export type Answer = Answers[keyof Answers];

/** What a solver can be asked, in texts. */
export type Question =
  | {
      readonly kind: 'solve';
      readonly texts: ProblemTexts;
      /** Whether the page wants to see the pattern first. */
      readonly showsPattern: boolean;
      /** How many threads may help; none, unless said otherwise. */
      readonly helpers?: number;
    }
  | {readonly kind: 'prepare' | 'prove'; readonly texts: ProblemTexts}
  | {readonly kind: 'mirror'; readonly texts: MirrorTexts}
  /** To run a share of another worker's search, from `Solver.lend`. */
  | {readonly kind: 'share'; readonly order: Float64Array}
  | {
      readonly kind: 'garment' | 'symmetries' | 'convert';
      readonly garment: string;
      /** What to call the garment in messages. */
      readonly name: string;
    };

export type QuestionOf<K extends keyof Answers> = Question & {readonly kind: K};

/** Starts a job. Its number is the page's and is never used again. */
export type JobRequest = Question & {readonly job: number};

/** Everything the page may say. */
export type ToWorker =
  | JobRequest
  /** Where the .wasm file is; comes before any job, if at all. */
  | {readonly kind: 'locate'; readonly wasmUrl: string}
  /** What another worker runs, to be run as well; comes before any job, if at all. */
  | {readonly kind: 'module'; readonly module: WebAssembly.Module}
  /** The job is no longer wanted; it still ends with `done` or `failed`. */
  | {readonly kind: 'cancel'; readonly job: number}
  /** To be answered at once, by `pong`. */
  | {readonly kind: 'ping'};

/** Everything the worker may answer. A job ends with exactly one `done` or `failed`. */
export type FromWorker =
  | {readonly kind: 'ready'; readonly version: string}
  | {readonly kind: 'pong'}
  | {
      readonly kind: 'progress';
      readonly job: number;
      readonly phase: Phase;
      readonly fraction: number;
    }
  /** When its job is prepared, if it was asked for. */
  | {readonly kind: 'pattern'; readonly job: number; readonly pattern: MeshedPattern}
  /** Angle, x, y per piece; transferred. [rad, cm] */
  | {readonly kind: 'partial'; readonly job: number; readonly alignments: Float64Array}
  | {readonly kind: 'proof'; readonly job: number; readonly proof: Proof}
  | {readonly kind: 'done'; readonly job: number; readonly answer: Answer}
  | {readonly kind: 'failed'; readonly job: number; readonly failure: Failure};
