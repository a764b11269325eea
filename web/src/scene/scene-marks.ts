/** Marks on the pieces of a scene: axes and letters of their symmetries, and grain lines. Lengths in cm. */
import type {PanelMarks} from '../model/garment-marks.js';
import {dot, leftOf, minus, plus, unit, type Point} from '../model/geometry.js';
import {pairLetter} from '../model/letters.js';
import type {Pattern, ResultPiece} from '../model/result.js';
import {grainLine} from './grain-line.js';
import {axisAlong, innermost, mirrorImage, pick} from './marks.js';

/** A place for a letter, in the coordinates of a piece, and how far the outline is from there. */
interface PairMark {
  readonly piece: number;
  readonly at: Point;
  readonly room: number;
}

export type SceneSymmetry =
  | {readonly kind: 'piece'; readonly piece: number; readonly axis: readonly [Point, Point]}
  | {readonly kind: 'pair'; readonly letter: string; readonly marks: readonly PairMark[]};

/** A grain line on a mirror axis is moved aside by this, since only its direction counts. */
const grainShift = 2;

/** Axes and letters of symmetries, as they are drawn. */
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

/** Beside the piece's mirror axis, if it would lie on it. */
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
