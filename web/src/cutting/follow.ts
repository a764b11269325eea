/**
 * Transfers marks of the drafted piece to its solved shape, which shares its triangles and outline.
 */
import type {Notch} from '../model/garment/panel-marks.js';
import {between, distance, leftOf, minus, unit, type Point} from '../model/geometry/vectors.js';
import {stepAt} from '../model/geometry/polyline.js';
import type {ResultPiece} from '../model/result/result.js';
import {pick} from '../scene/marks.js';

/** A point of the sewn outline with its outward unit normal. */
interface OutlineMark {
  readonly at: Point;
  readonly outward: Point;
}

/**
 * A notch on the shape's outline.
 * @param notch in drafted coordinates of the piece, face up
 */
export function notchMark(
  {rest, shape, outline}: ResultPiece,
  {from, to, at}: Notch,
): OutlineMark | undefined {
  const drafted = pick(rest, outline);
  const nearest = (to: Point): number => {
    const apart = drafted.map((p) => distance(p, to));
    return apart.indexOf(Math.min(...apart));
  };
  const first = nearest(from);
  const steps = (nearest(to) - first + outline.length) % outline.length || outline.length;
  const edge = Array.from({length: steps + 1}, (_, k) => (first + k) % outline.length);
  const {step, part} = stepAt(pick(drafted, edge), at);
  const [p, q] = pick(pick(shape, outline), edge.slice(step, step + 2));
  return p && q && {at: between(p, q, part), outward: leftOf(unit(minus(p, q)))};
}
