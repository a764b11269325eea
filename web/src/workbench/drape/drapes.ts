/** Drape of the present result, computed while it is on display. */
import type {
  Drape,
  DrapeMesh,
  DrapeProgress,
  DrapeSettings,
  FabricName,
  Form,
  FormSize,
} from '../../model/result/draped-garment.js';
import {fabricOf, type Design, type DesignGarment} from '../../model/design/design.js';
import type {Failure} from '../../model/base/failure.js';
import type {Point} from '../../model/geometry/vectors.js';
import type {SolveResult} from '../../model/result/result.js';
import type {StoredDrape} from '../../model/documents/stored-drape.js';
import {toFailure} from '../latest-solve.js';
import {Observable} from '../observable.js';
import type {Workbench} from '../workbench.js';

/**
 * `waiting`: there is no result to drape; `draping`: the previous drape stays on display until the
 * first positions arrive.
 */
type DrapesState =
  | {readonly kind: 'waiting' | 'done' | 'cancelled'}
  | {readonly kind: 'draping'; readonly progress: DrapeProgress}
  | {readonly kind: 'failed'; readonly failure: Failure};

/** A view of the drape, which receives all data of a running drape. */
export interface DrapesViewer {
  form(form: Form): void;
  /** Receives the mesh of the next positions. */
  mesh(mesh: DrapeMesh): void;
  /**
   * Receives x, y, z per vertex of the mesh. [cm]
   * @param isFinal true if the mesh does not move any more
   */
  positions(positions: Float32Array, isFinal: boolean): void;
  /** Clears the display, which shows another garment. */
  clear(): void;
}

/** Input of a drape. */
interface Question {
  readonly garment: DesignGarment;
  readonly result: SolveResult;
  readonly fabric: FabricName;
  /** Undefined for the size in the garment's file, or the one that fits. */
  readonly size: FormSize | undefined;
}

/** A drape that is known before its design is solved. */
interface KnownDrape extends Pick<StoredDrape, 'drape' | 'alignments'> {
  readonly design: Design;
}

/** Number of stored drapes; each takes about a megabyte. */
const most = 8;

const begun: DrapeProgress = {stage: 'sew', fraction: 0};

type Source = Pick<Workbench, 'history' | 'solving' | 'subscribe' | 'solver'>;

export class Drapes extends Observable {
  readonly #source: Source;
  readonly #viewers = new Set<DrapesViewer>();
  /** Stored drapes, the oldest first. */
  #kept: readonly (readonly [Question, Drape])[] = [];
  #state: DrapesState = {kind: 'waiting'};
  /** Input of the last or the running drape, even if that failed or was cancelled. */
  #question: Question | undefined;
  #running: AbortController | undefined;
  #drape: Drape | undefined;
  /** Data on display, for views that are added later. */
  #form: Form | undefined;
  #mesh: DrapeMesh | undefined;
  #positions: Float32Array | undefined;
  #shown: DesignGarment | undefined;
  #end: (() => void) | undefined;
  #known: KnownDrape | undefined;
  /** Size of the form that the user has chosen for a garment. */
  #chosen: {readonly garment: DesignGarment; readonly size: FormSize} | undefined;

  constructor(source: Source) {
    super();
    this.#source = source;
  }

  get state(): DrapesState {
    return this.#state;
  }

  /** Settled drape of the present result or of the one before. */
  get drape(): Drape | undefined {
    return this.#drape;
  }

  /** Shows a stored drape of the present design without a solve. */
  know({drape, alignments}: Pick<StoredDrape, 'drape' | 'alignments'>): void {
    const {design} = this.#source.history;
    if (!design) return;
    this.#known = {drape, alignments, design};
    this.#show(drape, design.garment);
  }

  /** The stored drape of the present design. */
  get known(): KnownDrape | undefined {
    return this.#known?.design === this.#source.history.design ? this.#known : undefined;
  }

