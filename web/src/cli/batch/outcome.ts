import type {Failure, FailureCode} from '../../model/failure.js';
import type {Metrics, SolveResult} from '../../model/result.js';

/** The figures of a result that are the same in every run. */
type Figures = Omit<Metrics, 'milliseconds'> & {readonly milliseconds?: undefined};

export const figuresOf = ({metrics}: Pick<SolveResult, 'metrics'>): Figures => ({
  ...metrics,
  milliseconds: undefined,
});

export interface JobFailure extends Omit<Failure, 'code'> {
  /** `bad-line`: the line in the file of jobs holds none. */
  readonly code: FailureCode | 'bad-line';
}

/** How a job ended. `milliseconds` are null when it is not known any more how long it took. */
export type Outcome =
  | {
      readonly status: 'done';
      readonly metrics: Figures;
      /** Of the result's file. */
      readonly sha256: string;
      readonly milliseconds: number | null;
    }
  | {
      readonly status: 'failed';
      readonly failure: JobFailure;
      readonly milliseconds: number | null;
      /** The solver's last word: another try would end in the same way. */
      readonly isFinal: boolean;
    };

/** What stands in the file of a job that failed for good. */
export const failureText = (failure: JobFailure): string => `${JSON.stringify(failure)}\n`;

/** A failure that is none of the solver's, and that may not come again. */
export const failedFor = (code: JobFailure['code'], message: string): Outcome => ({
  status: 'failed',
  failure: {code, message, piece: null, seam: null},
  milliseconds: null,
  isFinal: false,
});
