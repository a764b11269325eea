/** In which unit a drawing is: what it says, if somebody could wear that, else what somebody could. */
import type {UnitGuess} from '../../model/drawing.js';
import {unitsInMetre, type FileUnit} from '../../model/garment-document.js';

/** How long the largest piece of a garment is. [cm] */
const usual = {low: 25, high: 220};

/** Nobody wears what has no piece of this size, be it a doll or a giant. [cm] */
const possible = {low: 3, high: 500};

const inCm = (unit: FileUnit): number => 100 / unitsInMetre[unit];

export const cmPer = inCm;

const isWithin = (
  largest: number,
  {low, high}: {readonly low: number; readonly high: number},
): boolean => largest >= low && largest <= high;

/** Units that patterns are drawn in, the likeliest first. */
const drawnIn: readonly FileUnit[] = ['mm', 'cm', 'inch', 'm'];

const likely = (largest: number, units: readonly FileUnit[]): FileUnit[] =>
  units.filter((unit) => isWithin(largest * inCm(unit), usual));

interface UnitHints {
  /** The longer side of the largest piece, in the unit of the file. */
  readonly largest: number;
  /** Units that the file's words allow, the likeliest first; "metric" is either of two. */
  readonly stated?: readonly FileUnit[];
  /** By what they are stated. Default 'stated'. */
  readonly because?: UnitGuess['because'];
}

/** The unit of a drawing, and whether it needs to be asked. */
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
  const [first, ...others] = likely(largest, ['mm', 'cm']);
  return first === undefined
    ? guess(anything[0] ?? nearest(largest), 'size', false)
    : guess(first, 'size', others.length === 0);
}

/** The unit in which a length is least unusual. */
function nearest(largest: number): FileUnit {
  const middle = Math.sqrt(usual.low * usual.high);
  const off = (unit: FileUnit): number => Math.abs(Math.log((largest * inCm(unit)) / middle));
  return [...drawnIn].sort((a, b) => off(a) - off(b))[0] ?? 'mm';
}

/** Whether a garment could have a piece of this size at all. [cm] */
export const isPossible = (largestCm: number): boolean => isWithin(largestCm, possible);
