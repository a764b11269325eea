/** Remedies: changes of a problem that reduce the mismatch at seams. */
import type {SolveOptions} from '../model/design/options.js';
import type {Print} from '../model/print/repeating-print.js';
import type {SingleProblem} from '../model/design/solve-problem.js';

/**
 * `turn`: rotates pieces by 90 degrees on the fabric; `ungather`: excludes gathers from the match;
 * `mirrors`: a print with mirrors and the same repeat; `smaller`: a print of half the repeat.
 */
export type RemedyKind = 'turn' | 'ungather' | 'mirrors' | 'smaller';

/** Replacements for options and fields of the print; missing ones stay unchanged. */
export interface RemedyChange {
  readonly options?: SolveOptions;
  readonly print?: Partial<Pick<Print, 'group' | 'w1' | 'w2'>>;
}

export interface Proposal {
  readonly kind: RemedyKind;
  /** Names of the rotated pieces. */
  readonly pieces: readonly string[];
  /** Indices of the improved seams. */
  readonly seams: readonly number[];
  readonly change: RemedyChange;
}

/** A tested proposal that helps. */
export interface Remedy extends Proposal {
  /**
   * Mean mismatch along these seams before and after; for `ungather`, along all counted seams. [cm]
   */
  readonly before: number;
  readonly after: number;
}

/**
 * A part of a problem as an object.
 * @throws {SyntaxError} if it is invalid JSON
 */
export const parsed = <T extends object>(part: T | string | undefined): T =>
  typeof part === 'string' ? (JSON.parse(part === '' ? '{}' : part) as T) : (part ?? ({} as T));

/** The problem with a remedy applied. */
export function withRemedy(problem: SingleProblem, {options, print}: RemedyChange): SingleProblem {
  return {
    ...problem,
    ...(options && {options: {...parsed(problem.options), ...options}}),
    ...(print && {print: {...parsed(problem.print), ...print}}),
  };
}
