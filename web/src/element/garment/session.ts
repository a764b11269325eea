/**
 * One garment in one print, from its files to the answer: the element's logic without the element.
 */
import {fabricOf, type Design} from '../../model/design/design.js';
import {begun} from '../../model/design/history.js';
import type {FabricName} from '../../model/result/draped-garment.js';
import {SolverError, type Failure} from '../../model/base/failure.js';
import type {SolveResult} from '../../model/result/result.js';
import {writeStoredDesign, type StoredDesign} from '../../model/documents/stored-design.js';
import {LastingSolver, type LeasePlaces} from '../../solver/pool.js';
import {textsOf, type Texts} from '../../texts/texts.js';
import {lastOf} from '../../model/base/last-of.js';
import type {Preferences} from '../../texts/preferences.js';
import {spokenError} from '../../workbench/spoken-failure.js';
import {Workbench, type SolveState} from '../../workbench/workbench.js';
import {Announcer, asError, type Emit} from './emitted-events.js';
import type {GarmentState} from './events.js';
import {Sources, type Asked, type FileWords, type Loaded} from './sources.js';
import {nextDesign, restored, storedDesign, type Answered, type ReadGarments} from './designs.js';
import {Tiles} from './tiles.js';

/** Owner of the session. */
interface SessionOwner {
  readonly places: () => LeasePlaces;
  readonly emit: Emit;
  /** State, result or design may have changed. */
  readonly changed: () => void;
}

/** Reason of a load. */
export interface LoadReason {
  /** Stored design to be restored. */
  readonly stored?: StoredDesign | undefined;
  readonly byUser?: boolean;
}

const states: Readonly<Record<SolveState['kind'], GarmentState>> = {
  ...{opening: 'idle', empty: 'idle', stale: 'stale', solving: 'solving'},
  ...{done: 'ready', failed: 'error'},
};

/**
 * Parts of the workbench that affect state, errors and events; errors use the sheet's names of
 * pieces.
 */
const heard = ['history', 'solving', 'running', 'selection', 'sheet', 'preferences'] as const;

export class GarmentSession {
  readonly workbench: Workbench;
  readonly #owner: SessionOwner;
  readonly #tell: Announcer;
  readonly #lease: LastingSolver;
  readonly #sources = new Sources(() => this.#words);
  /**
   * Cached: each change of the workbench requests it, and it needs the SHA-256 of the whole result.
   */
  readonly #storedText = lastOf((design: Design, result: SolveResult) =>
    writeStoredDesign(storedDesign(design, result, this.#words)),
  );
  readonly #waiting = new Waiting<SolveResult>();
  #loading: AbortController | undefined;
  /** Error of the last load. */
  #failure: SolverError | undefined;
  /** The request has changed, and no load is running. */
  #isOutdated = false;
  #last: Answered | undefined;
  /** Design set by the program; any other is the user's. */
  #given: Design | undefined;
  #isTouched = false;
  /** Last design reported during a drag. */
  #told: Design | undefined;

  constructor(owner: SessionOwner, preferences: Preferences) {
    this.#owner = owner;
    this.#tell = new Announcer(owner.emit, this.#spoken);
    this.#lease = new LastingSolver(owner.places);
    const tiles = new Tiles(
      () => this.#texts,
      (error) => {
        this.report(error);
      },
    );
    this.workbench = new Workbench(this.#lease, preferences, {
      tileOf: (image, signal) => tiles.tile(image, signal),
      progress: (progress) => {
        this.#tell.progress(progress);
      },
    });
    this.workbench.solving.isEdited = false;
    this.workbench.subscribe(heard, () => {
      this.#follow();
    });
  }

