/** Several grain lines of a piece, such as those of layouts on grain, across and on the bias. */
import type {GrainChoice} from '../../model/garment/grain.js';
import {nearestOn} from '../../model/geometry/nearest.js';
import {cross, distance, minus, unit, type Point} from '../../model/geometry/vectors.js';

type Ends = readonly [Point, Point];

/** Text, and its place in the coordinates of the lines. */
interface Label {
  readonly at: Point;
  readonly text: string;
}

const words =
  /grain|\bbias\b|fadenlauf|querfaden|schräg|droit[- ]fil|biais|\bhilo\b|\bbies\b|sesgo|dritto ?filo|sbieco/i;

/** Greatest distance of text from its line. [cm] */
const beside = 3;
/** Least length of a grain line [cm], and as a share of the longest one: shorter lines are arrowheads. */
const shortest = 3;
const leastShare = 0.4;
/** Least difference of two directions, as a sine. */
const apart = 0.02;

/** The first line of the text beside a line that names a kind of grain. */
function nameOf(line: Ends, labels: readonly Label[], cmPerUnit: number): string | undefined {
  const off = ({at}: Label): number => cmPerUnit * nearestOn(line, at, false).off;
  const [nearest] = labels
    .filter((label) => words.test(label.text) && label.text.length < 60 && off(label) < beside)
    .sort((one, other) => off(one) - off(other));
  return nearest?.text.trim();
}

/**
 * The grain lines among lines of different directions; none for a single one.
 * @param isSure the file marks all lines as grain lines, so that they need no text
 */
export function grainsAmong(
  lines: readonly Ends[],
  labels: readonly Label[],
  {cmPerUnit, isSure}: {readonly cmPerUnit: number; readonly isSure: boolean},
): readonly GrainChoice[] {
  const longest = Math.max(0, ...lines.map((line) => distance(...line)));
  const found: GrainChoice[] = [];
  for (const line of lines) {
    const length = distance(...line);
    if (cmPerUnit * length < shortest || length < leastShare * longest) continue;
    const name = nameOf(line, labels, cmPerUnit);
    const way = unit(minus(line[1], line[0]));
    const isOther = found.every(
      ({line: [from, to]}) => Math.abs(cross(way, unit(minus(to, from)))) > apart,
    );
    if (isOther && (isSure || name !== undefined))
      found.push({...(name !== undefined && {name}), line});
  }
  return found.length > 1 ? found : [];
}
