/** Solves variants of a design in idle time, each once. */
import type {Design} from '../model/design/design.js';
import {problemOf} from '../model/documents/design-problem.js';
import type {SolveResult} from '../model/result/result.js';
import {standingOf, type Standing} from '../model/result/visible-seams.js';
import type {SolverService} from '../solver/service.js';
import {whileVisible} from './considerate.js';
import {idle} from './idle.js';
import {KnownAnswers, type Candidate} from './known-answers.js';

export class IdleSolver {
  readonly #solver: SolverService;
  readonly #keep: (design: Design, result: SolveResult) => void;
  readonly #known = new KnownAnswers();

  /** @param keep stores a result that may be offered, so that it is shown without a solve */
  constructor(solver: SolverService, keep: (design: Design, result: SolveResult) => void) {
    this.#solver = solver;
    this.#keep = keep;
  }

  get known(): Pick<KnownAnswers, 'of' | 'all' | 'firstSeed'> {
    return this.#known;
  }

  /** Records the result of a design. */
  learn(design: Design, result: SolveResult): Standing {
    const standing = standingOf(result, design.options.weights);
    this.#known.keep(design, standing);
    return standing;
  }

  /**
   * @param begun called before a solve; a known answer needs none
   * @throws errors of the solve; the signal's reason
   */
  async standing(design: Design, signal: AbortSignal, begun: () => void): Promise<Standing> {
    const known = this.#known.of(design);
    if (known) return known.standing;
    begun();
    await idle();
    const result = await whileVisible(signal, (either) =>
      this.#solver.solve(problemOf(design), {signal: either}),
    );
    signal.throwIfAborted();
    const most = Math.max(...this.#known.all(design).map(({standing}) => standing.matched));
    const standing = this.learn(design, result);
    if (standing.matched > most) this.#keep(design, result);
    return standing;
  }
}

/** The best of some candidates, if it makes more visible seams match than the present one. */
export function betterThan<C extends Candidate>(
  present: Candidate | undefined,
  others: readonly C[],
): C | undefined {
  if (!present) return undefined;
  const more = others.filter(({standing}) => standing.matched > present.standing.matched);
  return more.toSorted(
    ({standing: a}, {standing: b}) => b.matched - a.matched || a.answerCost - b.answerCost,
  )[0];
}
