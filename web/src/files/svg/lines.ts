/** Converts SVG shapes to chains of cubics. */
import type {Run} from '../../model/garment/imported-drawing.js';
import {apply, type PlaneMap} from '../../model/geometry/plane-map.js';
import {distance, type Point} from '../../model/geometry/vectors.js';
import type {XmlElement} from '../base/xml.js';
import {endOf, straight, type CubicFrom} from '../base/bezier.js';
import {pathOf, stepsOf} from './paths.js';

/** A subpath. */
export interface Line extends Run {
  readonly isClosed: boolean;
}

/** Greatest distance between ends that meet. [mm] */
export const meeting = 0.1;

/**
 * The transformed lines of a shape; undefined if it is none. Reads the valid prefix of an invalid
 * path, as browsers do.
 * @param view width and height of the view, for lengths in per cent
 */
export function linesOf(
  element: XmlElement,
  map: PlaneMap,
  view: Point,
): {readonly lines: readonly Line[]; readonly isDamaged: boolean} | undefined {
  const path = pathOf(element, view);
  if (path === undefined) return undefined;
  const lines: Line[] = [];
  let pen: {start: Point; cubics: CubicFrom[]; closes: boolean} | undefined;
  const finish = (): void => {
    if (pen && pen.cubics.length > 0) lines.push(closedIfMet(pen.start, pen.cubics, pen.closes));
    pen = undefined;
  };
  const {steps, isDamaged} = stepsOf(path);
  let at: Point = [0, 0];
  let start = at;
  for (const {kind, points} of steps) {
    const to = points.at(-1) ?? start;
    if (kind === 'm') {
      finish();
      start = to;
    } else {
      pen ??= {start: apply(map, at), cubics: [], closes: kind === 'h'};
      const [one = at, two = at] = points.map((p) => apply(map, p));
      if (kind === 'l') pen.cubics.push(straight(apply(map, at), one));
      if (kind === 'c') pen.cubics.push([one, two, apply(map, to)]);
      if (kind === 'h') {
        pen.closes = true;
        finish();
      }
    }
    at = to;
  }
  finish();
  return {lines, isDamaged};
}

function closedIfMet(start: Point, cubics: CubicFrom[], closes: boolean): Line {
  const line = {start, cubics};
  const gap = distance(endOf(line), start);
  if (!closes && gap > meeting) return {...line, isClosed: false};
  if (gap > meeting) cubics.push(straight(endOf(line), start));
  const last = cubics.pop();
  if (last) cubics.push([last[0], last[1], start]);
  return {...line, isClosed: true};
}
