/** How pieces are to lie on cloth, as people write it: on the command line, and in jobs. Lengths in cm. */
import {markerLimits, type MarkerSettings} from '../../marker/settings.js';
import {naps, type Nap} from '../../model/marker.js';
import {fail, flag, number, oneOf, shape, wholeNumber, type Read} from '../../model/read.js';

/** What a maker chooses; as usual, where it is left out. */
export interface LayWish {
  /** Of the cloth, between its edges. */
  readonly width: number;
  readonly selvedge?: number;
  /** From the left edge to an origin of the print; several are tried of `any`, which is usual. */
  readonly phase?: number | 'any';
  /** From the cut to an origin of the print. */
  readonly start?: number;
  readonly gap?: number;
  readonly allowance?: number;
  readonly hem?: number;
  readonly copies?: number;
  readonly plies?: number;
  readonly nap?: Nap;
  readonly shift?: (typeof shifts)[number];
  /** Lengthwise, and cut through both plies. */
  readonly fold?: boolean;
  /** Whatever the print. */
  readonly free?: boolean;
  readonly effort?: number;
  readonly seed?: number;
}

export const shifts = ['kept', 'component'] as const;

/** Those that are lengths, and those that are counted. */
export const layLengths = ['width', 'selvedge', 'start', 'gap', 'allowance', 'hem'] as const;
export const layCounts = ['copies', 'plies', 'seed'] as const;

const limitsOf = {
  ...{width: markerLimits.widthCm, selvedge: markerLimits.selvedgeCm, gap: markerLimits.gapCm},
  ...{phase: markerLimits.phaseCm, start: markerLimits.startCm},
  ...{allowance: markerLimits.allowanceCm, hem: markerLimits.hemCm},
  ...{copies: markerLimits.copies, plies: markerLimits.plies, seed: markerLimits.seed},
  effort: markerLimits.effort,
};

/** What a length, a number or the effort may be. */
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

/** The same, as pieces are laid by it. */
export function laySettings(wish: LayWish): MarkerSettings {
  const {width, phase: place, free, fold} = wish;
  const given = <K extends keyof LayWish>(names: readonly K[], named: (name: K) => string) =>
    Object.fromEntries(
      names.flatMap((name) => (wish[name] === undefined ? [] : [[named(name), wish[name]]])),
    );
  return {
    widthCm: width,
    ...given(layLengths, (name) => `${name}Cm`),
    ...given([...layCounts, ...others], (name) => name),
    ...(typeof place === 'number' && {phaseCm: place}),
    ...(free === true && {ignoresPrint: true}),
    ...(fold === true && {fold}),
  };
}
