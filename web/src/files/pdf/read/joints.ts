/**
 * Compares the lines that leave a page with those that enter another one, for every overlap of the
 * two. Lengths in mm.
 */
import type {Box} from '../../../model/geometry/polyline.js';
import type {InkLine} from './ink.js';

/** Step of the compared overlaps, and the greatest one. Each page gives half of the overlap. */
export const step = 0.5;
export const mostOverlap = 60;
/** Number of compared overlaps. */
export const overlaps = Math.round(mostOverlap / step) + 1;

/** Distance from the side of a page at which lines that end there still cross. */
const inset = 0.05;

/** A line where it crosses a joint. */
interface Crossing {
  /** Place along the joint. */
  readonly at: number;
  /** Direction: change along the joint per length across it. */
  readonly slope: number;
}

export type Side = 'left' | 'right' | 'top' | 'bottom';

/** The crossings of lines with all parallels to a side of the window, from the side inwards. */
export type Profile = readonly (readonly Crossing[])[];

const isSideways = (side: Side): boolean => side === 'left' || side === 'right';

/** The place of a parallel. @param depth distance from the side */
function parallelAt({low, high}: Box, side: Side, depth: number): number {
  if (side === 'left') return low[0] + depth;
  if (side === 'right') return high[0] - depth;
  return side === 'bottom' ? low[1] + depth : high[1] - depth;
}

/** Steeper lines run along the joint, and their place on it means nothing. */
const steepest = 20;

/** Adds the crossings of lines with parallels to a side. @param depths distances from the side */
function crossingsAt(
  lines: readonly InkLine[],
  window: Box,
  side: Side,
  depths: readonly number[],
): Crossing[][] {
  const [across, along] = isSideways(side) ? ([0, 1] as const) : ([1, 0] as const);
  const origin = isSideways(side) ? window.high[1] : window.low[0];
  const found = depths.map((): Crossing[] => []);
  const places = depths.map((depth) => parallelAt(window, side, depth));
  const [least, most] = [Math.min(...places), Math.max(...places)];
  for (const {points, isClosed, style} of lines) {
    if (style.stroke === undefined) continue;
    const last = isClosed ? points.length : points.length - 1;
    for (let k = 0; k < last; k++) {
      const [a, b] = [points[k], points[(k + 1) % points.length]];
      if (!a || !b) continue;
      const [from, to] = [a[across], b[across]];
      if (Math.max(from, to) < least || Math.min(from, to) > most || from === to) continue;
      const slope = (b[along] - a[along]) / (to - from);
      if (Math.abs(slope) > steepest) continue;
      places.forEach((place, n) => {
        if ((from - place) * (to - place) > 0 || to === place) return;
        found[n]?.push({at: a[along] + slope * (place - from) - origin, slope});
      });
    }
  }
  return found.map((list) => list.sort((one, two) => one.at - two.at));
}

const allDepths = Array.from({length: 2 * overlaps - 1}, (_, k) => Math.max(inset, (k * step) / 2));

export const profileOf = (lines: readonly InkLine[], window: Box, side: Side): Profile =>
  crossingsAt(lines, window, side, allDepths);

/** The crossings with one parallel. @param depth its distance from the side */
export const crossingsFor = (
  lines: readonly InkLine[],
  window: Box,
  side: Side,
  depth: number,
): readonly Crossing[] => crossingsAt(lines, window, side, [Math.max(inset, depth)])[0] ?? [];

/** Greatest distance between lines that continue each other, coarse and for steps of an overlap. */
const tolerance = {coarse: 0.35, fine: 0.6};
/** Greatest difference of their directions, as an angle. [rad] */
const bend = 0.2;

/** Penalty for a line that ends at a joint. */
const miss = 0.75;
/** Penalty for the distance between lines that go on, per mm. */
const drift = 0.5;
/** Weight of the parallels at both sides of an overlap, against that in its middle. */
const outer = 0.5;
/** Penalty for a line that enters a strip without any line, which may be a margin. */
const intoNothing = 0.15;

/**
 * The gain of an overlap: lines that go on in its middle and at both of its sides, less those that
 * do not.
 * @param k number of the overlap, in steps
 */
export function gainAt(from: Profile, to: Profile, k: number): number {
  const parts = [
    {a: k, b: k, weight: 1},
    {a: 0, b: 2 * k, weight: outer},
    {a: 2 * k, b: 0, weight: outer},
  ];
  return parts.reduce((sum, {a, b, weight}) => {
    const [one, two] = [from[a] ?? [], to[b] ?? []];
    const isMargin = (one.length === 0 || two.length === 0) && weight < 1;
    if (isMargin) return sum - intoNothing * (one.length + two.length);
    const {meets, misses, gaps} = meetingOf(one, two);
    const off = gaps.reduce((all, gap) => all + Math.abs(gap), 0);
    return sum + weight * (meets - miss * misses - drift * off);
  }, 0);
}

export interface Meeting {
  /** Number of lines that go on, and of ends without one. */
  readonly meets: number;
  readonly misses: number;
  /** Distances between the lines that go on. */
  readonly gaps: readonly number[];
}

/** Compares the crossings of two pages with their joint. @param steps overlap's possible error */
export function meetingOf(
  a: readonly Crossing[],
  b: readonly Crossing[],
  error: number = step / 2,
): Meeting {
  const gaps: number[] = [];
  let [i, j, lost] = [0, 0, 0];
  while (i < a.length && j < b.length) {
    const [one, two] = [a[i], b[j]];
    if (!one || !two) break;
    const gap = two.at - one.at;
    const reach =
      error > 0 ? tolerance.coarse + error * Math.min(4, Math.abs(one.slope)) : tolerance.fine;
    if (Math.abs(gap) > reach) {
      lost++;
      if (gap > 0) i++;
      else j++;
      continue;
    }
    if (Math.abs(Math.atan(one.slope) - Math.atan(two.slope)) <= bend) gaps.push(gap);
    else lost += 2;
    i++;
    j++;
  }
  return {meets: gaps.length, misses: lost + (a.length - i) + (b.length - j), gaps};
}
