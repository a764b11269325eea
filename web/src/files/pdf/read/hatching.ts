/** Leaves out thousands of short lines, as hatching and pictures have them. Lengths in mm. */
import {lengthOf} from '../../../model/geometry/polyline.js';
import type {Point} from '../../../model/geometry/vectors.js';
import {Ends} from '../../base/ends.js';
import type {InkLine} from './ink.js';

/** Greatest length of a short line, and greatest number of those that meet no other line. */
const short = 15;
const mostShort = 3000;

/** Greatest gap between ends that meet. */
const reach = 0.3;

export function withoutHatching(lines: readonly InkLine[]): {
  readonly lines: readonly InkLine[];
  readonly notes: readonly string[];
} {
  if (lines.length <= mostShort) return {lines, notes: []};
  const endsOf = ({points, isClosed}: InkLine): readonly Point[] => {
    const [first, last] = [points[0], points.at(-1)];
    return isClosed || !first || !last ? [] : [first, last];
  };
  const ends = new Ends(lines.map(endsOf), reach);
  const alone = new Set(
    lines.filter(
      (line) =>
        lengthOf(line.points) <= short && endsOf(line).every((end) => ends.countAt(end, 2) <= 1),
    ),
  );
  if (alone.size <= mostShort) return {lines, notes: []};
  return {
    lines: lines.filter((line) => !alone.has(line)),
    notes: [`${alone.size} short lines are left out, as those of hatching or a picture.`],
  };
}
