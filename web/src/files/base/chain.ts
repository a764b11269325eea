/** Chains of lines whose ends meet. */
import type {Run} from '../../model/garment/imported-drawing.js';
import type {Point} from '../../model/geometry/vectors.js';
import {reversed, straight, type CubicFrom} from './bezier.js';

/** An open line to join. */
export interface OpenLine {
  readonly points: readonly Point[];
  /** The exact curve through the points; undefined for straight lines from point to point. */
  readonly run?: Run;
}

/** A line, or a part of it, in the direction of its chain. */
export interface Stretch extends OpenLine {
  /** Index of the line. */
  readonly id: number;
}

export interface Chain {
  readonly stretches: readonly Stretch[];
  readonly isClosed: boolean;
  /** The widest gap between the ends of consecutive lines, and its place. */
  readonly gap: {readonly width: number; readonly at: Point};
}

export const startOf = ({stretches}: Chain): Point => stretches[0]?.points[0] ?? [0, 0];

export const tipOf = ({stretches}: Chain): Point => stretches.at(-1)?.points.at(-1) ?? [0, 0];

export const turnedStretch = (stretch: Stretch): Stretch => ({
  ...stretch,
  points: [...stretch.points].reverse(),
  ...(stretch.run && {run: reversed(stretch.run)}),
});

/** Points along a chain. */
export function pointsOfChain({stretches: [first, ...others]}: Chain): readonly Point[] {
  if (others.length === 0) return first?.points ?? [];
  return [first?.points ?? [], ...others.map(({points}) => points.slice(1))].flat();
}

/** Sorts chains by the least number of their lines. */
export function sortedByFirst<T>(
  chains: readonly T[],
  numbersOf: (chain: T) => readonly number[],
): T[] {
  return chains
    .map((chain) => ({chain, first: numbersOf(chain).reduce((a, b) => Math.min(a, b), Infinity)}))
    .sort((a, b) => a.first - b.first)
    .map(({chain}) => chain);
}

/** The exact curves of a chain. */
export function runOfChain(chain: Chain): Run {
  const start = startOf(chain);
  let from = start;
  const cubics = chain.stretches.flatMap(({points, run}): readonly CubicFrom[] => {
    const own = run?.cubics ?? points.slice(1).map((to, k) => straight(points[k] ?? to, to));
    // the curves begin at the end of the line before
    const [first, ...rest] = run
      ? own
      : own.map((one, k) => (k === 0 ? straight(from, one[2]) : one));
    from = points.at(-1) ?? from;
    return first ? [first, ...rest] : [];
  });
  const last = cubics.at(-1);
  if (chain.isClosed && last) cubics[cubics.length - 1] = [last[0], last[1], start];
  return {start, cubics};
}
