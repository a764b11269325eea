/** The one size of the print for several garments on one fabric. */
import {withOptions} from '../marker/designs.js';
import type {PrintSizes, ProblemOptions} from '../model/design/options.js';
import type {Problem} from '../model/design/solve-problem.js';
import {standingOf} from '../model/result/visible-seams.js';
import type {SolveResult} from '../model/result/result.js';
import type {NamedSolveHooks, ProblemNames} from '../solver/requests/requests.js';
import {scalesOf} from '../solver/search/asked-search.js';
import {commonSize, type ComparedSize} from '../solver/search/common-size.js';

/** Hooks to follow a comparison of sizes, and to end it early. */
export interface CommonSizeHooks {
  readonly signal?: AbortSignal;
  /** Names of the files of each problem, for messages. */
  readonly names?: readonly Partial<ProblemNames>[];
  /** Called before each solve, with the size and the index of the problem. */
  readonly onSolve?: (scale: number, problem: number) => void;
  /** Receives each compared size, with the seams of all garments. */
  readonly onCompared?: (size: ComparedSize) => void;
  /** Receives each size in which a garment cannot be solved, and the reason. */
  readonly onRefused?: (scale: number, reason: unknown) => void;
}

const optionsOf = ({options = {}}: Problem): ProblemOptions =>
  typeof options === 'string' ? (JSON.parse(options) as ProblemOptions) : options;

export async function commonSizeOf(
  problems: readonly Problem[],
  sizes: PrintSizes,
  solve: (problem: Problem, hooks: NamedSolveHooks) => Promise<SolveResult>,
  {signal, names = [], onSolve, onCompared, onRefused}: CommonSizeHooks,
): Promise<number> {
  return commonSize(problems.length, {
    scales: scalesOf(sizes),
    ...(signal && {signal}),
    ...(onCompared && {onCompared}),
    ...(onRefused && {onRefused}),
    standingOf: async (k, printSize) => {
      const {[k]: problem = {garment: '', print: ''}} = problems;
      const {[k]: called} = names;
      onSolve?.(printSize, k);
      const result = await solve(withOptions(problem, {printSize}), {
        ...(signal && {signal}),
        ...(called && {names: called}),
      });
      return standingOf(result, optionsOf(problem).weights ?? {});
    },
  });
}
