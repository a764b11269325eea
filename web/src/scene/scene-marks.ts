/**
 * Marks on the pieces of a scene: axes and letters of symmetries, and grain lines. Lengths in cm.
 */
import type {PanelMarks} from '../model/garment/panel-marks.js';
import {dot, leftOf, minus, plus, unit, type Point} from '../model/geometry/vectors.js';
import {pairLetter} from '../model/garment/letters.js';
import type {Pattern, ResultPiece} from '../model/result/result.js';
import {axisAlong, grainLine, innermost, mirrorImage, pick} from './marks.js';

/** A position for a letter in piece coordinates, and its distance from the outline. */
interface PairMark {
  readonly piece: number;
  readonly at: Point;
  readonly room: number;
}

export type SceneSymmetry =
  | {readonly kind: 'piece'; readonly piece: number; readonly axis: readonly [Point, Point]}
  | {readonly kind: 'pair'; readonly letter: string; readonly marks: readonly PairMark[]};

/** Offset of a grain line from a mirror axis; only the direction of the line matters. */
const grainShift = 2;

/** Axes and letters of symmetries for drawing. */
export function symmetriesOf(
  {pieces, symmetries}: Pattern,
  outline: 'rest' | 'shape',
): readonly SceneSymmetry[] {
  const outlineOf = (piece: number): Point[] => {
    const {[outline]: points = [], outline: loop = []} = pieces[piece] ?? {};
    return pick(points, loop);
  };
  return symmetries.map((symmetry): SceneSymmetry => {
    if (symmetry.kind === 'piece') {
      const axis = axisAlong(symmetry.map, outlineOf(symmetry.piece), 0);
      return {kind: 'piece', piece: symmetry.piece, axis};
    }
    const [first, second] = symmetry.pieces;
    const {at, room} = innermost(outlineOf(first));
    return {
      kind: 'pair',
      letter: pairLetter(symmetry.pieces),
      marks: [
        {piece: first, at, room},
        {piece: second, at: mirrorImage(symmetry.map, at), room},
      ],
    };
  });
}

/** Moves a grain line beside the piece's mirror axis if it coincides with it. */
function besideAxis(grain: readonly [Point, Point], axis: readonly [Point, Point]): typeof grain {
  const [start, end] = axis;
  const normal = leftOf(unit(minus(end, start)));
  if (grain.some((p) => Math.abs(dot(minus(p, start), normal)) > grainShift / 2)) return grain;
  return [plus(grain[0], normal, grainShift), plus(grain[1], normal, grainShift)];
}

export function grainOf(
  piece: ResultPiece,
  marks: PanelMarks | undefined,
  axis: readonly [Point, Point] | undefined,
): {readonly grain?: readonly [Point, Point]} {
  const line = grainLine(piece, marks);
  return line ? {grain: axis ? besideAxis(line, axis) : line} : {};
}
