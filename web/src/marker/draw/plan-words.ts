/** Figures of a layout as text. */
import type {Point} from '../../model/geometry/vectors.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import {readable} from '../../model/garment/piece-names.js';
import {fractionOrNumber, formatLength, type Units} from '../../model/base/length-text.js';
import {layCosts} from '../../model/result/pinned-plan.js';
import {saidNote, type NoteFormat} from './note-texts.js';
import {plan as english, type PlanTexts} from '../../texts/en/plan.js';

export interface PlanWordsOptions {
  readonly units: Units;
  /** Locale of numbers. Default 'en'. */
  readonly locale?: string;
  /** Texts in another language. Default English. */
  readonly texts?: PlanTexts;
}

export interface PlanWords {
  readonly texts: PlanTexts;
  readonly units: Units;
  /** A length with its unit, for example "12.3 cm" or "4 7/8 in". */
  readonly length: (cm: number) => string;
  /**
   * A length for tables, without its unit, to a tenth of a millimetre or a hundredth of an inch.
   */
  readonly place: (cm: number) => string;
  /** A length for tables, without its unit, to a millimetre or a hundredth of an inch. */
  readonly short: (cm: number) => string;
  readonly unit: string;
  readonly share: (share: number) => string;
  /** A length of fabric rounded up to the step that shops cut, and that step. */
  readonly bought: (cm: number) => {readonly length: string; readonly step: string};
}

const cmPerInch = 2.54;
/** Step of lengths that shops cut. [cm] */
const shopStep = 5;
/** Steps per yard that shops cut. */
const yardParts = 8;
const cmPerYard = 36 * cmPerInch;
/** Tolerance, in steps, for the rounding of summed lengths. */
const rounding = 1e-6;

/** Number of steps that reach at least a length. */
const roundedUp = (cm: number, step: number): number => Math.ceil(cm / step - rounding);

export function planWords({units, locale = 'en', texts = english}: PlanWordsOptions): PlanWords {
  const length = (cm: number): string => formatLength(cm, units, locale);
  const number = (value: number, least: number, most = least): string =>
    value.toLocaleString(locale, {minimumFractionDigits: least, maximumFractionDigits: most});
  const own = units === 'inch' ? cmPerInch : 1;
  return {
    ...{texts, units, length},
    unit: units === 'inch' ? 'in' : 'cm',
    place: (cm) => number(cm / own, 2),
    short: (cm) => number(cm / own, 0, units === 'inch' ? 2 : 1),
    share: (share) => texts.share(number(100 * share, 1)),
    bought: (cm) =>
      units === 'inch'
        ? {
            length: `${fractionOrNumber(roundedUp(cm, cmPerYard / yardParts) / yardParts, 3)} yd`,
            step: `1/${yardParts} yd`,
          }
        : {
            length: `${number((roundedUp(cm, shopStep) * shopStep) / 100, 2)} m`,
            step: `${shopStep} cm`,
          },
  };
}

/** A figure with its caption above and its note below. */
export interface Figure {
  readonly caption: string;
  readonly value: string;
  readonly note: string;
}

/** The main figures of a layout. An incomplete layout has no length to buy. */
export function figuresOf(plan: LayPlan, words: PlanWords): readonly Figure[] {
  const {lengthCm, boundCm, proven, useShare, widthCm, unplaced} = plan;
  const {texts, length, share, bought} = words;
  const fabric = bought(lengthCm);
  const use = {caption: texts.use, value: share(useShare), note: texts.ofWidth(length(widthCm))};
  const used = {caption: texts.length, value: length(lengthCm)};
  if (unplaced.length > 0) return [{...used, note: texts.lying}, use];
  return [
    {...used, note: proven ? texts.proven : texts.atBest(length(boundCm))},
    {caption: texts.buy, value: fabric.length, note: texts.roundedUp(fabric.step)},
    use,
    ...costOf(plan, words),
  ];
}

function costOf(plan: LayPlan, {texts, length}: PlanWords): readonly Figure[] {
  const {printOrigin, freeLengthCm} = plan;
  const {printCm} = layCosts(plan);
  if (!printOrigin || freeLengthCm === null || printCm === undefined) return [];
  const note = texts.without(length(freeLengthCm));
  return [{caption: texts.cost, value: length(printCm), note}];
}

/**
 * Facts about the layout, one sentence each.
 * @param ring a corner of the print's repeat; undefined if the layout ignores the print
 */
export function factsOf(
  plan: LayPlan,
  {texts, length}: PlanWords,
  {
    printName,
    ring,
    nameOf,
  }: {
    readonly printName: string;
    readonly ring: Point | undefined;
    readonly nameOf: (piece: LayPlan['unplaced'][number]) => string;
  },
): readonly string[] {
  const {widthCm, selvedgeCm, gapCm, allowanceCm, foldCm, unplaced, noteDetails} = plan;
  const {pinsCm = 0} = layCosts(plan);
  const [width, selvedge, gap, allowance] = [widthCm, selvedgeCm, gapCm, allowanceCm].map(length);
  const fabric = [width ?? '', selvedge ?? '', gap ?? '', allowance ?? ''] as const;
  const format: NoteFormat = {
    ...{length, rounded: length, count: String, name: readable},
    range: (least, most) => [length(least), length(most)],
  };
  return [
    foldCm === undefined ? texts.fabric(...fabric) : texts.folded(...fabric, length(foldCm)),
    ring ? texts.print(printName, length(ring[0]), length(ring[1])) : texts.plain,
    ...(unplaced.length > 0 ? [texts.unplaced(unplaced.map(nameOf).join(', '))] : []),
    ...(pinsCm > rounding ? [texts.pinned(length(pinsCm))] : []),
    ...noteDetails.map((note) => saidNote(note, texts.notes, format)),
  ];
}
