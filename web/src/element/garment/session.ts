/** One garment in one print, from its files to the answer: what the element shows, without the element. */
import type {Design} from '../../model/design.js';
import {SolverError} from '../../model/failure.js';
import type {SolveResult} from '../../model/result.js';
import {writeStoredDesign, type StoredDesign} from '../../model/stored-design.js';
import {FileError} from '../../model/versioned-file.js';
import type {LeasePlaces} from '../../solver/pool.js';
import {textsOf} from '../texts/texts.js';
import {newDesign} from '../workbench/samples.js';
import {toFailure} from '../workbench/latest-solve.js';
import type {Preferences} from '../workbench/preferences.js';
import {Workbench} from '../workbench/workbench.js';
import type {FileWords} from './files.js';
import type {GarmentEvents, GarmentState} from './events.js';
import {LastingSolver} from './lasting-solver.js';
import {problemFor, storedDesign, type Terms} from './problem.js';
import {restored} from './restored.js';
import {Sources, type Asked, type Loaded} from './sources.js';
import {Tiles} from './tiles.js';

/** Whoever has the session. */
export interface SessionOwner {
  readonly places: () => LeasePlaces;
  readonly emit: <K extends keyof GarmentEvents>(type: K, detail: GarmentEvents[K]) => void;
  /** State, result or design may be others than before. */
  readonly changed: () => void;
}

/** Why something is loaded. */
export interface LoadReason {
  /** What is to be restored of it. */
  readonly stored?: StoredDesign | undefined;
  readonly byUser?: boolean;
}

interface Waiting {
  readonly resolve: (result: SolveResult) => void;
  readonly reject: (reason: unknown) => void;
}

const states: Readonly<Record<Workbench['state']['kind'], GarmentState>> = {
  ...{opening: 'idle', empty: 'idle', stale: 'stale', solving: 'solving'},
  ...{done: 'ready', failed: 'error'},
};

export class GarmentSession {
  readonly desk: Workbench;
  readonly #owner: SessionOwner;
  readonly #lease: LastingSolver;
  readonly #sources = new Sources(() => this.#words);
  readonly #waiting = new Set<Waiting>();
  #loading: AbortController | undefined;
  /** Why the files could not be loaded. */
  #failure: SolverError | undefined;
  #last: {readonly asked: Asked; readonly loaded: Loaded} | undefined;
  #terms: Terms = {symmetry: 'auto', seed: 1};
  /** As the program has it; any other is the user's. */
  #given: Design | undefined;
  #isTouched = false;
  #wasSolving = false;
  #told = '';
  #selected: Workbench['selected'];

