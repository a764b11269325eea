/** What work in the background has in common: the newest takes the place of the one before, and learns of designs. */
import type {Design} from '../model/design.js';

/** At most one piece of work at a time. */
export class NewestTask {
  #running: AbortController | undefined;

  /** Ends the one before. @returns what ends this one */
  begin(): AbortController {
    this.stop();
    return (this.#running = new AbortController());
  }

  stop(): void {
    this.#running?.abort();
    this.#running = undefined;
  }
}

/** What was found out about designs, for as long as somebody holds them. */
export class DesignFindings<Finding> {
  readonly #known = new WeakMap<Design, Finding>();
  readonly #finished = new WeakSet<Design>();
  readonly #changed: () => void;

  /** @param changed told of everything that is news */
  constructor(changed: () => void) {
    this.#changed = changed;
  }

  of(design: Design): Finding | undefined {
    return this.#known.get(design);
  }

  learn(design: Design, finding: Finding, isNews = true): void {
    this.#known.set(design, finding);
    if (isNews) this.#changed();
  }

  /** Nothing more is to be found out about it. */
  finish(design: Design): void {
    this.#finished.add(design);
  }

  isFinished(design: Design): boolean {
    return this.#finished.has(design);
  }
}
