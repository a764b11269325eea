/** When an element begins: not before it is near or asked, and once for all changes of one task. */
import type {GarmentSession, LoadReason} from './session.js';
import type {Asked} from './sources.js';

/** So far from what is visible of the page it begins. */
const rootMargin = '200px';

/** What the element says for itself. */
interface Beginner {
  readonly element: Element;
  readonly isEager: () => boolean;
  /** Undefined where garment or print are missing. */
  readonly asked: () => Asked | undefined;
  /** It has something to show from now on. */
  readonly begun: () => void;
}

export class Beginning {
  readonly #beginner: Beginner;
  readonly #session: GarmentSession;
  #near: IntersectionObserver | undefined;
  /** It is near, or was, or has no need to be: it begins by itself. */
  #isSeen = false;
  /** Seen, or asked for. */
  #isWanted = false;
  #hasBegun = false;
  #isDue = false;
  #reason: LoadReason = {};
  #isScheduled = false;

  constructor(beginner: Beginner, session: GarmentSession) {
    this.#beginner = beginner;
    this.#session = session;
  }

  /** Something is asked for that has not been begun. */
  get isDue(): boolean {
    return this.#isDue;
  }

  /** Before that it is not worth loading anything for. */
  get hasBegun(): boolean {
    return this.#hasBegun;
  }

  /** Something else is asked for, for another reason than before. */
  ask(reason: LoadReason = {}): void {
    this.#isDue = true;
    this.#reason = reason;
    this.#session.outdate();
    this.schedule();
  }

  /** What was under way is to be begun again. */
  askAgain(): void {
    this.#isDue = true;
  }

  /** Begins what is due, seen or not. */
  now(): void {
    this.#want();
    if (this.#isDue) this.#begin();
  }

  /** Nobody waits any more. What it would not do by itself ends, until it is near. */
  abandon(): void {
    if (this.#isSeen && this.#beginner.element.isConnected) return;
    this.#isWanted = this.#isSeen;
    if (this.#session.pause()) this.#isDue = true;
  }

  schedule(): void {
    if (this.#isScheduled) return;
    this.#isScheduled = true;
    queueMicrotask(() => {
      this.#isScheduled = false;
      const isHere = this.#beginner.element.isConnected || this.#session.isAwaited;
      if (this.#isWanted && this.#isDue && isHere) this.#begin();
    });
  }

  /** Begins when it is near; an eager one, or one that has begun before, at once. */
  watch(): void {
    this.unwatch();
    if (this.#isSeen || this.#beginner.isEager()) {
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
    this.#near.observe(this.#beginner.element);
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
    this.#beginner.begun();
  }

  #begin(): void {
    const asked = this.#beginner.asked();
    if (!asked) {
      this.#session.cancel();
      return;
    }
    this.#isDue = false;
    void this.#load(asked, this.#reason);
  }

  /** What was cut short is begun again for the same reason. */
  async #load(asked: Asked, reason: LoadReason): Promise<void> {
    const isLoaded = await this.#session.load(asked, reason);
    if (isLoaded && this.#reason === reason) this.#reason = {};
  }
}
