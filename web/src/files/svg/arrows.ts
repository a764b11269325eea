/** Arrows among the lines of an SVG, whose heads are lines of their own. [mm] */
import {arrowsIn} from '../base/arrows.js';
import type {Point} from '../../model/geometry/vectors.js';
import {straight} from '../base/bezier.js';
import {pointsOf} from './outlines.js';
import type {Drawn} from './walk.js';

/** The lines with arrows as straight lines, and without their heads. */
export function withArrows(drawn: readonly Drawn[]): Drawn[] {
  const lines = drawn.flatMap((one, place) =>
    one.lines.map((line) => ({
      ...{one, line, place},
      points: pointsOf(line),
      isClosed: line.isClosed,
      style: {isFilled: one.style.fill !== 'none'},
    })),
  );
  const {arrows, rest} = arrowsIn(lines);
  if (arrows.length === 0) return [...drawn];
  const kept = new Map<number, Drawn>();
  for (const {one, line, place} of rest) {
    kept.set(place, {...one, lines: [...(kept.get(place)?.lines ?? []), line]});
  }
  const straightened = arrows.map(({one, points, place}) => {
    const [start, end]: readonly [Point, Point] = [points[0] ?? [0, 0], points.at(-1) ?? [0, 0]];
    const line = {start, cubics: [straight(start, end)], isClosed: false};
    return {place, drawn: {...one, lines: [line], isArrow: true}};
  });
  return [...[...kept].map(([place, one]) => ({place, drawn: one})), ...straightened]
    .sort((a, b) => a.place - b.place)
    .map(({drawn: one}) => one);
}