  /**
   * Adds a view and drapes from now on.
   * @returns the function that removes the view; without views nothing is draped
   */
  show(viewer: DrapesViewer): () => void {
    if (this.#form) viewer.form(this.#form);
    if (this.#mesh && this.#positions) {
      viewer.mesh(this.#mesh);
      viewer.positions(this.#positions, this.#state.kind !== 'draping');
    }
    // a file that was missing may be there by now
    if (this.#viewers.size === 0 && this.#state.kind === 'failed') this.#question = undefined;
    this.#viewers.add(viewer);
    this.#end ??= this.#source.subscribe(['history', 'solving'], () => {
      this.#follow();
    });
    this.#follow();
    return () => {
      this.#viewers.delete(viewer);
      if (this.#viewers.size > 0) return;
      this.#end?.();
      this.#end = undefined;
      if (this.#state.kind !== 'draping') return;
      this.#stop();
      this.#question = undefined;
      this.#become({kind: 'waiting'});
    };
  }

  /** Ends the running drape; the display stays. */
  cancel(): void {
    if (this.#state.kind !== 'draping') return;
    this.#stop();
    this.#become({kind: 'cancelled'});
  }

  /** Repeats a drape that was cancelled or failed. */
  again(): void {
    this.#question = undefined;
    this.#follow();
  }

  /** Drapes the present garment on a form of this size. */
  drapeOn(size: FormSize): void {
    const {design} = this.#source.history;
    if (!design) return;
    this.#chosen = {garment: design.garment, size};
    this.#follow();
  }

  #become(state: DrapesState): void {
    this.#state = state;
    this.changed();
  }

  #stop(): void {
    this.#running?.abort();
    this.#running = undefined;
  }

  #follow(): void {
    const {design} = this.#source.history;
    const {result} = this.#source.solving;
    if (!design || !result) {
      this.#wait(design);
      return;
    }
    const {garment} = design;
    const size = this.#chosen?.garment === garment ? this.#chosen.size : undefined;
    const question = {garment, result, fabric: fabricOf(design), size};
    if (this.#question && isSame(question, this.#question)) return;
    this.#stop();
    this.#question = question;
    const known =
      design === this.#known?.design && size === undefined
        ? this.#known.drape
        : this.#kept.find(([one]) => isSame(one, question))?.[1];
    if (known) this.#show(known, garment);
    else void this.#run(question);
  }

  /**
   * Waits for a result. A running drape continues if only the print changes, since that may need no
   * other drape.
   */
  #wait(design: Design | undefined): void {
    if (!this.#question || this.#question.garment === design?.garment) return;
    this.#stop();
    this.#question = undefined;
    this.#become({kind: 'waiting'});
  }

  #show(drape: Drape, garment: DesignGarment): void {
    this.#drape = drape;
    this.#shown = garment;
    const {form, mesh} = drape;
    this.#tellForm(form);
    this.#tellMesh(mesh);
    this.#tellPositions(Float32Array.from(drape.positions), true);
    this.#become({kind: 'done'});
  }

  async #run(question: Question): Promise<void> {
    const running = new AbortController();
    this.#running = running;
    this.#become({kind: 'draping', progress: begun});
    const {garment, result, fabric, size} = question;
    // the mesh continues from its present positions
    const from = this.#drape === this.#known?.drape ? undefined : this.#drape;
    const settings: DrapeSettings = {fabric, ...(size && {size}), ...(from && {from})};
    let mesh: DrapeMesh | undefined;
    try {
      const drape = await this.#source.solver.drape(result, settings, {
        signal: running.signal,
        names: {result: garment.name},
        onForm: (form) => {
          this.#tellForm(form);
        },
        onMesh: (next) => {
          mesh = next;
        },
        onPositions: (positions) => {
          if (mesh) this.#tellMesh(mesh);
          this.#shown = garment;
          this.#tellPositions(positions, false);
        },
        onProgress: (progress) => {
          if (this.#running !== running) return;
          this.#state = {kind: 'draping', progress};
          this.changedOften();
        },
      });
      if (running.signal.aborted) return;
      this.#running = undefined;
      this.#kept = [...this.#kept, [question, drape] as const].slice(-most);
      this.#show(drape, garment);
    } catch (error) {
      if (running.signal.aborted) return;
      this.#running = undefined;
      if (this.#shown !== garment) this.#clear();
      this.#become({kind: 'failed', failure: toFailure(error)});
    }
  }

  #clear(): void {
    this.#drape = undefined;
    this.#form = undefined;
    this.#mesh = undefined;
    this.#positions = undefined;
    for (const viewer of this.#viewers) viewer.clear();
  }

  #tellForm(form: Form): void {
    this.#form = form;
    for (const viewer of this.#viewers) viewer.form(form);
  }

  #tellMesh(mesh: DrapeMesh): void {
    if (mesh === this.#mesh) return;
    this.#mesh = mesh;
    for (const viewer of this.#viewers) viewer.mesh(mesh);
  }

  #tellPositions(positions: Float32Array, isFinal: boolean): void {
    this.#positions = positions;
    for (const viewer of this.#viewers) viewer.positions(positions, isFinal);
  }
}

/** Returns whether two inputs give the same drape; the print may be aligned differently. */
const isSame = (one: Question, other: Question): boolean =>
  one.garment === other.garment &&
  one.fabric === other.fabric &&
  one.size === other.size &&
  (one.result === other.result || sameShapes(one.result, other.result));

const sameShapes = (one: SolveResult, other: SolveResult): boolean =>
  one.pieces.length === other.pieces.length &&
  one.pieces.every(
    ({rest, shape}, k) =>
      samePoints(rest, other.pieces[k]?.rest) && samePoints(shape, other.pieces[k]?.shape),
  );

const samePoints = (one: readonly Point[], other: readonly Point[] = []): boolean =>
  one.length === other.length &&
  one.every(([x, y], k) => {
    const [atX, atY] = other[k] ?? [];
    return x === atX && y === atY;
  });

const known = new WeakMap<Source, Drapes>();

/** Drapes of a workbench, created at the first call. */
export function drapesOf(workbench: Workbench): Drapes {
  const drapes = known.get(workbench) ?? new Drapes(workbench);
  known.set(workbench, drapes);
  return drapes;
}
