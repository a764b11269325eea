/** What somebody has said of the cloth that a print is on, and of how pieces keep apart: remembered with their preferences. */
import type {DesignPrint} from '../model/design.js';
import {fieldOf} from '../model/read.js';
import type {ChosenAllowances, Preferences} from '../texts/preferences.js';
import {allowancesIn, greatestAllowance, withAllowances} from './allowances.js';

/** As it is remembered with the print. */
interface KeptChoices {
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

export interface ClothChoices extends KeptChoices, ChosenAllowances {
  /** How many garments are cut from it. */
  readonly copies: number;
}

/** As cloth is sold. [cm] */
export const usualWidths: readonly number[] = [90, 110, 115, 140, 150, 160];

/** Of each length. [cm] */
export const clothLimits = {
  widthCm: [20, 400],
  selvedgeCm: [0, 10],
  gapCm: [0, 5],
  phaseCm: [0, 400],
  allowanceCm: [0, greatestAllowance],
  hemCm: [0, greatestAllowance],
  copies: [1, 20],
} as const;

const usual: KeptChoices = {
  widthCm: 140,
  selvedgeCm: 1,
  gapCm: 0.2,
  isOneWay: false,
  phaseCm: null,
};

/** Prints that are remembered; the oldest is forgotten first. */
const most = 40;

/** What a print is known by from one visit to the next. */
const nameOf = ({sample, title}: DesignPrint): string => sample?.name ?? title;

const isLength = (value: unknown, [least, greatest]: readonly [number, number]): boolean =>
  typeof value === 'number' && value >= least && value <= greatest;

const isRight: {readonly [Name in keyof KeptChoices]: (value: unknown) => boolean} = {
  widthCm: (value) => isLength(value, clothLimits.widthCm),
  selvedgeCm: (value) => isLength(value, clothLimits.selvedgeCm),
  gapCm: (value) => isLength(value, clothLimits.gapCm),
  isOneWay: (value) => typeof value === 'boolean',
  phaseCm: (value) => value === null || isLength(value, clothLimits.phaseCm),
};

/** What was chosen last for a print, as far as it is understood; else the width of the cloth before, and the rest as it is usual. */
export function storedCloth(print: DesignPrint, preferences: Preferences): ClothChoices {
  const all = Object.entries(preferences.cloths ?? {});
  const own = all.find(([name]) => name === nameOf(print))?.[1];
  const known = (names: readonly (keyof KeptChoices)[], from: unknown): Partial<KeptChoices> =>
    Object.fromEntries(
      names.flatMap((name) => {
        const value = fieldOf(from, name);
        return isRight[name](value) ? [[name, value]] : [];
      }),
    );
  return {
    ...{...usual, copies: 1, ...allowancesIn(preferences)},
    ...known(['widthCm', 'gapCm'], all.at(-1)?.[1]),
    ...known(['widthCm', 'selvedgeCm', 'gapCm', 'isOneWay', 'phaseCm'], own),
  };
}

/** What is to be remembered. */
export function withCloth(
  print: DesignPrint,
  {widthCm, selvedgeCm, gapCm, isOneWay, phaseCm, ...rest}: ClothChoices,
  preferences: Preferences,
): Pick<Preferences, 'cloths' | 'allowances'> {
  const name = nameOf(print);
  const others = Object.entries(preferences.cloths ?? {}).filter(([one]) => one !== name);
  const kept: KeptChoices = {widthCm, selvedgeCm, gapCm, isOneWay, phaseCm};
  return {
    ...withAllowances(rest, preferences),
    cloths: Object.fromEntries([...others, [name, kept] as const].slice(-most)),
  };
}
