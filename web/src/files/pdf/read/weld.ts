/** Joins the parts of lines that were cut at the sides of pages, and nothing else. [mm] */
import {distance, type Point} from '../../../model/geometry/vectors.js';
import {PointGrid} from '../../base/point-grid.js';
import type {InkLine} from './ink.js';
import {byStyle} from './styles.js';

/** Greatest distance between the end of a line and the side of a page at which it was cut. */
const atCut = 0.02;

/** Greatest distance between both ends of a cut line on their pages. */
const reach = 0.4;

/** Greatest number of ends in one place; more are those of hatching or a picture. */
const mostEnds = 20;

/** An end of a part at a cut. */
interface CutEnd {
  readonly at: Point;
  readonly part: number;
  readonly isLast: boolean;
}

/** @param corners corners of the boxes at which lines were cut */
export function weldedLines(lines: readonly InkLine[], corners: readonly Point[]): InkLine[] {
  const places = ([0, 1] as const).map(
    (axis) => new Set(corners.map((corner) => corner[axis].toFixed(1))),
  );
  const isAtCut = (point: Point): boolean =>
    ([0, 1] as const).some((axis) =>
      [-atCut, 0, atCut].some((off) => places[axis]?.has((point[axis] + off).toFixed(1)) === true),
    );
  return [...byStyle(lines).values()].flatMap((some) => weldedParts(some, isAtCut));
}

function weldedParts(parts: readonly InkLine[], isAtCut: (point: Point) => boolean): InkLine[] {
  const ends = parts.flatMap(({points, isClosed}, part): CutEnd[] => {
    const [first, last] = [points[0], points.at(-1)];
    if (isClosed || !first || !last) return [];
    return [
      {at: first, part, isLast: false},
      {at: last, part, isLast: true},
    ].filter(({at}) => isAtCut(at));
  });
  const partners = partnersOf(ends);
  const endOf = new Map(ends.map((end) => [`${end.part} ${end.isLast}`, end]));
  const used = new Set<number>();
  /** The parts that follow an end, and whether the line returns to its start. */
  const follow = (part: number, isLast: boolean, onto: Point[]): boolean => {
    for (let end = endOf.get(`${part} ${isLast}`); end;) {
      const next = partners.get(end);
      if (!next) return false;
      if (used.has(next.part)) return next.part === part;
      used.add(next.part);
      const points = parts[next.part]?.points ?? [];
      for (const p of next.isLast ? points.slice(0, -1).reverse() : points.slice(1)) onto.push(p);
      end = endOf.get(`${next.part} ${!next.isLast}`);
    }
    return false;
  };
  return parts.flatMap((line, part): InkLine[] => {
    if (used.has(part)) return [];
    used.add(part);
    const points = [...line.points];
    if (follow(part, true, points)) {
      const isDouble = distance(points[0] ?? [0, 0], points.at(-1) ?? [0, 0]) <= reach;
      return [{...line, points: isDouble ? points.slice(0, -1) : points, isClosed: true}];
    }
    const before: Point[] = [];
    follow(part, false, before);
    return [{...line, points: [...before.reverse(), ...points]}];
  });
}

/** For each end, the nearest end of a line on the other page. */
function partnersOf(ends: readonly CutEnd[]): ReadonlyMap<CutEnd, CutEnd> {
  const grid = new PointGrid<CutEnd>(reach);
  for (const end of ends) grid.add(end.at, end);
  const pairs = ends.flatMap((end) => {
    const near = grid.around(end.at);
    if (near.reduce((sum, {length}) => sum + length, 0) > mostEnds) return [];
    return near
      .flat()
      .filter((other) => other !== end)
      .map((other) => ({end, other, off: distance(end.at, other.at)}))
      .filter(({off}) => off <= reach);
  });
  const partners = new Map<CutEnd, CutEnd>();
  for (const {end, other} of pairs.sort((a, b) => a.off - b.off)) {
    if (partners.has(end) || partners.has(other)) continue;
    partners.set(end, other).set(other, end);
  }
  return partners;
}
