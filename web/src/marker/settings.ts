/** What is asked of a layout on cloth, and what of it cannot be. Lengths in cm. */
import {SolverError} from '../model/failure.js';
import type {Point} from '../model/geometry.js';
import {naps, type Nap} from '../model/marker.js';
import {signedArea} from '../model/polyline.js';
import {selfCrossing} from './outline.js';

export interface MarkerSettings {
  /** Of the cloth, between its edges. */
  readonly widthCm: number;
  /** Along each edge, of no use. Default 1. */
  readonly selvedgeCm?: number;
  /** Between pieces. Default 0.2. */
  readonly gapCm?: number;
  /** How many garments of each result. Default 1. */
  readonly copies?: number;
  /** From the left edge to an origin of the print; by default several are tried, and the best is taken. */
  readonly phaseCm?: number;
  /** From the cut to an origin of the print; by default the cloth is cut anywhere. */
  readonly startCm?: number;
  /** Around the pieces, where the garment gives an edge none of its own. Default 1. */
  readonly allowanceCm?: number;
  /** Of hems, where the garment gives them none. Default `allowanceCm` if that is given, else 3. */
  readonly hemCm?: number;
  /** Which pieces lie the same way up. Default: all for a print with an upside, else none. */
  readonly nap?: Nap;
  /** `component`: the print may move under pieces that no seam matches with others, where it fits as well. Default `kept`. */
  readonly shift?: 'kept' | 'component';
  /** How many layers of cloth are cut at once; of several, each is as long as whole repeats. Default 1. */
  readonly plies?: number;
  /** Polygons of the cloth on which no piece may lie. */
  readonly flaws?: readonly (readonly Point[])[];
  /** Whether the cloth is folded lengthwise, and both plies are cut at once: for pieces with mirror images. Default false. */
  readonly fold?: boolean;
  /** Lays pieces wherever they fit, whatever the print. Default false. */
  readonly ignoresPrint?: boolean;
  /** How much the repeat on the bolt may be longer or shorter than told, as a share. Default 0. */
  readonly repeatTolerance?: number;
  /** Of other cloths to lay on, quickly. Default: those that are sold. */
  readonly widthsCm?: readonly number[];
  /** How long to look, from 1, the default, which is about a second; 0 for a first layout. */
  readonly effort?: number;
  /** The same seed, the same layout. Default 1. */
  readonly seed?: number;
}

/** Cloth is sold this wide. */
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

/** What numbers may be. */
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

/** With what is left out as it usually is. @throws {SolverError} for what cannot be */
export function checkedSettings(asked: MarkerSettings): Given {
  const settings: Given = {...usual, ...asked};
  const {widthCm, selvedgeCm, phaseCm, nap, widthsCm, shift} = settings;
  checkNumbers(settings);
  checkFlaws(settings.flaws);
  if (!(widthCm > 2 * selvedgeCm)) {
    throw wrong(
      widthCm === 0
        ? 'The cloth is 0 cm wide; give its width between its edges.'
        : `Between selvedges of ${selvedgeCm} cm nothing is left of cloth that is ${widthCm} cm wide; give its width between its edges.`,
    );
  }
  if (phaseCm !== undefined && phaseCm > widthCm) {
    throw wrong(
      `The print starts ${phaseCm} cm from the left edge, beyond the cloth, which is ${widthCm} cm wide; measure to a motif on the cloth.`,
    );
  }
  if (nap !== undefined && !naps.includes(nap)) {
    throw wrong(`nap is ${JSON.stringify(nap)}, but must be one of ${naps.join(', ')}.`);
  }
  if (!['kept', 'component'].includes(shift)) {
    throw wrong(`shift is ${JSON.stringify(shift)}, but must be one of kept, component.`);
  }
  const narrow = widthsCm.find((width) => !(width > 0 && width <= markerLimits.widthCm[1]));
  if (narrow !== undefined) {
    throw wrong(`widthsCm holds ${String(narrow)}, but widths of cloth are up to 1000 cm.`);
  }
  return settings;
}
