/** Layout settings as written on the command line and in jobs. Lengths in cm. */
import {markerLimits, type MarkerSettings} from '../../marker/settings.js';
import {naps, type Nap} from '../../model/result/marker-search.js';
import {fail, flag, number, oneOf, shape, wholeNumber, type Read} from '../../model/base/read.js';

/** Layout settings; missing ones have their defaults. */
export interface LayWish {
  /** Width of the fabric between its edges. */
  readonly width: number;
  readonly selvedge?: number;
  /** Distance from the left edge to an origin of the print; `any`, the default, tries several. */
  readonly phase?: number | 'any';
  /** Distance from the cut to an origin of the print. */
  readonly start?: number;
  readonly gap?: number;
  readonly allowance?: number;
  readonly hem?: number;
  /** Number of garments of each result; a list has one number for each of them. */
  readonly copies?: number | readonly number[];
  readonly plies?: number;
  readonly nap?: Nap;
  readonly shift?: (typeof shifts)[number];
  /** Folds the fabric lengthwise and cuts both plies at once. */
  readonly fold?: boolean;
  /** Ignores the print. */
  readonly free?: boolean;
  readonly effort?: number;
  readonly seed?: number;
}

export const shifts = ['kept', 'component'] as const;

/** Names of the settings that are lengths, and of those that are counts. */
export const layLengths = ['width', 'selvedge', 'start', 'gap', 'allowance', 'hem'] as const;
export const layCounts = ['plies', 'seed'] as const;

const limitsOf = {
  ...{width: markerLimits.widthCm, selvedge: markerLimits.selvedgeCm, gap: markerLimits.gapCm},
  ...{phase: markerLimits.phaseCm, start: markerLimits.startCm},
  ...{allowance: markerLimits.allowanceCm, hem: markerLimits.hemCm},
  ...{copies: markerLimits.copies, plies: markerLimits.plies, seed: markerLimits.seed},
  effort: markerLimits.effort,
};

/** The range of a length, a count or the effort. */
export const layRange = (name: keyof typeof limitsOf): readonly [number, number] => limitsOf[name];

const within = (name: keyof typeof limitsOf): Read<number> =>
  number(limitsOf[name][0], limitsOf[name][1]);

const phase: Read<number | 'any'> = (value, at) =>
  value === 'any'
    ? value
    : typeof value === 'number'
      ? within('phase')(value, at)
      : fail(at, "'any' or a length in cm");

export const layFields: Read<LayWish> = shape(
  {width: within('width')},
  {
    ...{selvedge: within('selvedge'), gap: within('gap'), phase, start: within('start')},
    ...{allowance: within('allowance'), hem: within('hem'), effort: within('effort')},
    ...{copies: wholeNumber, plies: wholeNumber, seed: wholeNumber},
    ...{nap: oneOf(naps), shift: oneOf(shifts), free: flag, fold: flag},
  },
);

const others = ['nap', 'shift', 'effort'] as const;

/** Converts the settings to those of the marker. */
export function laySettings(wish: LayWish): MarkerSettings {
  const {width, phase: place, free, fold, copies} = wish;
  const given = <K extends keyof LayWish>(names: readonly K[], named: (name: K) => string) =>
    Object.fromEntries(
      names.flatMap((name) => (wish[name] === undefined ? [] : [[named(name), wish[name]]])),
    );
  return {
    widthCm: width,
    ...given(layLengths, (name) => `${name}Cm`),
    ...given([...layCounts, ...others], (name) => name),
    ...(typeof place === 'number' && {phaseCm: place}),
    ...(typeof copies === 'number' && {copies}),
    ...(free === true && {ignoresPrint: true}),
    ...(fold === true && {fold}),
  };
}
