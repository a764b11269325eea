/**
 * Decides when an element starts a request: once it is near or requested, and once for all changes
 * of one task.
 */
import type {GarmentSession, LoadReason} from './session.js';
import type {Asked} from './sources.js';
import {SolverError} from '../../model/base/failure.js';
import type {SolveResult} from '../../model/result/result.js';

/** Distance outside the visible page within which it starts. */
const rootMargin = '200px';

/** State of the element that decides about the start. */
interface RequestOwner {
  readonly element: Element;
  readonly isEager: () => boolean;
  /** Undefined if the garment or the print is missing. */
  readonly asked: () => Asked | undefined;
  /** Called at the start: there is something to show from now on. */
  readonly begun: () => void;
  /** Message for a request without garment or print. */
  readonly noGarment: () => string;
}

export class RequestScheduler {
  readonly #owner: RequestOwner;
  readonly #session: GarmentSession;
  #near: IntersectionObserver | undefined;
  /** It starts automatically: it is or was near, or it is eager. */
  #isSeen = false;
  /** It was near, or the page has requested it. */
  #isWanted = false;
  #hasBegun = false;
  #isDue = false;
  #reason: LoadReason = {};
  #isScheduled = false;

  constructor(owner: RequestOwner, session: GarmentSession) {
    this.#owner = owner;
    this.#session = session;
  }

  /** Returns whether the current request has not started. */
  get isDue(): boolean {
    return this.#isDue;
  }

  /** Nothing has to be loaded for the element before that. */
  get hasBegun(): boolean {
    return this.#hasBegun;
  }

  /** Sets a new request, for another reason than before. */
  ask(reason: LoadReason = {}): void {
    this.#isDue = true;
    this.#reason = reason;
    this.#session.outdate();
    this.schedule();
  }

  /** Marks an interrupted request to be started again. */
  askAgain(): void {
    this.#isDue = true;
  }

  /** Starts the current request, near or not, unless it is running or answered. */
  start(): void {
    const {state} = this.#session;
    const isStuck = state === 'idle' || state === 'error' || state === 'stale';
    if (isStuck && !this.#isDue && !this.#session.solveAgain()) this.#isDue = true;
    this.#want();
    if (this.#isDue) this.#begin();
  }

  /**
   * Starts the current request, and returns its answer.
   * @throws the errors of the element's `solve`
   */
  async answer(signal: AbortSignal | undefined): Promise<SolveResult> {
    const isMissing = this.#owner.asked() === undefined;
    if (isMissing && (this.#session.state === 'idle' || this.#isDue)) {
      throw new SolverError({code: 'notAGarment', message: this.#owner.noGarment()});
    }
    this.start();
    return this.#session.answer(signal, () => {
      this.#abandon();
    });
  }

  /**
   * Called when the last caller has left. Ends work that would not have started automatically,
   * until the element is near.
   */
  #abandon(): void {
    if (this.#isSeen && this.#owner.element.isConnected) return;
    this.#isWanted = this.#isSeen;
    if (this.#session.pause()) this.#isDue = true;
  }

  schedule(): void {
    if (this.#isScheduled) return;
    this.#isScheduled = true;
    queueMicrotask(() => {
      this.#isScheduled = false;
      const isHere = this.#owner.element.isConnected || this.#session.isAwaited;
      if (this.#isWanted && this.#isDue && isHere) this.#begin();
    });
  }

  /** Starts when the element is near; at once if it is eager or was near before. */
  watch(): void {
    this.unwatch();
    if (this.#isSeen || this.#owner.isEager()) {
      this.#see();
      return;
    }
    this.#near = new IntersectionObserver(
      (entries) => {
        if (!entries.some(({isIntersecting}) => isIntersecting)) return;
        this.unwatch();
        this.#see();
        this.schedule();
      },
      {rootMargin},
    );
    this.#near.observe(this.#owner.element);
  }

  unwatch(): void {
    this.#near?.disconnect();
  }

  #see(): void {
    this.#isSeen = true;
    this.#want();
  }

  #want(): void {
    this.#isWanted = true;
    if (this.#hasBegun) return;
    this.#hasBegun = true;
    this.#owner.begun();
  }

  #begin(): void {
    const asked = this.#owner.asked();
    if (!asked) {
      this.#session.cancel();
      return;
    }
    this.#isDue = false;
    void this.#load(asked, this.#reason);
  }

  /** Keeps the reason of an interrupted load for the next one. */
  async #load(asked: Asked, reason: LoadReason): Promise<void> {
    const isLoaded = await this.#session.load(asked, reason);
    if (isLoaded && this.#reason === reason) this.#reason = {};
  }
}
