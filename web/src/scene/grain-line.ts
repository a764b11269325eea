/** Position of a piece's grain line. Lengths in cm. */
import type {PanelMarks} from '../model/garment/panel-marks.js';
import {plus, radians, towards, type Point} from '../model/geometry/vectors.js';
import type {ResultPiece} from '../model/result/result.js';
import {innermost, pick} from './marks.js';

/** Greatest length of a line that the file does not draw. */
const greatest = 20;

type Drafted = Pick<ResultPiece, 'rest' | 'outline'>;

/**
 * A line in the widest part of the drafted piece.
 * @param angle from its x axis, face up [radians]
 */
export function lineAt({rest, outline}: Drafted, angle: number): readonly [Point, Point] {
  const {at, room} = innermost(pick(rest, outline));
  const reach = Math.min(greatest / 2, 0.8 * room);
  return [plus(at, towards(angle), -reach), plus(at, towards(angle), reach)];
}

/**
 * The grain line of a drafted piece, face up: the user's, otherwise the garment's; undefined
 * without either.
 */
export function grainLine(
  piece: Drafted,
  {grain, grainDeg}: Pick<PanelMarks, 'grain' | 'grainDeg'> = {},
): readonly [Point, Point] | undefined {
  if (grainDeg !== undefined) return lineAt(piece, radians(grainDeg));
  return grain;
}
