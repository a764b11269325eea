/** Sides of seams as lines on the sheet. Lengths in cm. */
import type {Point} from '../model/geometry.js';
import type {SeamSide} from '../model/result.js';
import {ontoSheet} from '../model/sheet-place.js';
import {pick} from './marks.js';
import type {PatternScene} from './scene.js';

export function lineOf({pieces}: PatternScene, {piece, vertices}: SeamSide): Point[] {
  const shown = pieces[piece];
  return shown ? pick(shown.points, vertices).map((point) => ontoSheet(shown, point)) : [];
}

/** A point of a line, and the direction in which the line runs there. */
export interface OnLine {
  readonly at: Point;
  /** Of length 1. */
  readonly along: Point;
}

/** Where on a line its length has been gone by this share, from 0 to 1. */
export function atShare(line: readonly Point[], share: number): OnLine {
  const steps = line.slice(1).map(([x, y], k): Point => {
    const [fromX, fromY] = line[k] ?? [x, y];
    return [x - fromX, y - fromY];
  });
  let left = share * steps.reduce((sum, step) => sum + Math.hypot(...step), 0);
  let k = 0;
  while (k < steps.length - 1 && left > Math.hypot(...(steps[k] ?? [0, 0]))) {
    left -= Math.hypot(...(steps[k++] ?? [0, 0]));
  }
  const [dx, dy] = steps[k] ?? [1, 0];
  const length = Math.hypot(dx, dy) || 1;
  const [x, y] = line[k] ?? [0, 0];
  const along: Point = [dx / length, dy / length];
  return {at: [x + along[0] * left, y + along[1] * left], along};
}
