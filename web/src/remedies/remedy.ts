/** What would make seams meet that stay off, as a change of what was asked. */
import type {SolveOptions} from '../model/options.js';
import type {Print} from '../model/print.js';
import type {Problem} from '../model/problem.js';

/**
 * `turn`: pieces by 90 degrees on the cloth; `ungather`: gathers are left out of the match; `mirrors`: a print with
 * mirrors, of the same repeat; `smaller`: a print of half the repeat.
 */
export type RemedyKind = 'turn' | 'ungather' | 'mirrors' | 'smaller';

/** What to put in place of the options and of fields of the print; what is left out stays. */
export interface RemedyChange {
  readonly options?: SolveOptions;
  readonly print?: Partial<Pick<Print, 'group' | 'w1' | 'w2'>>;
}

export interface Proposal {
  readonly kind: RemedyKind;
  /** The pieces that are turned, by name. */
  readonly pieces: readonly string[];
  /** The seams that it is about, by number. */
  readonly seams: readonly number[];
  readonly change: RemedyChange;
}

/** A proposal that was tried and helps. */
export interface Remedy extends Proposal {
  /** Mean mismatch along these seams, or along all that count where these are left out: as it is, and with the remedy. [cm] */
  readonly before: number;
  readonly after: number;
}

/** A part of a problem as an object. @throws {SyntaxError} when it is no JSON */
export const parsed = <T extends object>(part: T | string | undefined): T =>
  typeof part === 'string' ? (JSON.parse(part === '' ? '{}' : part) as T) : (part ?? ({} as T));

/** The same problem with a remedy. */
export function withRemedy(problem: Problem, {options, print}: RemedyChange): Problem {
  return {
    ...problem,
    ...(options && {options: {...parsed(problem.options), ...options}}),
    ...(print && {print: {...parsed(problem.print), ...print}}),
  };
}
