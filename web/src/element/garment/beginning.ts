/** When an element begins: not before it is near or asked, and once for all changes of one task. */
import type {GarmentSession, LoadReason} from './session.js';
import type {Asked} from './sources.js';

/** So far from what is visible of the page it begins. */
const rootMargin = '200px';

/** What the element says for itself. */
export interface Beginner {
  readonly element: Element;
  readonly isEager: () => boolean;
  /** Undefined where garment or print are missing. */
  readonly asked: () => Asked | undefined;
}

export class Beginning {
  readonly #beginner: Beginner;
  readonly #session: GarmentSession;
  #near: IntersectionObserver | undefined;
  /** Seen, or asked for. */
  #isWanted = false;
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
    this.#isWanted = true;
    if (this.#isDue) this.#begin();
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
    if (this.#isWanted || this.#beginner.isEager()) {
      this.#isWanted = true;
      return;
    }
    this.#near = new IntersectionObserver(
      (entries) => {
        if (!entries.some(({isIntersecting}) => isIntersecting)) return;
        this.unwatch();
        this.#isWanted = true;
        this.schedule();
      },
      {rootMargin},
    );
    this.#near.observe(this.#beginner.element);
  }

  unwatch(): void {
    this.#near?.disconnect();
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
