/** What somebody has said of the cloth that a print is on, and of how pieces keep apart: remembered by the browser. */
import type {DesignPrint} from '../model/design.js';
import {fieldOf} from '../model/read.js';

export interface ClothChoices {
  /** Between its edges. [cm] */
  readonly widthCm: number;
  /** Along each edge, where nothing is cut. [cm] */
  readonly selvedgeCm: number;
  /** Between pieces. [cm] */
  readonly gapCm: number;
  /** All pieces lie with their heads the same way, as nap and one-way prints ask. */
  readonly isOneWay: boolean;
  /** Of the print's origin from the left edge; null where nobody has measured it. [cm] */
  readonly phaseCm: number | null;
}

/** As cloth is sold. [cm] */
export const usualWidths: readonly number[] = [90, 110, 115, 140, 150, 160];

/** Of each length. [cm] */
export const clothLimits = {
  widthCm: [20, 400],
  selvedgeCm: [0, 10],
  gapCm: [0, 5],
  phaseCm: [0, 400],
} as const;

const usual: ClothChoices = {
  widthCm: 140,
  selvedgeCm: 1,
  gapCm: 0.2,
  isOneWay: false,
  phaseCm: null,
};

const key = 'seamwise.cloth';
/** Prints that are remembered; the oldest is forgotten first. */
const most = 40;

/** What a print is known by from one visit to the next. */
const nameOf = ({sample, title}: DesignPrint): string => sample?.name ?? title;

const isLength = (value: unknown, [least, greatest]: readonly [number, number]): boolean =>
  typeof value === 'number' && value >= least && value <= greatest;

const isRight: {readonly [Name in keyof ClothChoices]: (value: unknown) => boolean} = {
  widthCm: (value) => isLength(value, clothLimits.widthCm),
  selvedgeCm: (value) => isLength(value, clothLimits.selvedgeCm),
  gapCm: (value) => isLength(value, clothLimits.gapCm),
  isOneWay: (value) => typeof value === 'boolean',
  phaseCm: (value) => value === null || isLength(value, clothLimits.phaseCm),
};

function allStored(): readonly (readonly [name: string, choices: unknown])[] {
  try {
    const stored: unknown = JSON.parse(localStorage.getItem(key) ?? '{}');
    return typeof stored === 'object' && stored !== null ? Object.entries(stored) : [];
  } catch {
    return []; // nothing can be stored here, or something else was
  }
}

/** What was chosen last for a print, as far as it is understood; else the width of the cloth before, and the rest as it is usual. */
export function storedCloth(print: DesignPrint): ClothChoices {
  const all = allStored();
  const own = all.find(([name]) => name === nameOf(print))?.[1];
  const known = (names: readonly (keyof ClothChoices)[], from: unknown): Partial<ClothChoices> =>
    Object.fromEntries(
      names.flatMap((name) => {
        const value = fieldOf(from, name);
        return isRight[name](value) ? [[name, value]] : [];
      }),
    );
  return {
    ...usual,
    ...known(['widthCm', 'gapCm'], all.at(-1)?.[1]),
    ...known(['widthCm', 'selvedgeCm', 'gapCm', 'isOneWay', 'phaseCm'], own),
  };
}

/** The newest comes last. */
export function keepCloth(print: DesignPrint, choices: ClothChoices): void {
  const name = nameOf(print);
  const others = allStored().filter(([one]) => one !== name);
  try {
    const kept = [...others, [name, choices] as const].slice(-most);
    localStorage.setItem(key, JSON.stringify(Object.fromEntries(kept)));
  } catch {
    // a browser that stores nothing still lays the pieces
  }
}
