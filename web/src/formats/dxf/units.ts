/** Determines the unit of a DXF file. */
import type {UnitGuess} from '../../model/garment/imported-drawing.js';
import type {FileUnit} from '../../model/garment/garment-document.js';
import type {Point} from '../../model/geometry/vectors.js';
import {guessedUnit} from '../base/units.js';
import {boundary} from './layers.js';
import {linesOn, type DxfPiece} from './pieces.js';
import type {SystemText} from './system-text.js';

/** Units of `$INSUNITS` in the header. */
const insertUnits: Readonly<Record<number, FileUnit>> = {1: 'inch', 4: 'mm', 5: 'cm', 6: 'm'};

interface UnitWords {
  readonly style: SystemText;
  readonly header: ReadonlyMap<string, number>;
  /** The unit chosen by the user. */
  readonly chosen: FileUnit | undefined;
}

/**
 * The unit of a file. ENGLISH means inches. METRIC means millimetres in the standard, but CLO
 * writes centimetres. The header's unit is used only without such text, since Optitex writes metres
 * there in any case.
 * @param largest the longer side of the largest piece, in the unit of the file
 */
export function unitOf(largest: number, {style, header, chosen}: UnitWords): UnitGuess {
  if (chosen) return {unit: chosen, because: 'stated', isSure: true, others: []};
  const words = style.value('units') ?? '';
  if (/english|imperial|inch/i.test(words)) return guessedUnit({largest, stated: ['inch']});
  if (/metric|mm|cm|milli|centi/i.test(words)) return guessedUnit({largest, stated: ['mm', 'cm']});
  const inserted = insertUnits[header.get('$INSUNITS') ?? 0];
  return inserted
    ? guessedUnit({largest, stated: [inserted], because: 'program'})
    : guessedUnit({largest});
}

/** The longer side of the largest piece's bounding box. */
export const largestOf = (pieces: readonly DxfPiece[]): number =>
  Math.max(...pieces.map(({entities}) => sizeOf(linesOn(entities, boundary))));

/** The longer side of the bounding box of lines. */
export function sizeOf(lines: readonly {readonly points: readonly Point[]}[]): number {
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
