/** The latest results, so that undo and redo show theirs at once. */
import type {Design, DesignPrint} from '../model/design/design.js';
import type {MeshedPattern, SolveResult} from '../model/result/result.js';

interface Answer {
  readonly pattern: MeshedPattern;
  readonly result: SolveResult;
}

/** Usual number of stored results; each takes some megabytes. */
const usualMost = 8;

/** Fields that a result depends on. A piece may be renamed without a new result. */
export const askedFields = ['garment', 'print', 'symmetry', 'method', 'options', 'seed'] as const;

/** Fields of a print that no answer depends on. */
const unasked = ['own', 'isPrinted'] as const;

/** Returns whether two prints differ in no fields but these; values are compared by identity. */
export function samePrint(
  one: DesignPrint,
  other: DesignPrint,
  except: readonly (keyof DesignPrint)[] = [],
): boolean {
  if (one === other) return true;
  const ignored = new Set<string>([...unasked, ...except]);
  const fields = Object.keys({...one, ...other}) as (keyof DesignPrint)[];
  return fields.every((field) => ignored.has(field) || one[field] === other[field]);
}

/** Compares by identity: a step that is undone and redone has the same objects. */
const asksSame = (one: Design, other: Design): boolean =>
  askedFields.every((field) =>
    field === 'print' ? samePrint(one.print, other.print) : one[field] === other[field],
  );

export class ResultCache<T = Answer> {
  /** Stored results, the oldest first. */
  #answers: readonly (readonly [Design, T])[] = [];
  readonly #most: number;

  constructor(most = usualMost) {
    this.#most = most;
  }

  of(design: Design): T | undefined {
    return this.#answers.find(([known]) => asksSame(known, design))?.[1];
  }

  keep(design: Design, answer: T): void {
    const others = this.#answers.filter(([known]) => !asksSame(known, design));
    this.#answers = [...others, [design, answer] as const].slice(-this.#most);
  }
}
