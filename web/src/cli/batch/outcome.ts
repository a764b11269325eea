import type {Failure, FailureCode} from '../../model/base/failure.js';
import type {Metrics, SolveResult} from '../../model/result/result.js';

/** The reproducible figures of a result. */
type Figures = Omit<Metrics, 'milliseconds'> & {readonly milliseconds?: undefined};

export const figuresOf = ({metrics}: Pick<SolveResult, 'metrics'>): Figures => ({
  ...metrics,
  milliseconds: undefined,
});

export interface JobFailure extends Omit<Failure, 'code'> {
  /** `bad-line`: the line of the jobs file is no job. */
  readonly code: FailureCode | 'bad-line';
}

/** The outcome of a job. `milliseconds` is null if the time is no longer known. */
export type Outcome =
  | {
      readonly status: 'done';
      readonly metrics: Figures;
      /** SHA-256 of the result file. */
      readonly sha256: string;
      readonly milliseconds: number | null;
    }
  | {
      readonly status: 'failed';
      readonly failure: JobFailure;
      readonly milliseconds: number | null;
      /** True if another try would fail in the same way. */
      readonly isFinal: boolean;
    };

/** The file content of a job that failed for good. */
export const failureText = (failure: JobFailure): string => `${JSON.stringify(failure)}\n`;

/** A failure outside the solver, which may not recur. */
export const failedFor = (code: JobFailure['code'], message: string): Outcome => ({
  status: 'failed',
  failure: {code, message, piece: null, seam: null},
  milliseconds: null,
  isFinal: false,
});
