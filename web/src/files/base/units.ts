/**
 * Determines the unit of a drawing: the stated one if the size is wearable, otherwise one that
 * makes it wearable.
 */
import type {UnitGuess} from '../../model/garment/imported-drawing.js';
import {unitsInMetre, type FileUnit} from '../../model/garment/garment-document.js';

/** Usual size of a garment's largest piece. [cm] */
const usual = {low: 25, high: 220};

/** Possible size of the largest piece, even for a doll or a giant. [cm] */
const possible = {low: 3, high: 500};

const inCm = (unit: FileUnit): number => 100 / unitsInMetre[unit];

export const cmPer = inCm;

const isWithin = (
  largest: number,
  {low, high}: {readonly low: number; readonly high: number},
): boolean => largest >= low && largest <= high;

/** Units of patterns, the most likely first. */
const drawnIn: readonly FileUnit[] = ['mm', 'cm', 'inch', 'm'];

const likely = (largest: number, units: readonly FileUnit[]): FileUnit[] =>
  units.filter((unit) => isWithin(largest * inCm(unit), usual));

/** Usual pixels per inch of programs. */
export const densities = [72, 90, 96, 150, 200, 300, 600] as const;

/** Millimetres per unit of paper, as drawings name them. */
export const paperUnits: Readonly<Record<string, number>> = {
  ...{mm: 1, cm: 10, m: 1000, in: 25.4, pt: 25.4 / 72, pc: 25.4 / 6, q: 0.25},
};

interface UnitHints {
  /** The longer side of the largest piece, in the unit of the file. */
  readonly largest: number;
  /** Units that the file's text allows, the most likely first; "metric" allows two. */
  readonly stated?: readonly FileUnit[];
  /** The source of the stated units. Default 'stated'. */
  readonly because?: UnitGuess['because'];
}

/** The unit of a drawing, and whether it is certain. */
export function guessedUnit({largest, stated = [], because = 'stated'}: UnitHints): UnitGuess {
  const anything = likely(largest, drawnIn);
  const [said] = stated;
  const found = likely(largest, stated)[0];
  const guess = (unit: FileUnit, why: UnitGuess['because'], isSure: boolean): UnitGuess => ({
    ...{unit, because: why, isSure},
    others: anything.filter((other) => other !== unit),
  });
  if (found !== undefined) return guess(found, found === said ? because : 'size', true);
  if (said !== undefined) return guess(said, because, false);
  const [first = nearest(largest), ...others] = anything;
  return guess(first, 'size', anything.length > 0 && others.length === 0);
}

/** The unit in which a length is least unusual. */
function nearest(largest: number): FileUnit {
  const middle = Math.sqrt(usual.low * usual.high);
  const off = (unit: FileUnit): number => Math.abs(Math.log((largest * inCm(unit)) / middle));
  return [...drawnIn].sort((a, b) => off(a) - off(b))[0] ?? 'mm';
}

/** Returns whether a garment can have a piece of this size. [cm] */
export const isPossible = (largestCm: number): boolean => isWithin(largestCm, possible);
