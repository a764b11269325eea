/** Settings of a layout, and their checks. Lengths in cm. */
import {SolverError} from '../model/base/failure.js';
import {shown} from '../model/base/read.js';
import type {Point} from '../model/geometry/vectors.js';
import {naps, type Nap} from '../model/result/marker-search.js';
import {signedArea} from '../model/geometry/polyline.js';
import {selfCrossing} from './cut-rings.js';

export interface MarkerSettings {
  /** Width of the fabric between its edges. */
  readonly widthCm: number;
  /** Width of the unusable strip along each edge. Default 1. */
  readonly selvedgeCm?: number;
  /** Least distance between pieces. Default 0.2. */
  readonly gapCm?: number;
  /** Number of garments of each result that has no number of its own. Default 1. */
  readonly copies?: number;
  /**
   * Distance from the left edge to an origin of the print. By default several are tried and the
   * best is used.
   */
  readonly phaseCm?: number;
  /** Distance from the cut to an origin of the print. By default the cut may be anywhere. */
  readonly startCm?: number;
  /** Seam allowance of edges without their own in the garment. Default 1. */
  readonly allowanceCm?: number;
  /**
   * Allowance of hems without their own in the garment. Default: `allowanceCm` if given, otherwise
   * 3.
   */
  readonly hemCm?: number;
  /** Pieces that keep the same way up. Default: all for a one-way print, otherwise none. */
  readonly nap?: Nap;
  /**
   * `component`: the print may move under pieces that no seam matches with others, to equally good
   * positions. Default `kept`.
   */
  readonly shift?: 'kept' | 'component';
  /**
   * Number of layers cut at once. With several, each is a whole number of repeats long. Default 1.
   */
  readonly plies?: number;
  /** Polygons of the fabric on which no piece may lie. */
  readonly flaws?: readonly (readonly Point[])[];
  /**
   * Folds the fabric lengthwise and cuts both plies at once, for pieces with mirror images. Default
   * false.
   */
  readonly fold?: boolean;
  /** Ignores the print in the layout. Default false. */
  readonly ignoresPrint?: boolean;
  /** Greatest deviation of the fabric's repeat from the given one, as a share. Default 0. */
  readonly repeatTolerance?: number;
  /** Other fabric widths to try quickly. Default: usual widths. */
  readonly widthsCm?: readonly number[];
  /** Search effort: 1, the default, takes about a second; 0 stops at the first layout. */
  readonly effort?: number;
  /** Random seed; the same seed gives the same layout. Default 1. */
  readonly seed?: number;
}

/** Usual widths of fabric. [cm] */
const usualWidths: readonly number[] = [90, 110, 115, 140, 150, 160];

type Usual = Required<
  Omit<MarkerSettings, 'widthCm' | 'phaseCm' | 'startCm' | 'allowanceCm' | 'hemCm' | 'nap'>
>;

const usual: Usual = {
  ...{selvedgeCm: 1, gapCm: 0.2, copies: 1, plies: 1, effort: 1, seed: 1},
  ...{repeatTolerance: 0, ignoresPrint: false, flaws: [], fold: false},
  ...{shift: 'kept', widthsCm: usualWidths},
};

type Given = MarkerSettings & Usual;

/** Least and greatest values of the numeric settings. */
export const markerLimits = {
  widthCm: [0, 1000],
  selvedgeCm: [0, 100],
  gapCm: [0, 20],
  copies: [1, 100],
  phaseCm: [0, 1000],
  startCm: [0, 1000],
  allowanceCm: [0, 10],
  hemCm: [0, 10],
  plies: [1, 1000],
  repeatTolerance: [0, 0.1],
  effort: [0, 1000],
  seed: [0, 0xffffffff],
} as const satisfies Partial<Record<keyof MarkerSettings, readonly [number, number]>>;

const whole: readonly string[] = ['copies', 'plies', 'seed'];

const wrong = (message: string): SolverError => new SolverError({code: 'options', message});

function checkNumbers(settings: Given): void {
  for (const [name, [least, most]] of Object.entries(markerLimits)) {
    const value = settings[name as keyof typeof markerLimits];
    if (value === undefined) continue;
    const isWhole = whole.includes(name);
    if (value >= least && value <= most && (!isWhole || Number.isInteger(value))) continue;
    throw wrong(
      `${name} is ${String(value)}, but must be a ${isWhole ? 'whole ' : ''}number from ${least} to ${most}.`,
    );
  }
}

function checkFlaws(flaws: Given['flaws']): void {
  for (const [k, flaw] of flaws.entries()) {
    const isPolygon =
      flaw.length >= 3 && flaw.flat().every(Number.isFinite) && Math.abs(signedArea(flaw)) > 0;
    if (isPolygon && !selfCrossing(flaw)) continue;
    throw wrong(
      isPolygon
        ? `The line around flaw ${k + 1} crosses itself; give its points in order around it.`
        : `Flaw ${k + 1} is no polygon; give at least three points that are not in a row, x from the left edge and y from the cut, in cm.`,
    );
  }
}

/**
 * Checks settings and adds defaults.
 * @throws {SolverError} for invalid settings
 */
export function checkedSettings(asked: MarkerSettings): Given {
  const given = Object.entries(asked).filter(([, value]) => value !== undefined);
  const settings: Given = {...usual, ...(Object.fromEntries(given) as MarkerSettings)};
  const {widthCm, selvedgeCm, phaseCm, nap, widthsCm, shift} = settings;
  checkNumbers(settings);
  checkFlaws(settings.flaws);
  if (!(widthCm > 2 * selvedgeCm)) {
    throw wrong(
      widthCm === 0
        ? 'The fabric is 0 cm wide; give its width between its edges.'
        : `Between selvedges of ${selvedgeCm} cm nothing is left of fabric that is ${widthCm} cm wide; give its width between its edges.`,
    );
  }
  if (phaseCm !== undefined && phaseCm > widthCm) {
    throw wrong(
      `The print starts ${phaseCm} cm from the left edge, beyond the fabric, which is ${widthCm} cm wide; measure to a motif on the fabric.`,
    );
  }
  if (nap !== undefined && !naps.includes(nap)) {
    throw wrong(`nap is ${shown(nap)}, but must be one of ${naps.join(', ')}.`);
  }
  if (!['kept', 'component'].includes(shift)) {
    throw wrong(`shift is ${shown(shift)}, but must be one of kept, component.`);
  }
  const narrow = widthsCm.find((width) => !(width > 0 && width <= markerLimits.widthCm[1]));
  if (narrow !== undefined) {
    throw wrong(`widthsCm holds ${String(narrow)}, but widths of fabric are up to 1000 cm.`);
  }
  return settings;
}
