/**
 * Model of a page or element: a design with its history, and the solver's results. It consists of
 * parts that can be observed separately. Access to a part through the workbench is recorded as a
 * read of that part (`Observable.readBy`), whatever is done with it.
 */
import type {Design, DesignGarment} from '../model/design/design.js';
import type {GarmentDocument} from '../model/garment/garment-document.js';
import {begun} from '../model/design/history.js';
import type {Progress} from '../model/design/solve-problem.js';
import type {MeshedPattern} from '../model/result/result.js';
import {leaseSolver, type SolverLease} from '../solver/pool.js';
import type {SolverService} from '../solver/service.js';
import {tileOf, type Tile} from '../image/tile.js';
import {preferencesFor, type Preferences} from '../texts/preferences.js';
import type {Afterwards} from './afterwards.js';
import {ChosenPreferences} from './chosen-preferences.js';
import {DesignHistory} from './design-history.js';
import {Notices} from './notices.js';
import {Observable} from './observable.js';
import {RunningSolve} from './running-solve.js';
import {bareFabric, newDesign} from './samples.js';
import type {Searches} from './searches.js';
import {Selection} from './selection.js';
import {ShownSheet} from './shown-sheet.js';
import {Solving} from './solving.js';

export type * from './state.js';

interface WorkbenchOptions {
  /** Receives every progress report of a solve; other parts receive them at a limited rate. */
  readonly progress?: (progress: Progress) => void;
  /** Loads the image of a print's cell by its URL; without an image the fabric is bare. */
  readonly tileOf?: (image: string, signal?: AbortSignal) => Promise<Tile | undefined>;
}

/** Parts that can be observed separately. */
export interface WorkbenchParts {
  readonly preferences: ChosenPreferences;
  readonly notices: Notices;
  readonly selection: Selection;
  readonly sheet: ShownSheet;
  readonly history: DesignHistory;
  readonly running: RunningSolve;
  readonly solving: Solving;
  readonly afterwards: Afterwards;
  readonly searches: Searches;
}

export class Workbench {
  readonly solver: SolverService;
  readonly tileOf: NonNullable<WorkbenchOptions['tileOf']>;
  readonly #parts: WorkbenchParts;
  readonly #lease: SolverLease;

  /** @param lease lease that `dispose` ends */
  constructor(
    lease: SolverLease = leaseSolver(),
    chosen = preferencesFor(navigator.language),
    {progress, tileOf: read = tileOf}: WorkbenchOptions = {},
  ) {
    this.solver = lease.solver;
    this.#lease = lease;
    this.tileOf = read;
    const preferences = new ChosenPreferences(chosen);
    const [notices, selection, sheet] = [new Notices(), new Selection(), new ShownSheet()];
    const running = new RunningSolve();
    const history = new DesignHistory(sheet, {
      mended: (design) => solving.mended(design),
      arrived: () => {
        notices.say(undefined);
        solving.arrive();
      },
    });
    const known = {preferences, notices, selection, running, history};
    const solving: Solving = new Solving(lease.solver, known, progress);
    const {afterwards} = solving;
    this.#parts = {...known, sheet, solving, afterwards, searches: afterwards.searches};
  }

  /**
   * Calls back after changes of some parts, once if several change together.
   * @returns the function that ends this
   */
  subscribe(parts: readonly (keyof WorkbenchParts)[], listener: () => void): () => void {
    const ends = parts.map((name) => this.#parts[name].subscribe(listener));
    return () => {
      for (const end of ends) end();
    };
  }

  /** For reading only: `prefer` changes preferences, since that may start the solver. */
  get preferences(): Pick<ChosenPreferences, 'chosen' | 'texts'> {
    return this.#parts.preferences.read;
  }

  get notices(): Notices {
    return this.#parts.notices.read;
  }

  get selection(): Selection {
    return this.#parts.selection.read;
  }

  get sheet(): ShownSheet {
    return this.#parts.sheet.read;
  }

  get history(): DesignHistory {
    return this.#parts.history.read;
  }

  get running(): RunningSolve {
    return this.#parts.running.read;
  }

  get solving(): Solving {
    return this.#parts.solving.read;
  }

  get afterwards(): Afterwards {
    return this.#parts.afterwards.read;
  }

  get searches(): Searches {
    return this.#parts.searches.read;
  }

  prefer(change: Partial<Preferences>): void {
    const {preferences, solving} = this.#parts;
    const wasOff = !preferences.chosen.solveAsIGo;
    preferences.prefer(change);
    if (wasOff && change.solveAsIGo && solving.state.kind === 'stale') solving.align();
  }

  /**
   * Takes a step to an edited garment.
   * @param document content of its file
   * @param pattern its pattern until it is meshed
   */
  edit(
    change: Partial<Design> & Pick<Design, 'garment'>,
    document: GarmentDocument,
    pattern: MeshedPattern,
  ): void {
    this.#parts.solving.expect(change.garment, document, pattern);
    this.#parts.history.change(change);
  }

  /**
   * Begins with another garment in the present print, once it has been read.
   * @throws {SolverError} and changes nothing
   */
  async open(garment: DesignGarment): Promise<void> {
    const {history, solving} = this.#parts;
    const fresh = newDesign(garment, history.design?.print ?? bareFabric);
    const [pattern] = await Promise.all([solving.meshed(fresh), solving.documentOf(garment)]);
    const {method, fabric} = history.design ?? fresh;
    const design = {...fresh, method, ...(fabric && {fabric})};
    Observable.together(() => {
      history.begin(begun({design, view: null}));
      solving.know(garment, pattern);
    });
  }

  dispose(): void {
    this.#lease.release();
    for (const part of Object.values(this.#parts) as Observable[]) part.dispose();
  }
}
