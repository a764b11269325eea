/** What is chosen of a drawing, and how large it is then. */
import type {PieceChoice} from '../../formats/to-garment.js';
import {unitsInMetre, type FileUnit} from '../../model/garment-document.js';
import type {ShownDrawing} from './reading.js';

export type {PieceChoice} from '../../formats/to-garment.js';

export const cmOf = (unit: FileUnit): number => 100 / unitsInMetre[unit];

/** Of another size of a drawing, what was chosen before of the pieces of these names. */
export function chosenAlso(
  {drawing, first}: ShownDrawing,
  before: ShownDrawing,
  choices: readonly PieceChoice[],
): readonly PieceChoice[] {
  const known = new Map(before.drawing.pieces.map(({name}, k) => [name, choices[k]]));
  return first.pieces.map((choice, k) => known.get(drawing.pieces[k]?.name ?? '') ?? choice);
}

/** The longer side of the largest piece. [cm] */
export const largestOf = ({shapes}: Pick<ShownDrawing, 'shapes'>, unit: FileUnit): number =>
  cmOf(unit) * shapes.reduce((most, {box}) => Math.max(most, box[2], box[3]), 0);
