/** Where cloth is cut: the sewn outline with its allowance. Lengths in cm. */
import {Clipper, EndType, JoinType} from 'clipper2-ts';

import type {Point} from '../model/geometry.js';

/** How far a sharp corner's allowance may reach, in allowances, before it is cut off. */
const mitreLimit = 2;
/** Digits after the point of a centimetre that are kept. */
const precision = 5;

/**
 * The closed lines at `allowance` outside of the outline and inside of its holes, without loops where they
 * would cross themselves; small holes close.
 * @param outline counter-clockwise
 * @param holes clockwise
 */
export function cutLine(
  outline: readonly Point[],
  holes: readonly (readonly Point[])[],
  allowance: number,
): readonly (readonly Point[])[] {
  const loops = [outline, ...holes];
  if (allowance === 0) return loops;
  const paths = loops.map((loop) => loop.map(([x, y]) => ({x, y})));
  return Clipper.inflatePathsD(
    paths,
    allowance,
    JoinType.Miter,
    EndType.Polygon,
    mitreLimit,
    precision,
  ).map((path) => path.map(({x, y}): Point => [x, y]));
}
