/** In which unit a DXF file is. */
import type {UnitGuess} from '../../model/drawing.js';
import type {FileUnit} from '../../model/garment-document.js';
import type {Point} from '../../model/geometry.js';
import {guessedUnit} from '../base/units.js';
import {boundary} from './layers.js';
import {linesOn, type DxfPiece} from './pieces.js';
import type {SystemText} from './system-text.js';

/** Of the header's `$INSUNITS`. */
const insertUnits: Readonly<Record<number, FileUnit>> = {1: 'inch', 4: 'mm', 5: 'cm', 6: 'm'};

interface UnitWords {
  readonly style: SystemText;
  readonly header: ReadonlyMap<string, number>;
  /** By whoever opens the file. */
  readonly chosen: FileUnit | undefined;
}

/**
 * Stated ENGLISH is inches. METRIC are millimetres to the standard, but CLO is known to write centimetres; the header's
 * unit counts where no words do, as Optitex writes metres there, whatever it draws in.
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

/** The longer side of the box around the largest piece. */
export const largestOf = (pieces: readonly DxfPiece[]): number =>
  Math.max(...pieces.map(({entities}) => sizeOf(linesOn(entities, boundary))));

/** The longer side of the box around lines. */
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
