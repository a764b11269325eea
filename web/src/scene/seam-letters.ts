/** Letters along the seams of pieces: what has the same is sewn together. */
import type {Point} from '../model/geometry.js';
import {seamLetter} from '../model/letters.js';
import type {Pattern, SeamSide} from '../model/result.js';
import {isInside, pick} from './marks.js';

export interface SeamLetter {
  readonly letter: string;
  /** Beside the sewn line, inside of the piece's shape. */
  readonly at: Point;
}

/** Beside the middle of a line, on the side where the piece is. */
function beside(
  line: readonly Point[],
  outline: readonly Point[],
  inside: number,
): Point | undefined {
  const steps = line.slice(1).map(([x, y], k) => {
    const [fromX, fromY] = line[k] ?? [x, y];
    return Math.hypot(x - fromX, y - fromY);
  });
  let left = steps.reduce((sum, step) => sum + step, 0) / 2;
  for (const [k, step] of steps.entries()) {
    const [from, to] = line.slice(k, k + 2);
    if (from && to && left <= step && step > 0) {
      const [ux, uy] = [(to[0] - from[0]) / step, (to[1] - from[1]) / step];
      const at = (across: number): Point => [
        from[0] + left * ux - across * uy,
        from[1] + left * uy + across * ux,
      ];
      return isInside(outline, at(inside)) ? at(inside) : at(-inside);
    }
    left -= step;
  }
  return undefined;
}

/**
 * By piece, in the coordinates of its outline in either of its two states.
 * @param inside from the sewn line to the middle of a letter [cm]
 */
export function seamLetters(
  {pieces, seams}: Pattern,
  inside: number,
  state: 'rest' | 'shape' = 'shape',
): readonly (readonly SeamLetter[])[] {
  const letters = pieces.map((): SeamLetter[] => []);
  for (const [seam, {a, b}] of seams.entries()) {
    const mark = ({piece, vertices}: SeamSide): void => {
      const {[state]: points = [], outline = []} = pieces[piece] ?? {};
      const at = beside(pick(points, vertices), pick(points, outline), inside);
      if (at) letters[piece]?.push({letter: seamLetter(seam), at});
    };
    mark(a);
    mark(b);
  }
  return letters;
}
