/** How somebody wants to cut, remembered by the browser. */
import {fieldOf} from '../../model/read.js';
import type {Units} from '../../model/units.js';
import type {CutFileKind} from '../../paper/cut-file.js';

export const cutFileKinds: readonly CutFileKind[] = ['pdf', 'svg', 'dxf', 'plt'];

/** Those that have a name, by it: home printers' first. */
export const papers: readonly string[] = [
  ...['a4', 'letter', 'a3', 'legal', 'tabloid', 'a2', 'a1', 'a0', '36in', 'projector'],
];

export interface CutChoices {
  readonly file: CutFileKind;
  /** By its name in `paper/papers`. */
  readonly paper: string;
  /** [cm] */
  readonly allowanceCm: number;
  readonly hemCm: number;
  /** `full`: pieces in their print; `outline`: their lines alone. */
  readonly ink: 'full' | 'outline';
}

/** More than any hem. [cm] */
export const greatestAllowance = 10;

const key = 'seamwise.cut';

/** What most patterns have, in centimetres or in inches that are on a ruler. */
const usual: Readonly<Record<Units, CutChoices>> = {
  cm: {file: 'pdf', paper: 'a4', allowanceCm: 1, hemCm: 3, ink: 'full'},
  inch: {file: 'pdf', paper: 'letter', allowanceCm: 0.375 * 2.54, hemCm: 1.25 * 2.54, ink: 'full'},
};

const isLength = (value: unknown): boolean =>
  typeof value === 'number' && value >= 0 && value <= greatestAllowance;

/** What was chosen last, as far as it is understood; the rest as it is usual. */
export function storedChoices(units: Units): CutChoices {
  const isRight: {readonly [Name in keyof CutChoices]: (value: unknown) => boolean} = {
    file: (value) => (cutFileKinds as readonly unknown[]).includes(value),
    paper: (value) => (papers as readonly unknown[]).includes(value),
    allowanceCm: isLength,
    hemCm: isLength,
    ink: (value) => value === 'full' || value === 'outline',
  };
  try {
    const stored: unknown = JSON.parse(localStorage.getItem(key) ?? '{}');
    const known = Object.entries(isRight)
      .map(([name, right]) => [name, fieldOf(stored, name), right] as const)
      .filter(([, value, right]) => right(value));
    return {...usual[units], ...Object.fromEntries(known.map(([name, value]) => [name, value]))};
  } catch {
    return usual[units]; // nothing can be stored here, or something else was
  }
}

/** What is as it is usual is not stored: it follows the units. */
export function keepChoices(choices: CutChoices, units: Units): void {
  const chosen = Object.entries(choices).filter(
    ([name, value]) => value !== usual[units][name as keyof CutChoices],
  );
  try {
    localStorage.setItem(key, JSON.stringify(Object.fromEntries(chosen)));
  } catch {
    // a browser that stores nothing still makes the file
  }
}
