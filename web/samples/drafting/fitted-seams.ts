/** Seams of fitted garments, upright and curved in at the waist, from the hem up. */
import {distance, type Point} from '../../src/model/geometry/vectors.js';
import {curve, leaning, length, pointAt, trueTo, type Curve} from './curves.js';

export const upright: Point = [0, 1];
/**
 * Handles: at the hem as a part of the drop, at the waist below it in cm, above it as a part of the
 * chord.
 */
const handles = {hem: 0.33, below: 7, above: 0.5};

/** Shape of a skirt's seam below a waist at the origin, for fabric at its -x side. [cm, radians] */
interface SkirtSeam {
  /** x of the seam at the depth of the hip. */
  readonly atHip: number;
  readonly hipDepth: number;
  /** Outward angle of the seam at the hem. */
  readonly flare: number;
  readonly seamLength: number;
}

/** A seam of the given length from the hem to the waist, through the hip; round over the hip. */
export function skirtSeam(what: string, {atHip, hipDepth, flare, seamLength}: SkirtSeam): Curve {
  const from = (drop: number): Curve => {
    const flaring = (hemX: number): Curve =>
      curve([hemX, -drop], leaning(-flare), [0, 0], upright, handles.hem * drop, handles.below);
    // moving the hem sideways moves the point at the hip in proportion and leaves its height
    const still = flaring(0);
    const t = trueTo(what, -hipDepth, (at) => pointAt(still, at)[1], 0, 1);
    const [[near], [far]] = [pointAt(still, t), pointAt(flaring(1), t)];
    return flaring((atHip - near) / (far - near));
  };
  return from(trueTo(what, seamLength, (drop) => length(from(drop)), 0.7 * seamLength, seamLength));
}

/** A seam from the waist up, upright at both ends by default; curved in at the waist. */
export function bodiceSeam(waist: Point, to: Point, into = upright): Curve {
  const chord = distance(to, waist);
  return curve(waist, upright, to, into, handles.above * chord, chord / 3);
}
