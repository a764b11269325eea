/** Compares sizes of the print of a solved design, in the background and on request. */
import type {Design, DesignPrint} from '../model/design/design.js';
import type {ComparedAnswer} from '../model/design/solve-problem.js';
import {problemOf} from '../model/documents/design-problem.js';
import {scalesOf} from '../solver/search/asked-search.js';
import type {SolverService} from '../solver/service.js';
import {DesignFindings, NewestTask} from './background-task.js';
import {idle} from './idle.js';

/** Compared sizes, as multiples of the present size. */
const range = {from: 0.9, to: 1.1};

/** A comparison of sizes. */
export interface SizeComparison {
  readonly isRunning: boolean;
  /** Answers so far; the first one is that of the present size. */
  readonly answers: readonly ComparedAnswer[];
}

/**
 * Returns whether the print may be enlarged: it is printed on demand, and its size is known. The
 * user decides that for prints of their own.
 */
export const canResize = ({method, print}: Pick<Design, 'method' | 'print'>): boolean =>
  method === 'best' && !print.unscaled;

/** The best answer so far, if it is better than that of the present size. */
export const bestSize = ({answers}: SizeComparison): ComparedAnswer | undefined =>
  answers.slice(1).findLast(({isBest}) => isBest);

/** The print with `scale` times its size. */
export function enlarged(print: DesignPrint, scale: number): DesignPrint {
  if (scale === 1) return print;
  const {width, height, angleDeg} = print.size;
  return {...print, size: {width: scale * width, height: scale * height, angleDeg}};
}

export class PrintSizes {
  readonly #solver: SolverService;
  readonly #task = new NewestTask();
  readonly #found: DesignFindings<SizeComparison>;

  constructor(solver: SolverService, changed: () => void) {
    this.#solver = solver;
    this.#found = new DesignFindings(changed);
  }

  /** Undefined unless a comparison was requested. */
  of(design: Design): SizeComparison | undefined {
    return this.#found.of(design);
  }

  /** Compares sizes until all are solved or it is stopped; the answers by then stay. */
  async compare(design: Design): Promise<void> {
    const {signal} = this.#task.begin();
    const answers: ComparedAnswer[] = [];
    const tell = (isRunning: boolean): void => {
      this.#found.learn(design, {isRunning, answers: [...answers]});
    };
    tell(true);
    await idle();
    const {bestAnswer} = await import('../solver/search/best-answer.js');
    const search = {
      ...{scales: scalesOf(range), isLong: false, seed: design.seed},
      // exactly the problem of the design that the user would choose
      problemAt: (scale: number) => problemOf({...design, print: enlarged(design.print, scale)}),
    };
    await bestAnswer(search, (problem, hooks) => this.#solver.solve(problem, hooks), {
      signal,
      onCompared: (answer) => {
        answers.push(answer);
        tell(!signal.aborted);
      },
    }).catch(() => undefined); // stopped, or an error that the main solve reports
    tell(false);
  }

  stop(): void {
    this.#task.stop();
  }
}
