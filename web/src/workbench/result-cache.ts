/** The latest answers, so that undo and redo show theirs at once. */
import type {Design} from '../model/design.js';
import type {MeshedPattern, SolveResult} from '../model/result.js';

interface Answer {
  readonly pattern: MeshedPattern;
  readonly result: SolveResult;
}

/** An answer takes some megabytes. */
const most = 8;

/** What an answer depends on: a piece may be renamed without another one. */
export const askedFields = ['garment', 'print', 'symmetry', 'method', 'options', 'seed'] as const;

/** Known by identity: a step that is taken back and again holds the same objects. */
const asksSame = (one: Design, other: Design): boolean =>
  askedFields.every((field) => one[field] === other[field]);

export class ResultCache {
  /** The oldest first. */
  #answers: readonly (readonly [Design, Answer])[] = [];

  of(design: Design): Answer | undefined {
    return this.#answers.find(([known]) => asksSame(known, design))?.[1];
  }

  keep(design: Design, answer: Answer): void {
    const others = this.#answers.filter(([known]) => !asksSame(known, design));
    this.#answers = [...others, [design, answer] as const].slice(-most);
  }
}
