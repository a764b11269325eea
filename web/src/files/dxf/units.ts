/** Determines the unit of a DXF file. */
import type {UnitGuess} from '../../model/garment/imported-drawing.js';
import type {FileUnit} from '../../model/garment/garment-document.js';
import type {Point} from '../../model/geometry/vectors.js';
import {guessedUnit} from '../base/units.js';
import {boundary} from './layers.js';
import {linesOn, type DxfPiece} from './pieces.js';
import type {SystemText} from './system-text.js';
import {vendorOf} from './vendors.js';

/** A unit of the header as a multiple of one that patterns use. */
interface HeaderUnit {
  readonly unit: FileUnit;
  readonly times: number;
}

/** Units of `$INSUNITS` in the header. */
const insertUnits: Readonly<Record<number, HeaderUnit>> = {
  ...{1: {unit: 'inch', times: 1}, 2: {unit: 'inch', times: 12}, 10: {unit: 'inch', times: 36}},
  ...{4: {unit: 'mm', times: 1}, 5: {unit: 'cm', times: 1}, 6: {unit: 'm', times: 1}},
  ...{8: {unit: 'inch', times: 1e-6}, 9: {unit: 'inch', times: 1e-3}},
  ...{13: {unit: 'mm', times: 1e-3}, 14: {unit: 'cm', times: 10}, 15: {unit: 'm', times: 10}},
  ...{21: {unit: 'inch', times: 12 * 1.000002}, 22: {unit: 'inch', times: 1.000002}},
  ...{23: {unit: 'inch', times: 36 * 1.000002}},
};

/**
 * The factor from coordinates of a file to those in its unit, other than 1 for feet and other units
 * that patterns do not use.
 */
export const timesOf = ({style, header, chosen}: UnitWords): number =>
  chosen || style.value('units') !== undefined
    ? 1
    : (insertUnits[header.get('$INSUNITS') ?? 0]?.times ?? 1);

/** Architectural and engineering formats of lengths, `$LUNITS`, whose unit is the inch. */
const inchFormats = [3, 4];

export interface UnitWords {
  readonly style: SystemText;
  readonly header: ReadonlyMap<string, number>;
  /** The unit chosen by the user. */
  readonly chosen: FileUnit | undefined;
}

/**
 * The unit of a file. ENGLISH means inches. METRIC means millimetres in the standard, but CLO
 * writes centimetres. The header's unit is used only without such text, since Optitex writes metres
 * there in any case. Without a unit there, `$LUNITS` and `$MEASUREMENT` are hints.
 * @param largest the longer side of the largest piece, in the unit of the file
 */
export function unitOf(largest: number, {style, header, chosen}: UnitWords): UnitGuess {
  if (chosen) return {unit: chosen, because: 'stated', isSure: true, others: []};
  const words = style.value('units') ?? '';
  if (/english|imperial|inch/i.test(words)) return guessedUnit({largest, stated: ['inch']});
  if (/metric|mm|cm|milli|centi/i.test(words)) {
    const {metric} = vendorOf(style.value('author'));
    const [only] = metric;
    if (only && metric.length === 1) {
      return {unit: only, because: 'stated', isSure: true, others: []};
    }
    return guessedUnit({largest, stated: metric});
  }
  const inserted = insertUnits[header.get('$INSUNITS') ?? 0];
  if (inserted) return guessedUnit({largest, stated: [inserted.unit], because: 'program'});
  if (inchFormats.includes(header.get('$LUNITS') ?? 0)) {
    return hinted(guessedUnit({largest, stated: ['inch'], because: 'program'}));
  }
  const measurement = header.get('$MEASUREMENT');
  if (measurement === undefined) return guessedUnit({largest});
  // the template of a drawing decides on this variable, so that it is no more than a hint
  const family: readonly FileUnit[] = measurement === 0 ? ['inch'] : ['mm', 'cm', 'm'];
  const guess = guessedUnit({largest, stated: family, because: 'program'});
  return guess.isSure ? hinted(guess) : guessedUnit({largest});
}

/** A guess that is sure only if no other unit fits. */
const hinted = (guess: UnitGuess): UnitGuess => ({
  ...guess,
  isSure: guess.isSure && guess.others.length === 0,
});

/** The longer side of the largest piece's bounding box. */
export const largestOf = (pieces: readonly DxfPiece[]): number =>
  Math.max(...pieces.map(({entities}) => sizeOf(linesOn(entities, boundary))));

/** The longer side of the bounding box of lines. */
function sizeOf(lines: readonly {readonly points: readonly Point[]}[]): number {
  const low = [Infinity, Infinity] as [number, number];
  const high = [-Infinity, -Infinity] as [number, number];
  for (const {points} of lines) {
    for (const [x, y] of points) {
      [low[0], low[1]] = [Math.min(low[0], x), Math.min(low[1], y)];
      [high[0], high[1]] = [Math.max(high[0], x), Math.max(high[1], y)];
    }
  }
  return Math.max(high[0] - low[0], high[1] - low[1]);
}
