/** The searches for better answers, and the answers that they share. Loaded with the first search. */
import type {Design} from '../model/design/design.js';
import type {SolveResult} from '../model/result/result.js';
import type {SolverService} from '../solver/service.js';
import {IdleSolver} from './idle-solver.js';
import {LongerSearch} from './longer-search.js';
import {PrintSizes} from './print-sizes.js';

export interface BetterAnswers {
  readonly solver: IdleSolver;
  readonly sizes: PrintSizes;
  readonly longer: LongerSearch;
}

/**
 * @param keep stores a result that may be offered, so that it is shown without a solve
 * @param offered sizes of the print that a shop offers
 */
export function betterAnswers(
  service: SolverService,
  keep: (design: Design, result: SolveResult) => void,
  changed: () => void,
  offered: () => readonly number[] | undefined,
): BetterAnswers {
  const solver = new IdleSolver(service, keep);
  return {
    solver,
    sizes: new PrintSizes(solver, changed, offered),
    longer: new LongerSearch(solver, changed),
  };
}
