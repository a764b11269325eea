/** Choices for a drawing, and the sizes that result. */
import type {PieceChoice} from '../../files/to-garment.js';
import {unitsInMetre, type FileUnit} from '../../model/garment/garment-document.js';
import type {ShownDrawing} from './reading.js';

export const cmOf = (unit: FileUnit): number => 100 / unitsInMetre[unit];

/** Returns the choices for another size of a drawing; pieces with the same names keep theirs. */
export function chosenAlso(
  {drawing, first}: ShownDrawing,
  before: ShownDrawing,
  choices: readonly PieceChoice[],
): readonly PieceChoice[] {
  const known = new Map(before.drawing.pieces.map(({name}, k) => [name, choices[k]]));
  return first.pieces.map((choice, k) => known.get(drawing.pieces[k]?.name ?? '') ?? choice);
}

/** Returns the longer side of the largest piece. [cm] */
export const largestOf = ({shapes}: Pick<ShownDrawing, 'shapes'>, unit: FileUnit): number =>
  cmOf(unit) * shapes.reduce((most, {box}) => Math.max(most, box[2], box[3]), 0);
