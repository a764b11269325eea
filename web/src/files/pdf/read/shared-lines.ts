/**
 * Sizes share lines that are drawn once: where the own lines of a size end on a line of another
 * size, the part between two such ends belongs to it, too. Lengths in mm.
 */
import {distance, type Point} from '../../../model/geometry/vectors.js';
import {lengthOf} from '../../../model/geometry/polyline.js';
import type {Near} from '../../../model/geometry/nearest.js';
import {gridOfPoints, pointsOnLine, type PointGrid} from '../../base/point-grid.js';
import {Ends} from '../../base/ends.js';
import type {InkLine} from './ink.js';
import {byStyle, joinedLines} from './styles.js';

/** Greatest distance between an end and the line on which it lies. */
const reach = 0.4;

interface End {
  readonly at: Point;
  /** Number of the chain that ends here. */
  readonly chain: number;
}

interface Bridge {
  readonly ends: readonly [End, End];
  readonly points: readonly Point[];
  readonly length: number;
}

/** The parts of other lines that close the own ones. */
export function sharedParts(own: readonly InkLine[], others: readonly InkLine[]): InkLine[] {
  const chains = [...byStyle(own).values()].flatMap(joinedLines).filter(({isClosed}) => !isClosed);
  const ends = chains.flatMap(({points}, chain): End[] => [
    {at: points[0] ?? [0, 0], chain},
    {at: points.at(-1) ?? [0, 0], chain},
  ]);
  const all = new Ends(
    chains.map((_, k) => ends.slice(2 * k, 2 * k + 2).map(({at}) => at)),
    reach,
  );
  const loose = gridOfPoints(
    ends.filter(({at}) => all.countAt(at, 2) === 1),
    reach,
  );
  const lines = [...byStyle(others).values()].flatMap(joinedLines);
  const bridges = lines
    .flatMap((line) => bridgesOn(line, loose))
    .sort((a, b) => a.length - b.length);
  const used = new Set<End>();
  return bridges.flatMap(({ends: [a, b], points}): InkLine[] => {
    if (used.has(a) || used.has(b)) return [];
    used.add(a).add(b);
    const style = chains[a.chain]?.style;
    return style ? [{points, isClosed: false, style}] : [];
  });
}

/** The parts of a line between each two of the ends on it. */
function bridgesOn({points, isClosed}: InkLine, ends: PointGrid<End>): Bridge[] {
  const on = [...pointsOnLine(points, isClosed, ends, reach)].map(([end, near]) => ({end, near}));
  return on.flatMap((a, k) =>
    on.slice(k + 1).flatMap((b): Bridge[] => {
      const ways = [
        between(points, a.near, b.near, isClosed),
        ...(isClosed ? [between(points, b.near, a.near, true)] : []),
      ];
      const [best] = ways
        .map((way) => ({way, length: lengthOf(way)}))
        .sort((one, two) => one.length - two.length);
      return best && best.length > reach
        ? [{ends: [a.end, b.end], points: best.way, length: best.length}]
        : [];
    }),
  );
}

/** The points from one place on a line to another. */
function between(points: readonly Point[], a: Near, b: Near, isRound: boolean): Point[] {
  const along = (near: Near): number =>
    near.step + Math.min(0.999, distance(points[near.step] ?? near.at, near.at) / 1e6);
  const isBackwards = along(b) < along(a);
  if (isBackwards && !isRound) return between(points, b, a, false).reverse();
  const count = isBackwards ? b.step + points.length - a.step : b.step - a.step;
  const inner = Array.from(
    {length: count},
    (_, k) => points[(a.step + 1 + k) % points.length] ?? a.at,
  );
  return [a.at, ...inner, b.at];
}
