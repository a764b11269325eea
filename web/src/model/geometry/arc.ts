/** Cubic Bezier curves along arcs of circles. Angles in radians. */
import {leftOf, minus, plus, towards, type Point} from './vectors.js';

/** A curve without its start, which is the end of the one before. */
type ArcCubic = readonly [first: Point, second: Point, end: Point];

/** The start of an arc and its curves. */
interface Arc {
  readonly start: Point;
  readonly cubics: readonly ArcCubic[];
}

/**
 * An arc of the unit circle.
 * @param sweep counter-clockwise if positive
 * @param mostStep greatest angle of one curve: its error is 4.2e-6 of the radius for pi / 4, and
 *   falls with the sixth power
 */
export function unitArc(from: number, sweep: number, mostStep: number): Arc {
  const count = Math.max(1, Math.ceil(Math.abs(sweep) / mostStep - 1e-9));
  const step = sweep / count;
  const handle = (4 / 3) * Math.tan(step / 4);
  const cubics = Array.from({length: count}, (_, k): ArcCubic => {
    const [start, end] = [towards(from + k * step), towards(from + (k + 1) * step)];
    return [plus(start, leftOf(start), handle), plus(end, leftOf(end), -handle), end];
  });
  return {start: towards(from), cubics};
}

/** The curves along an arc around a centre, after its start. @param sweep, mostStep as of `unitArc` */
export function arcAround(
  centre: Point,
  start: Point,
  sweep: number,
  mostStep: number,
): readonly ArcCubic[] {
  const [x, y] = minus(start, centre);
  const at = ([c, s]: Point): Point => plus(centre, [c * x - s * y, c * y + s * x]);
  return unitArc(0, sweep, mostStep).cubics.map(([first, second, end]): ArcCubic => [
    at(first),
    at(second),
    at(end),
  ]);
}
