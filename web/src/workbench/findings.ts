/** Facts about a solved design, found in the background. */
import type {Design} from '../model/design/design.js';
import {problemOf} from '../model/documents/design-problem.js';
import type {Proof, SolveResult} from '../model/result/result.js';
import {seamCount, type SeamCount} from '../model/result/seam-groups.js';
import {seamGroupsOf} from '../scene/group-states.js';
import type {SolverService} from '../solver/service.js';
import {DesignFindings, NewestTask} from './background-task.js';
import {maySpend} from './considerate.js';
import {idle, paused} from './idle.js';
import type {Remedy} from '../remedies/remedy.js';
import {provenShare} from '../model/base/core-tables.js';

/** Cost of a design's symmetries: solves the same design without them, in the background. */
export class Comparison {
  readonly #solver: SolverService;
  readonly #task = new NewestTask();
  readonly #counts: DesignFindings<SeamCount>;
  /** The last design without symmetries, and its result. */
  #free: {readonly design: Design; readonly result: SolveResult} | undefined;

  constructor(solver: SolverService, changed: () => void) {
    this.#solver = solver;
    this.#counts = new DesignFindings(changed);
  }

  /** Numbers of visible seams, and of those that match without symmetries. */
  of(design: Design): SeamCount | undefined {
    return this.#counts.of(design);
  }

  /** Follows a solved design. If its result has symmetries, it is also solved without them. */
  async follow(design: Design, result: SolveResult): Promise<void> {
    this.stop();
    if (result.symmetries.length === 0) {
      this.#free = {design, result};
    } else if (this.#counts.of(design) === undefined) {
      if (!this.#free || !differOnlyInSymmetry(this.#free.design, design)) {
        if (!(await this.#solveFree(design, this.#task.begin().signal))) return;
      }
      this.#compare(design);
    }
  }

  stop(): void {
    this.#task.stop();
  }

  /** Solves a design without symmetries. @returns whether there is a result */
  async #solveFree(design: Design, signal: AbortSignal): Promise<boolean> {
    const free: Design = {...design, symmetry: 'none'};
    // a failure is not reported, since the main solve reports its own; no comparison is shown then
    const result = await this.#solver.solve(problemOf(free), {signal}).catch(() => undefined);
    if (result) this.#free = {design: free, result};
    return result !== undefined;
  }

  #compare(design: Design): void {
    if (!this.#free) return;
    const groups = seamGroupsOf(this.#free.result);
    this.#counts.learn(design, seamCount(groups, design.options.weights));
  }
}

const differOnlyInSymmetry = (a: Design, b: Design): boolean =>
  a.garment === b.garment &&
  a.print === b.print &&
  a.method === b.method &&
  a.options === b.options &&
  a.seed === b.seed;

/** Searches for changes that make the mismatched seams of a design match, in the background. */
export class RemedySearch {
  readonly #solver: SolverService;
  readonly #task = new NewestTask();
  readonly #remedies: DesignFindings<readonly Remedy[]>;

  constructor(solver: SolverService, changed: () => void) {
    this.#solver = solver;
    this.#remedies = new DesignFindings(changed);
  }

  /** Remedies found so far. */
  of(design: Design): readonly Remedy[] {
    return this.#remedies.of(design) ?? [];
  }

  /** Follows a solved design. */
  async follow(design: Design, result: SolveResult): Promise<void> {
    this.stop();
    if (this.#remedies.isFinished(design)) return;
    const {signal} = this.#task.begin();
    const found: Remedy[] = [];
    try {
      await paused(signal);
      signal.throwIfAborted();
      const {remediesOf} = await import('../remedies/remedies.js');
      signal.throwIfAborted();
      await remediesOf(
        problemOf(design),
        result,
        (problem, stop) => this.#solver.solve(problem, stop ? {signal: stop} : {}),
        {
          signal,
          idle,
          onRemedy: (remedy) => {
            found.push(remedy);
            this.#remedies.learn(design, [...found]);
          },
        },
      );
      this.#remedies.finish(design);
    } catch {
      // the user has gone on; the search is repeated when they return to the design
    }
  }

  stop(): void {
    this.#task.stop();
  }
}

// Bound on the alignment of a design, computed in the background.

/** Time limit of a proof. The rest would take far longer, and drain a battery. [ms] */
const patience = 60_000;

/** A share in whole per cent, since smaller changes are not reported; 101 for a complete proof. */
const percent = (share: number): number => (share === 1 ? 101 : Math.floor(100 * share));

export class Proving {
  readonly #solver: SolverService;
  readonly #task = new NewestTask();
  readonly #bounds: DesignFindings<number>;

  constructor(solver: SolverService, changed: () => void) {
    this.#solver = solver;
    this.#bounds = new DesignFindings(changed);
  }

  /**
   * Bound on the alignment: no other one has less than this share of the present one's mismatch.
   */
  of(design: Design): number | undefined {
    return this.#bounds.of(design);
  }

  /** Follows a solved design, if the device permits. */
  async follow(design: Design, {metrics}: SolveResult): Promise<void> {
    this.stop();
    const {method, searchBound, searchCost} = metrics;
    if (method !== 'best' || searchBound === 1 || this.#bounds.isFinished(design)) return;
    const running = this.#task.begin();
    await paused(running.signal);
    if (!(await maySpend())) return;
    const late = setTimeout(() => {
      this.#bounds.finish(design); // a longer proof is not worth it
      running.abort();
    }, patience);
    const onProof = ({bound, searchCost: found}: Proof): void => {
      // the proof's alignment is another one after more effort, or if a cutter's layout or a
      // symmetric one is used
      const share = (bound * found) / searchCost;
      const known = share >= 1 - provenShare ? 1 : Math.max(share, searchBound);
      this.#bounds.learn(design, known, percent(known) > percent(this.of(design) ?? 0));
    };
    try {
      await this.#solver.prove(problemOf(design), {signal: running.signal, onProof});
      this.#bounds.finish(design);
    } catch {
      // the proof was not requested, so errors are ignored; the bound so far stays
    } finally {
      clearTimeout(late);
    }
  }

  stop(): void {
    this.#task.stop();
  }
}
