/** Settings of the cutting sheet, stored by the browser. */
import {allowancesIn, withAllowances} from '../../workbench/allowances.js';
import type {ChosenAllowances} from '../../texts/preferences.js';
import type {Workbench} from '../../workbench/workbench.js';
import {fieldOf} from '../../model/base/read.js';
import {dxfStyles, dxfUnits, type DxfStyle, type DxfUnit} from '../../model/base/dxf-format.js';
import type {Units} from '../../model/base/length-text.js';
import {printInks, type PrintInk} from '../../cutting/print-ink.js';
import type {CutFileKind} from '../../paper/cut-file.js';

export const cutFileKinds: readonly CutFileKind[] = ['pdf', 'svg', 'dxf', 'plt'];

/** Named papers by their names, those of home printers first. */
export const papers: readonly string[] = [
  ...['a4', 'letter', 'a3', 'legal', 'tabloid', 'a2', 'a1', 'a0', '36in', 'projector'],
];

interface FileChoices {
  readonly file: CutFileKind;
  /** Name in `paper/papers`. */
  readonly paper: string;
  readonly ink: PrintInk;
  /** Adds a placing guide to a PDF. */
  readonly guide: boolean;
  readonly dxfStyle: DxfStyle;
  readonly dxfUnit: DxfUnit;
}

/** The fabric layout uses the same allowances. */
export interface CutChoices extends FileChoices, ChosenAllowances {}

const key = 'seamwise.cut';

const usual: Readonly<Record<Units, FileChoices>> = {
  cm: {file: 'pdf', paper: 'a4', ink: 'full', guide: false, dxfStyle: 'aama', dxfUnit: 'mm'},
  inch: {file: 'pdf', paper: 'letter', ink: 'full', guide: false, dxfStyle: 'aama', dxfUnit: 'mm'},
};

const isRight: {readonly [Name in keyof FileChoices]: (value: unknown) => boolean} = {
  file: (value) => (cutFileKinds as readonly unknown[]).includes(value),
  paper: (value) => (papers as readonly unknown[]).includes(value),
  guide: (value) => typeof value === 'boolean',
  ink: (value) => (printInks as readonly unknown[]).includes(value),
  dxfStyle: (value) => (dxfStyles as readonly unknown[]).includes(value),
  dxfUnit: (value) => (dxfUnits as readonly unknown[]).includes(value),
};

function storedFileChoices(units: Units): FileChoices {
  try {
    const stored: unknown = JSON.parse(localStorage.getItem(key) ?? '{}');
    const known = Object.entries(isRight)
      .map(([name, right]) => [name, fieldOf(stored, name), right] as const)
      .filter(([, value, right]) => right(value));
    return {...usual[units], ...Object.fromEntries(known.map(([name, value]) => [name, value]))};
  } catch {
    return usual[units]; // no storage here, or other content in it
  }
}

/** Returns the last settings; unknown or missing ones have their defaults. */
export const storedChoices = ({preferences: {chosen}}: Workbench): CutChoices => ({
  ...storedFileChoices(chosen.units),
  ...allowancesIn(chosen),
});

/** Stores the settings except defaults, which follow the units. */
export function keepChoices(choices: CutChoices, workbench: Workbench): void {
  const {units} = workbench.preferences.chosen;
  const {file, paper, ink, guide, dxfStyle, dxfUnit} = choices;
  const chosen = Object.entries({file, paper, ink, guide, dxfStyle, dxfUnit}).filter(
    ([name, value]) => value !== usual[units][name as keyof FileChoices],
  );
  try {
    localStorage.setItem(key, JSON.stringify(Object.fromEntries(chosen)));
  } catch {
    // the file can still be made without storage
  }
  workbench.prefer(withAllowances(choices, workbench.preferences.chosen));
}
