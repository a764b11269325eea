/** How well the print of a result meets along its seams, in words that a tailor would use. */
import type {Point} from '../../model/geometry.js';
import type {ResultSeam, SolveResult} from '../../model/result.js';
import {chanceMismatch} from '../../viewer/chance.js';

export interface Match {
  /** Mean over the seams that count, each with one symmetry of the print. [cm] */
  readonly mean: number;
  /** The mean mismatch of two points chosen at random. [cm] */
  readonly chance: number;
}

const distance = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

function lengthsOf(result: SolveResult, {a: {piece, vertices}}: ResultSeam): number[] {
  const points = vertices.flatMap((v) => result.pieces[piece]?.shape.slice(v, v + 1) ?? []);
  return points.slice(1).map((to, k) => distance(points[k] ?? to, to));
}

export function matchOf(result: SolveResult): Match {
  let length = 0;
  let total = 0;
  for (const seam of result.seams) {
    if (!seam.matched) continue;
    lengthsOf(result, seam).forEach((edge, k) => {
      length += edge;
      total += edge * (seam.mismatch[k] ?? 0);
    });
  }
  return {mean: length > 0 ? total / length : 0, chance: chanceMismatch(result.print)};
}
