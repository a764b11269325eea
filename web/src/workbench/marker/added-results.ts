/** The solved garments of a fabric layout. Those beside the design's own are solved for it. */
import {SolverError, failureOf} from '../../model/base/failure.js';
import {garmentsOnFabric, type Design} from '../../model/design/design.js';
import {problemOf} from '../../model/documents/design-problem.js';
import type {GarmentDocument} from '../../model/garment/garment-document.js';
import type {SolveResult} from '../../model/result/result.js';
import {ResultCache} from '../result-cache.js';
import type {Workbench} from '../workbench.js';

export interface SolvedGarment {
  /** The garment on the print of the fabric. */
  readonly design: Design;
  /** Number of garments. */
  readonly copies: number;
  readonly result: SolveResult;
  readonly document: GarmentDocument;
}

/** The garment that is being solved: its file, its index from 1, and the number of garments. */
export interface GarmentInWork {
  readonly name: string;
  readonly number: number;
  readonly count: number;
}

interface Hooks {
  readonly signal: AbortSignal;
  /** @param fraction share of the garment's solve, from 0 to 1 */
  readonly onProgress: (inWork: GarmentInWork, fraction: number) => void;
}

/** Number of stored results. */
const most = 24;

/** An error with the name of its garment, whose pieces are not those of the design. */
function named(error: unknown, name: string): unknown {
  if (!(error instanceof SolverError)) return error;
  const {message} = error;
  return new SolverError({
    ...{...failureOf(error), code: 'options', piece: null, seam: null},
    message: `${name}: ${message}`,
  });
}

export class AddedResults {
  readonly #known = new ResultCache<Omit<SolvedGarment, 'copies'>>(most);

  /**
   * All garments of a design, the design's own first.
   * @throws {SolverError} naming the garment that cannot be solved; the signal's reason
   */
  async of(
    design: Design,
    own: Pick<SolvedGarment, 'result' | 'document'>,
    {solver, solving}: Pick<Workbench, 'solver' | 'solving'>,
    {signal, onProgress}: Hooks,
  ): Promise<readonly SolvedGarment[]> {
    const [first, ...added] = garmentsOnFabric(design);
    const solved: SolvedGarment[] = [{...own, design, copies: first?.copies ?? 1}];
    for (const [k, {copies, ...one}] of added.entries()) {
      const {name} = one.garment;
      const inWork = {name, number: k + 2, count: added.length + 1};
      const known = this.#known.of(one);
      if (known) {
        solved.push({...known, copies});
        continue;
      }
      onProgress(inWork, 0);
      try {
        const document = await solving.documentOf(one.garment);
        const result = await solver.solve(problemOf(one), {
          signal,
          names: {garment: name},
          onProgress: ({fraction}) => {
            if (!signal.aborted) onProgress(inWork, fraction);
          },
        });
        this.#known.keep(one, {design: one, result, document});
        solved.push({design: one, copies, result, document});
      } catch (error) {
        signal.throwIfAborted();
        throw named(error, name);
      }
    }
    return solved;
  }
}
