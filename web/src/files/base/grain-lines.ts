/** Several grain lines of a piece, such as those of layouts on grain, across and on the bias. */
import type {DrawnGrain} from '../../model/garment/grain.js';
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

/** Names of lines for other layouts than the usual one. */
const otherLayouts = /bias|cross|quer|schräg|biais|travers|\bbies\b|sesgo|sbieco|trama/i;

/** Greatest distance of text from its line. [cm] */
const beside = 3;
/** Longer text is an instruction. */
const longestName = 60;
/** Least length of a grain line [cm], and as a share of the longest one: shorter lines are arrowheads. */
const shortest = 3;
const leastShare = 0.4;
/** Least difference of two directions, as a sine. */
const apart = 0.02;

/** The text that names each line: each text belongs to the line that is nearest to it. */
function namesOf(
  lines: readonly Ends[],
  labels: readonly Label[],
  cmPerUnit: number,
): ReadonlyMap<Ends, string> {
  const names = new Map<Ends, string>();
  const off = (line: Ends, {at}: Label): number => cmPerUnit * nearestOn(line, at, false).off;
  for (const label of labels) {
    if (!words.test(label.text) || label.text.length > longestName) continue;
    const [line] = [...lines].sort((one, other) => off(one, label) - off(other, label));
    if (line && off(line, label) < beside && !names.has(line)) names.set(line, label.text.trim());
  }
  return names;
}

/**
 * The grain lines among lines of different directions; none for a single one.
 * @param isSure the file marks all lines as grain lines, so that they need no text
 */
export function grainsAmong(
  lines: readonly Ends[],
  labels: readonly Label[],
  {cmPerUnit, isSure}: {readonly cmPerUnit: number; readonly isSure: boolean},
): readonly DrawnGrain[] {
  const longest = Math.max(0, ...lines.map((line) => distance(...line)));
  const long = lines.filter((line) => {
    const length = distance(...line);
    return cmPerUnit * length >= shortest && length >= leastShare * longest;
  });
  const names = namesOf(long, labels, cmPerUnit);
  const found: DrawnGrain[] = [];
  for (const line of long) {
    const name = names.get(line);
    const way = unit(minus(line[1], line[0]));
    const isOther = found.every(
      ({line: [from, to]}) => Math.abs(cross(way, unit(minus(to, from)))) > apart,
    );
    if (isOther && (isSure || name !== undefined))
      found.push({...(name !== undefined && {name}), line});
  }
  return found.length > 1 ? found : [];
}

/** The line of the usual layout: the first one that is not named as across or on the bias. */
export const usualGrain = (grains: readonly DrawnGrain[]): Ends | undefined =>
  (grains.find(({name}) => name === undefined || !otherLayouts.test(name)) ?? grains[0])?.line;
