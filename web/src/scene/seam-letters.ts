/** Letters along the seams of pieces; edges with the same letter are sewn together. */
import {leftOf, plus, type Point} from '../model/geometry/vectors.js';
import {seamLetter} from '../model/garment/letters.js';
import {atShare, isInside} from '../model/geometry/polyline.js';
import type {Pattern, SeamSide} from '../model/result/result.js';
import {pick} from './marks.js';

export interface SeamLetter {
  readonly letter: string;
  /** Beside the sewn line, inside the piece's shape. */
  readonly at: Point;
}

/** The point beside the middle of a line, on the piece's side. */
function beside(line: readonly Point[], outline: readonly Point[], inside: number): Point {
  const {at, along} = atShare(line, 0.5);
  const left = plus(at, leftOf(along), inside);
  return isInside(outline, left) ? left : plus(at, leftOf(along), -inside);
}

/**
 * Letters of each piece, in coordinates of one of its two states.
 * @param inside distance from the sewn line to the centre of a letter [cm]
 */
export function seamLetters(
  {pieces, seams}: Pick<Pattern, 'pieces' | 'seams'>,
  inside: number,
  state: 'rest' | 'shape' = 'shape',
): readonly (readonly SeamLetter[])[] {
  const letters = pieces.map((): SeamLetter[] => []);
  for (const [seam, {a, b}] of seams.entries()) {
    const mark = ({piece, vertices}: SeamSide): void => {
      const {[state]: points = [], outline = []} = pieces[piece] ?? {};
      const at = beside(pick(points, vertices), pick(points, outline), inside);
      letters[piece]?.push({letter: seamLetter(seam), at});
    };
    mark(a);
    mark(b);
  }
  return letters;
}
