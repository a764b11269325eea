/** Seams of fitted garments, upright and hollowed at the waist, from the hem up. */
import {curve, leaning, length, minus, norm, trueTo, type Curve, type Point} from './geometry.js';

export const upright: Point = [0, 1];
/** Handles of a curve at the waist: below it in cm, above it as a part of the chord. */
const hollow = {below: 10, above: 0.5};

/** From the hem to the waist, as long as asked for: leans in to +x or, with a negative lean, to -x; upright at the waist. */
export function skirtSeam(what: string, waist: Point, lean: number, seamLength: number): Curve {
  const from = (drop: number): Curve =>
    curve(
      [waist[0] + drop * Math.tan(lean), waist[1] - drop],
      leaning(-lean),
      waist,
      upright,
      drop / 3,
      hollow.below,
    );
  return from(trueTo(what, seamLength, (drop) => length(from(drop)), seamLength / 2, seamLength));
}

/** From the waist up, upright at both ends unless told; hollowed at the waist. */
export function bodiceSeam(waist: Point, to: Point, into = upright): Curve {
  const chord = norm(minus(to, waist));
  return curve(waist, upright, to, into, hollow.above * chord, chord / 3);
}
