/** The latest answers, so that undo and redo show theirs at once. */
import type {Design} from '../../model/design.js';
import type {MeshedPattern, SolveResult} from '../../model/result.js';

export interface Answer {
  readonly pattern: MeshedPattern;
  readonly result: SolveResult;
}

/** An answer takes some megabytes. */
const most = 8;

/** Designs are known by identity: a step that is taken back and again holds the same one. */
export class ResultCache {
  readonly #answers = new Map<Design, Answer>();

  of(design: Design): Answer | undefined {
    return this.#answers.get(design);
  }

  keep(design: Design, answer: Answer): void {
    this.#answers.delete(design);
    this.#answers.set(design, answer);
    const [oldest] = this.#answers.keys();
    if (this.#answers.size > most && oldest) this.#answers.delete(oldest);
  }
}