  constructor(owner: SessionOwner, preferences: Preferences) {
    this.#owner = owner;
    this.#lease = new LastingSolver(owner.places);
    const tiles = new Tiles(() => this.#words);
    this.desk = new Workbench(this.#lease, preferences, {
      problemOf: (design) => problemFor(design, this.#terms),
      tileOf: async (image, signal) => {
        try {
          return await tiles.tile(image, signal);
        } catch (error) {
          if (!signal?.aborted) this.report(asError(error));
          throw error;
        }
      },
    });
    this.desk.isEdited = false;
    this.desk.subscribe(() => {
      this.#follow();
    });
  }

  get state(): GarmentState {
    if (this.#loading) return 'loading';
    return this.#failure ? 'error' : states[this.desk.state.kind];
  }

  get error(): SolverError | undefined {
    const {state} = this.desk;
    if (this.#loading) return undefined;
    return this.#failure ?? (state.kind === 'failed' ? new SolverError(state.failure) : undefined);
  }

  get result(): SolveResult | undefined {
    return this.state === 'ready' ? this.desk.result : undefined;
  }

  get #words(): FileWords {
    const {language, messages} = this.desk.preferences;
    return textsOf(language, messages).garment;
  }

  /** Reads what is asked for, as far as it is new, and solves it. What the user has changed of the rest stays. */
  async load(asked: Asked, {stored, byUser = false}: LoadReason = {}): Promise<void> {
    this.#loading?.abort();
    const loading = new AbortController();
    this.#loading = loading;
    this.#failure = undefined;
    this.desk.cancel();
    if (!this.#last) this.#lease.warm(); // while the files are on their way
    this.#owner.changed();
    try {
      const loaded = await this.#sources.load(asked, loading.signal);
      if (loading.signal.aborted) return;
      const design = stored
        ? restored(loaded, stored, this.#words)
        : this.#designFor(asked, loaded);
      this.#loading = undefined;
      const symmetry = stored && typeof stored.symmetry === 'string' ? stored.symmetry : undefined;
      this.#terms = {
        symmetry: symmetry ?? loaded.symmetry,
        seed: stored?.seed ?? (this.#last ? this.#terms.seed : 1),
      };
      this.#last = {asked, loaded};
      this.#tellLoaded(loaded);
      this.#begin(design, byUser);
    } catch (error) {
      loading.abort(); // what else is being read is not needed any more
      if (this.#loading !== loading) return;
      this.#loading = undefined;
      this.#fail(asError(error));
    }
  }

  /** As the program gave it, without what the user has changed. */
  reset(): void {
    if (!this.#last || this.#loading) return;
    const {asked, loaded} = this.#last;
    this.#last = undefined;
    this.#terms = {symmetry: loaded.symmetry, seed: 1};
    const design = this.#designFor(asked, loaded);
    this.#last = {asked, loaded};
    this.#begin(design);
  }

  /** @returns whether there was anything to solve again */
  solveAgain(): boolean {
    if (this.#failure || !this.desk.design) return false;
    this.desk.align();
    return true;
  }

  /** The answer to what is asked for now, or to what takes its place before it is there. */
  answer(signal?: AbortSignal): Promise<SolveResult> {
    return new Promise((resolve, reject) => {
      const left = new AbortController();
      const waiting: Waiting = {
        resolve: (result) => {
          left.abort();
          resolve(result);
        },
        reject: (reason) => {
          left.abort();
          // eslint-disable-next-line @typescript-eslint/prefer-promise-reject-errors -- may be the caller's own
          reject(reason);
        },
      };
      this.#waiting.add(waiting);
      const abort = (): void => {
        this.#waiting.delete(waiting);
        waiting.reject(signal?.reason);
        if (this.#waiting.size === 0) this.cancel();
      };
      signal?.addEventListener('abort', abort, {once: true, signal: left.signal});
      this.#settle();
    });
  }

  /** Ends what is under way. What is shown stays. */
  cancel(): void {
    this.#loading?.abort();
    const wasLoading = this.#loading !== undefined;
    this.#loading = undefined;
    this.desk.cancel();
    const message = this.#words.cancelled;
    for (const {reject} of this.#taken()) reject(new DOMException(message, 'AbortError'));
    if (wasLoading) this.#owner.changed();
  }

  /** Gives back what others may need. The last answer is kept. @returns whether something was under way */
  pause(): boolean {
    const wasBusy = ['loading', 'solving'].includes(this.state);
    this.cancel();
    this.#lease.release();
    return wasBusy;
  }

  /** @throws {SolverError} with one sentence when there is nothing to store, or no place to name */
  stored(): StoredDesign & {readonly format: string} {
    const {design, result} = this.desk;
    if (this.state !== 'ready' || !design || !result) {
      throw new SolverError({code: 'options', message: this.#words.noAnswer});
    }
    const stored = storedDesign(design, result, this.#terms, this.#words);
    return JSON.parse(writeStoredDesign(stored)) as StoredDesign & {readonly format: string};
  }

  /** Says something that keeps nothing from going on. */
  report(error: SolverError): void {
    const {code, message, piece, seam} = error;
    this.#owner.emit('error', {code, message, piece, seam});
  }

  #designFor({maxChangeCm, symmetry}: Asked, loaded: Loaded): Design {
    const {garment, print, symmetries} = loaded;
    const [before, now] = [this.#last, this.desk.design];
    const fresh = newDesign(garment, print);
    const isSameGarment = before?.loaded.garment === garment;
    const kept = now && before ? now : fresh;
    const {pins, ...options} = isSameGarment || !before ? kept.options : fresh.options;
    const most = before?.asked.maxChangeCm === maxChangeCm ? options.maxChangeCm : maxChangeCm;
    const placed = pins ?? pinsFor(garment.text, kept.options.pins);
    return {
      garment,
      print: before?.loaded.print === print ? kept.print : print,
      symmetries:
        isSameGarment && before.asked.symmetry === symmetry ? kept.symmetries : symmetries,
      method: kept.method,
      options: {
        ...options,
        ...(most !== undefined && {maxChangeCm: most}),
        ...(placed && {pins: placed}),
      },
    };
  }

  #begin(design: Design, byUser = false): void {
    this.#given = design;
    this.#isTouched = byUser;
    this.#wasSolving = false;
    this.desk.begin({past: [], present: {design, view: null}, future: []});
  }

  #fail(error: SolverError): void {
    this.#failure = error;
    this.report(error);
    this.#owner.changed();
    this.#settle();
  }

  /** The workbench has changed: by a program, by its user, or by an answer. */
  #follow(): void {
    const {desk} = this;
    const {state, design, result} = desk;
    if (design !== this.#given) {
      this.#given = design;
      this.#isTouched = true;
    }
    this.#owner.changed();
    if (state.kind === 'solving') {
      this.#wasSolving = true;
      this.#tellProgress(state);
    } else if (this.#wasSolving) {
      this.#wasSolving = false;
      if (state.kind === 'failed') this.report(new SolverError(state.failure));
      if (state.kind === 'done' && result) {
        const {metrics} = result;
        this.#owner.emit('solve', {metrics, milliseconds: metrics.milliseconds.total});
      }
    }
    if (this.state === 'ready' && this.#isTouched) {
      this.#isTouched = false;
      this.#owner.emit('change', {design: this.#storable()});
    }
    this.#tellSelected();
    this.#settle();
  }

  #tellLoaded({garment, print}: Loaded): void {
    this.#owner.emit('load', {
      garment: {name: garment.name, url: garment.file?.url ?? null},
      print: {name: print.title, url: print.file?.place?.url ?? null},
    });
  }

  #storable(): StoredDesign | null {
    try {
      return this.stored();
    } catch {
      return null;
    }
  }

  #tellProgress({
    phase,
    fraction,
  }: {
    phase: GarmentEvents['progress']['phase'];
    fraction: number;
  }): void {
    const told = `${phase} ${fraction}`;
    if (told === this.#told) return;
    this.#told = told;
    this.#owner.emit('progress', {phase, fraction});
  }

  #tellSelected(): void {
    const {selected, pattern} = this.desk;
    if (selected === this.#selected) return;
    this.#selected = selected;
    const pieceAt = (k: number): string | null => pattern?.pieces[k]?.name ?? null;
    if (!selected) {
      this.#owner.emit('select', {kind: 'none', piece: null, seam: null});
    } else if (selected.kind === 'piece') {
      this.#owner.emit('select', {kind: 'piece', piece: pieceAt(selected.piece), seam: null});
    } else {
      const {seam, side} = selected;
      const piece = pieceAt(pattern?.seams[seam]?.[side].piece ?? -1);
      this.#owner.emit('select', {kind: 'seam', piece, seam});
    }
  }

  /** Everybody who waits hears what there is to be heard. */
  #settle(): void {
    const {state, result, error} = this;
    if (state === 'ready' && result) for (const {resolve} of this.#taken()) resolve(result);
    else if (state === 'error') for (const {reject} of this.#taken()) reject(error);
    else if (this.desk.state.kind === 'stale' && this.desk.state.cancelled && state === 'stale') {
      const message = this.#words.cancelled;
      for (const {reject} of this.#taken()) reject(new DOMException(message, 'AbortError'));
    }
  }

  #taken(): readonly Waiting[] {
    const all = [...this.#waiting];
    this.#waiting.clear();
    return all;
  }
}

/** Of the pieces that another size of a garment still has, the prints stay where they were put. */
function pinsFor(
  text: string,
  pins: Design['options']['pins'],
): Design['options']['pins'] | undefined {
  if (!pins) return undefined;
  const kept = Object.entries(pins).filter(([name]) => text.includes(JSON.stringify(name)));
  return kept.length > 0 ? Object.fromEntries(kept) : undefined;
}

/** As the one kind of error that the element knows. */
export function asError(error: unknown): SolverError {
  if (error instanceof SolverError) return error;
  if (error instanceof FileError) return new SolverError({code: 'options', message: error.message});
  return new SolverError(toFailure(error));
}
