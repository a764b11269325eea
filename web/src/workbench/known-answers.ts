/**
 * Figures of answers to designs that differ only in their seed, and in size and turn of the print.
 * They are small, so that a search that was stopped continues where it ended.
 */
import type {Design} from '../model/design/design.js';
import type {Standing} from '../model/result/visible-seams.js';
import {samePrint} from './result-cache.js';

/** A design, and how its answer compares. */
export interface Candidate {
  readonly design: Design;
  readonly standing: Standing;
}

interface Family {
  readonly first: Design;
  readonly known: Map<string, Candidate>;
}

/** Number of families that are kept. */
const most = 8;

/** Digits of a length or an angle. */
const digits = 9;

const keyOf = ({print: {size, turnDeg}, seed}: Design): string =>
  [size.width, size.height, size.angleDeg, turnDeg, seed]
    .map((value) => value.toPrecision(digits))
    .join(' ');

const isOf = ({first}: Family, design: Design): boolean =>
  (['garment', 'symmetry', 'method', 'options'] as const).every(
    (field) => first[field] === design[field],
  ) && samePrint(first.print, design.print, ['size', 'turnDeg']);

export class KnownAnswers {
  /** The oldest first. */
  #families: readonly Family[] = [];

  of(design: Design): Candidate | undefined {
    return this.#familyOf(design)?.known.get(keyOf(design));
  }

  /** All known answers to designs of the same family. */
  all(design: Design): readonly Candidate[] {
    return [...(this.#familyOf(design)?.known.values() ?? [])];
  }

  /** The seed with which the family began. */
  firstSeed(design: Design): number {
    return (this.#familyOf(design)?.first ?? design).seed;
  }

  keep(design: Design, standing: Standing): void {
    const family = this.#familyOf(design) ?? {first: design, known: new Map<string, Candidate>()};
    family.known.set(keyOf(design), {design, standing});
    const others = this.#families.filter((one) => one !== family);
    this.#families = [...others, family].slice(-most);
  }

  #familyOf(design: Design): Family | undefined {
    return this.#families.find((family) => isOf(family, design));
  }
}