  get state(): GarmentState {
    if (this.#loading) return 'loading';
    if (this.#isOutdated) return this.workbench.history.design ? 'stale' : 'idle';
    return this.#failure ? 'error' : states[this.workbench.solving.state.kind];
  }

  get error(): SolverError | undefined {
    if (this.state !== 'error') return undefined;
    const {state} = this.workbench.solving;
    return this.#failure ?? (state.kind === 'failed' ? this.#spoken(state.failure) : undefined);
  }

  get result(): SolveResult | undefined {
    return this.state === 'ready' ? this.workbench.solving.result : undefined;
  }

  /** Returns whether a promise of an answer is still pending. */
  get isAwaited(): boolean {
    return !this.#waiting.isEmpty;
  }

  get #texts(): Texts {
    const {language, messages} = this.workbench.preferences.chosen;
    return textsOf(language, messages);
  }

  readonly #spoken = (failure: Failure): SolverError =>
    spokenError(failure, this.workbench, this.#texts);

  get #words(): FileWords {
    return this.#texts.garment;
  }

  /** Marks the request as changed; a load follows. */
  outdate(): void {
    this.#isOutdated = true;
    this.#owner.changed();
  }

  /**
   * Reads the new parts of a request and solves it. The user's other changes stay.
   * @returns true if the files were read, and no other request has replaced this one
   */
  async load(asked: Asked, {stored, byUser = false}: LoadReason = {}): Promise<boolean> {
    this.#loading?.abort();
    const loading = new AbortController();
    this.#loading = loading;
    this.#failure = undefined;
    this.#isOutdated = false;
    this.workbench.solving.cancel();
    if (!this.#last) this.#lease.warm(); // the solver starts while the files load
    this.#owner.changed();
    try {
      const loaded = await this.#sources.load(asked, loading.signal);
      const read = stored ? {} : await this.#readFor(loaded);
      if (loading.signal.aborted) return false;
      const answered = {asked, loaded};
      const design = stored
        ? restored(loaded, stored, this.#words)
        : nextDesign(answered, this.#last, this.workbench.history.design, read);
      this.#tell.loaded(loaded);
      if (this.#loading !== loading) return false; // an event listener has changed the request
      this.#loading = undefined;
      this.#last = answered;
      this.#begin(design, {byUser, isGiven: stored !== undefined});
      return true;
    } catch (error) {
      loading.abort(); // stops the remaining downloads
      if (this.#loading === loading) {
        this.#loading = undefined;
        this.#fail(asError(error));
      }
      return false;
    }
  }

  /**
   * Returns the documents that decide which pins stay on another garment. A document that cannot be
   * read causes an error in the solve, with its reason.
   */
  async #readFor({garment}: Loaded): Promise<ReadGarments> {
    const {design} = this.workbench.history;
    const {garment: before} = this.workbench.solving;
    if (!design?.options.pins || this.#last?.loaded.garment === garment) return {};
    return {before, next: await this.workbench.solving.documentOf(garment).catch(() => undefined)};
  }

  /** Sets the fabric of the current design's drape; this reads and solves nothing. */
  set fabric(fabric: FabricName) {
    const {design} = this.workbench.history;
    if (this.#last) this.#last = {...this.#last, asked: {...this.#last.asked, fabric}};
    if (!design || fabricOf(design) === fabric) return;
    this.workbench.history.change({fabric});
    this.#given = this.workbench.history.design;
  }

  /** Restores the program's design, without the user's changes. */
  reset(): void {
    const last = this.#last;
    this.#last = undefined; // the next design keeps nothing of it, even if it is loaded later
    if (!last || this.#loading || this.#isOutdated || this.#failure) return;
    this.#last = last;
    this.#begin(nextDesign(last, undefined, undefined));
  }

  /** @returns true if there was a design to solve again */
  solveAgain(): boolean {
    if (this.#failure || this.#isOutdated || !this.workbench.history.design) return false;
    this.workbench.solving.align();
    return true;
  }

  /**
   * Returns the answer to the current request, or to the one that replaces it meanwhile.
   * @param left called when the last waiting caller has left
   */
  answer(signal: AbortSignal | undefined, left: () => void): Promise<SolveResult> {
    const answer = this.#waiting.join(signal, () => {
      if (this.#waiting.isEmpty) left();
    });
    this.#follow(); // the workbench reports an answer slightly after it has one
    return answer;
  }

  /** Ends running work. The shown result stays. */
  cancel(): void {
    this.#loading?.abort();
    const wasLoading = this.#loading !== undefined;
    this.#isOutdated ||= wasLoading;
    this.#loading = undefined;
    this.workbench.solving.cancel();
    this.#waiting.reject(new DOMException(this.#words.cancelled, 'AbortError'));
    if (wasLoading) this.#owner.changed();
  }

  /** Releases shared resources; the last answer is kept. @returns whether work was running */
  pause(): boolean {
    const wasBusy = ['loading', 'solving'].includes(this.state);
    this.cancel();
    this.#lease.release();
    return wasBusy;
  }

  /**
   * @throws {SolverError} if there is no answer, or a file has no URL to store; the message is one
   * sentence
   */
  stored(): StoredDesign & {readonly format: string} {
    const {design} = this.workbench.history;
    const {result} = this.workbench.solving;
    if (this.state !== 'ready' || !design || !result) {
      throw new SolverError({code: 'options', message: this.#words.noAnswer});
    }
    const text = this.#storedText(design, result);
    return JSON.parse(text) as StoredDesign & {readonly format: string};
  }

  /** Reports an error that does not stop the session. */
  report(error: SolverError): void {
    this.#tell.failed(error);
  }

  #begin(design: Design, {byUser = false, isGiven = false} = {}): void {
    this.#given = design;
    this.#isTouched = byUser;
    this.workbench.history.begin(begun({design, view: null, isGiven}));
  }

  #fail(error: SolverError): void {
    this.#failure = error;
    this.report(error);
    this.#owner.changed();
    this.#settle();
  }

  /** Called after each change of the workbench: by a program, by its user, or by an answer. */
  #follow(): void {
    const {workbench} = this;
    if (workbench.history.design !== this.#given) {
      this.#given = workbench.history.design;
      this.#isTouched = true;
    }
    this.#owner.changed();
    // an outdated answer is not reported
    if (!this.#loading && !this.#isOutdated) this.#tell.solved(workbench);
    if (this.state === 'ready' && this.#isTouched) this.#tellOfUser();
    this.#tell.selected(workbench);
    this.#settle();
  }

  /** Reports one `change` for a whole drag, and `input` meanwhile. */
  #tellOfUser(): void {
    const {isHeld, design} = this.workbench.history;
    if (isHeld && design === this.#told) return;
    this.#told = isHeld ? design : undefined;
    this.#isTouched = isHeld;
    this.#owner.emit(isHeld ? 'input' : 'change', {design: this.#storable()});
  }

  #storable(): StoredDesign | null {
    try {
      return this.stored();
    } catch {
      return null; // given as objects
    }
  }

  /** Settles the promises of all waiting callers, if the state allows. */
  #settle(): void {
    const {state, result, error} = this;
    if (state === 'ready' && result) this.#waiting.resolve(result);
    else if (state === 'error') this.#waiting.reject(error);
    else if (
      state === 'stale' &&
      this.workbench.solving.state.kind === 'stale' &&
      !this.#isOutdated
    ) {
      this.#waiting.reject(new DOMException(this.#words.cancelled, 'AbortError'));
    }
  }
}

/** Callers that wait for the same answer. */
interface Waiter<T> {
  readonly resolve: (answer: T) => void;
  readonly reject: (reason: unknown) => void;
}

class Waiting<T> {
  readonly #all = new Set<Waiter<T>>();

  get isEmpty(): boolean {
    return this.#all.size === 0;
  }

  /**
   * Settles with the other callers, or when `signal` fires: with its reason.
   * @param left called when the signal fires
   */
  join(signal: AbortSignal | undefined, left: () => void): Promise<T> {
    return new Promise((resolve, reject) => {
      const listening = new AbortController();
      const waiter: Waiter<T> = {
        resolve: (answer) => {
          listening.abort();
          resolve(answer);
        },
        reject: (reason) => {
          listening.abort();
          // eslint-disable-next-line @typescript-eslint/prefer-promise-reject-errors -- may be the caller's own
          reject(reason);
        },
      };
      this.#all.add(waiter);
      const leave = (): void => {
        this.#all.delete(waiter);
        waiter.reject(signal?.reason);
        left();
      };
      signal?.addEventListener('abort', leave, {once: true, signal: listening.signal});
    });
  }

  resolve(answer: T): void {
    for (const waiter of this.#taken()) waiter.resolve(answer);
  }

  reject(reason: unknown): void {
    for (const waiter of this.#taken()) waiter.reject(reason);
  }

  #taken(): readonly Waiter<T>[] {
    const all = [...this.#all];
    this.#all.clear();
    return all;
  }
}
