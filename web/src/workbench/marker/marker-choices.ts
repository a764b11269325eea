/**
 * The user's choices about the fabric of a print and the distances of pieces, stored with the
 * preferences.
 */
import type {DesignPrint} from '../../model/design/design.js';
import {fieldOf} from '../../model/base/read.js';
import type {ChosenAllowances, Preferences} from '../../texts/preferences.js';
import {greatestAllowance} from '../../cutting/allowance-rule.js';
import {allowancesIn, withAllowances} from '../allowances.js';

/** Choices that are stored with the print. */
interface KeptChoices {
  /** Width between the edges of the fabric. [cm] */
  readonly widthCm: number;
  /** Width of the strip along each edge in which nothing is cut. [cm] */
  readonly selvedgeCm: number;
  /** Distance between pieces. [cm] */
  readonly gapCm: number;
  /** True if all pieces have their heads the same way, as nap and one-way prints require. */
  readonly isOneWay: boolean;
  /** Distance of the print's origin from the left edge; null until it is measured. [cm] */
  readonly phaseCm: number | null;
  /** Price of a metre, or of a yard if lengths are in inches, in any currency; 0 if unknown. */
  readonly price: number;
}

export interface MarkerChoices extends KeptChoices, ChosenAllowances {}

/** Widths in which fabric is sold. [cm] */
export const usualWidths: readonly number[] = [90, 110, 115, 140, 150, 160];

/** Limits of every choice. [cm, and currency for the price] */
export const fabricLimits = {
  widthCm: [20, 400],
  selvedgeCm: [0, 10],
  gapCm: [0, 5],
  phaseCm: [0, 400],
  allowanceCm: [0, greatestAllowance],
  hemCm: [0, greatestAllowance],
  price: [0, 10_000],
} as const;

const usual: KeptChoices = {
  widthCm: 140,
  selvedgeCm: 1,
  gapCm: 0.2,
  isOneWay: false,
  phaseCm: null,
  price: 0,
};

/** Number of stored prints; the oldest one is dropped first. */
const most = 40;

/** Name of a print in the stored preferences. */
const nameOf = ({sample, title}: DesignPrint): string => sample?.name ?? title;

const isLength = (value: unknown, [least, greatest]: readonly [number, number]): boolean =>
  typeof value === 'number' && value >= least && value <= greatest;

const isRight: {readonly [Name in keyof KeptChoices]: (value: unknown) => boolean} = {
  widthCm: (value) => isLength(value, fabricLimits.widthCm),
  selvedgeCm: (value) => isLength(value, fabricLimits.selvedgeCm),
  gapCm: (value) => isLength(value, fabricLimits.gapCm),
  isOneWay: (value) => typeof value === 'boolean',
  phaseCm: (value) => value === null || isLength(value, fabricLimits.phaseCm),
  price: (value) => isLength(value, fabricLimits.price),
};

/**
 * Last choices for a print, as far as they are valid. Otherwise, width and gap are those of the
 * last fabric, and the rest is as usual.
 */
export function storedFabric(print: DesignPrint, preferences: Preferences): MarkerChoices {
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
    ...{...usual, ...allowancesIn(preferences)},
    ...known(['widthCm', 'gapCm'], all.at(-1)?.[1]),
    ...known(['widthCm', 'selvedgeCm', 'gapCm', 'isOneWay', 'phaseCm', 'price'], own),
  };
}

/** Preferences with these choices. */
export function withFabric(
  print: DesignPrint,
  {widthCm, selvedgeCm, gapCm, isOneWay, phaseCm, price, ...rest}: MarkerChoices,
  preferences: Preferences,
): Pick<Preferences, 'cloths' | 'allowances'> {
  const name = nameOf(print);
  const others = Object.entries(preferences.cloths ?? {}).filter(([one]) => one !== name);
  const kept: KeptChoices = {widthCm, selvedgeCm, gapCm, isOneWay, phaseCm, price};
  return {
    ...withAllowances(rest, preferences),
    cloths: Object.fromEntries([...others, [name, kept] as const].slice(-most)),
  };
}
