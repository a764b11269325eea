/**
 * Common parts of background work: the newest task replaces the one before, and stores findings
 * about designs.
 */
import type {Design} from '../model/design/design.js';

/** Runs at most one task at a time. */
export class NewestTask {
  #running: AbortController | undefined;

  /** Begins a task and ends the one before. @returns the controller that ends this one */
  begin(): AbortController {
    this.stop();
    return (this.#running = new AbortController());
  }

  stop(): void {
    this.#running?.abort();
    this.#running = undefined;
  }
}

/** Findings about designs, kept as long as the designs are in use. */
export class DesignFindings<Finding> {
  readonly #known = new WeakMap<Design, Finding>();
  readonly #finished = new WeakSet<Design>();
  readonly #changed: () => void;

  /** @param changed called for every new finding */
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

  /** Marks a design as completely examined. */
  finish(design: Design): void {
    this.#finished.add(design);
  }

  isFinished(design: Design): boolean {
    return this.#finished.has(design);
  }
}
