/** Letters along the seams of the pieces to cut: what has the same is sewn together. */
import type {Point} from '../../model/geometry.js';
import type {Pattern, SeamSide} from '../../model/result.js';
import {isInside, pick} from '../marks.js';

export interface SeamLetter {
  readonly letter: string;
  /** Beside the sewn line, inside of the piece's shape. */
  readonly at: Point;
}

/** From the sewn line to the middle of a letter. [cm] */
const inside = 0.6;

/** A, B, ... Z, AA, AB, ... */
export const letterOf = (number: number): string =>
  (number >= 26 ? letterOf(Math.floor(number / 26) - 1) : '') +
  String.fromCharCode(65 + (number % 26));

/** Beside the middle of a line, on the side where the piece is. */
function beside(line: readonly Point[], outline: readonly Point[]): Point | undefined {
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

/** By piece, in the coordinates of its shape. */
export function seamLetters({pieces, seams}: Pattern): readonly (readonly SeamLetter[])[] {
  const letters = pieces.map((): SeamLetter[] => []);
  for (const [seam, {a, b}] of seams.entries()) {
    const mark = ({piece, vertices}: SeamSide): void => {
      const {shape = [], outline = []} = pieces[piece] ?? {};
      const at = beside(pick(shape, vertices), pick(shape, outline));
      if (at) letters[piece]?.push({letter: letterOf(seam), at});
    };
    mark(a);
    mark(b);
  }
  return letters;
}
