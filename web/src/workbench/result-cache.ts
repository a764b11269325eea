/** The latest results, so that undo and redo show theirs at once. */
import type {Design} from '../model/design/design.js';
import type {MeshedPattern, SolveResult} from '../model/result/result.js';

interface Answer {
  readonly pattern: MeshedPattern;
  readonly result: SolveResult;
}

/** Number of stored results; each takes some megabytes. */
const most = 8;

/** Fields that a result depends on. A piece may be renamed without a new result. */
export const askedFields = ['garment', 'print', 'symmetry', 'method', 'options', 'seed'] as const;

/** Compares by identity: a step that is undone and redone has the same objects. */
const asksSame = (one: Design, other: Design): boolean =>
  askedFields.every((field) => one[field] === other[field]);

export class ResultCache {
  /** Stored results, the oldest first. */
  #answers: readonly (readonly [Design, Answer])[] = [];

  of(design: Design): Answer | undefined {
    return this.#answers.find(([known]) => asksSame(known, design))?.[1];
  }

  keep(design: Design, answer: Answer): void {
    const others = this.#answers.filter(([known]) => !asksSame(known, design));
    this.#answers = [...others, [design, answer] as const].slice(-most);
  }
}
