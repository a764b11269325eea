/** Finds arrows: straight lines with a head at one end or both, as grain lines are drawn. [mm] */
import {cross, distance, dot, minus, unit, type Point} from '../../model/geometry/vectors.js';
import {boxOf} from '../../model/geometry/polyline.js';
import {PointGrid} from './point-grid.js';

interface DrawnLine {
  readonly points: readonly Point[];
  readonly isClosed: boolean;
  readonly style: {readonly isFilled: boolean};
}

/** Least length of an arrow, and greatest size of its heads. */
const shortest = 15;
const largestHead = 20;

/** Greatest distance between the end of an arrow and its head. */
const touching = 0.8;

/** Greatest deviation of an arrow from a straight line. */
const straightness = 0.2;

/** An end of a straight line, which may be the tip of an arrow. */
interface Tip<T> {
  readonly line: T;
  readonly at: Point;
  /** Direction towards the tip. */
  readonly along: Point;
  readonly heads: Set<T>;
}

/** Greatest number of tips in one place; more are those of rays or hatching. */
const mostTips = 20;

function isStraightLine({points, isClosed}: DrawnLine): boolean {
  const [from, to] = [points[0], points.at(-1)];
  if (isClosed || !from || !to || distance(from, to) < shortest) return false;
  const along = unit(minus(to, from));
  return points.every((p) => Math.abs(cross(along, minus(p, from))) <= straightness);
}

const isSmall = ({points}: DrawnLine): boolean => {
  const {low, high} = boxOf(points);
  return Math.max(high[0] - low[0], high[1] - low[1]) <= largestHead;
};

/** Returns whether a small line is the head of an arrow at its tip: its points lie behind the tip. */
function isHead({points}: DrawnLine, tip: Point, along: Point): boolean {
  const at = points.map((p) => minus(p, tip));
  const near = at.some((off) => Math.hypot(...off) <= touching);
  const behind = at.every((off) => dot(off, along) <= touching);
  const asides = at.map((off) => cross(along, off));
  const isWide = Math.max(...asides.map(Math.abs)) > touching;
  return near && behind && isWide && at.some((off) => dot(off, along) < -touching);
}

/** Returns whether heads lie on both sides of an arrow; a stroke on one side is a tick or a corner. */
function isTwoSided(heads: readonly DrawnLine[], tip: Point, along: Point): boolean {
  const asides = heads.flatMap(({points}) => points.map((p) => cross(along, minus(p, tip))));
  return Math.max(...asides) > touching && Math.min(...asides) < -touching;
}

/** Greatest width of an arrow with its heads in one path, and least length in widths. */
const slender = {width: 10, ratio: 6};

/** The straight line of an arrow that is drawn as one filled path; undefined for other lines. */
function inOnePath<T extends DrawnLine>(line: T): T | undefined {
  const {points, style} = line;
  const [first] = points;
  if (!first || !style.isFilled || points.length < 5 || points.length > 16) return undefined;
  const farthest = (from: Point): Point =>
    points.reduce((best, p) => (distance(from, p) > distance(from, best) ? p : best), from);
  const to = farthest(first);
  const from = farthest(to);
  const length = distance(from, to);
  if (length < shortest) return undefined;
  const along = unit(minus(to, from));
  const asides = points.map((p) => cross(along, minus(p, from)));
  const width = Math.max(...asides) - Math.min(...asides);
  const isArrow = width > touching && width <= slender.width && length >= slender.ratio * width;
  return isArrow ? {...line, points: [from, to], isClosed: false} : undefined;
}

/** The ends of straight lines, with the heads that are drawn there. */
function tipsOf<T extends DrawnLine>(lines: readonly T[]): readonly Tip<T>[] {
  const tips = lines.filter(isStraightLine).flatMap((line): Tip<T>[] => {
    const [from, to]: [Point, Point] = [line.points[0] ?? [0, 0], line.points.at(-1) ?? [0, 0]];
    return [
      {line, at: to, along: unit(minus(to, from)), heads: new Set()},
      {line, at: from, along: unit(minus(from, to)), heads: new Set()},
    ];
  });
  const grid = new PointGrid<Tip<T>>(touching);
  for (const tip of tips) grid.add(tip.at, tip);
  for (const line of lines.filter(isSmall)) {
    for (const point of line.points) {
      const cells = grid.around(point);
      if (cells.reduce((sum, {length}) => sum + length, 0) > mostTips) continue;
      for (const {at, along, heads} of cells.flat()) {
        if (!heads.has(line) && isHead(line, at, along)) heads.add(line);
      }
    }
  }
  return tips;
}

/** Divides lines into arrows and others; heads of arrows are in neither. */
export function arrowsIn<T extends DrawnLine>(
  lines: readonly T[],
): {readonly arrows: readonly T[]; readonly rest: readonly T[]} {
  const tips = tipsOf(lines).filter(({heads}) => heads.size > 0);
  const pointed = new Set(
    tips.flatMap(({line, at, along, heads}) => (isTwoSided([...heads], at, along) ? [line] : [])),
  );
  const whole = lines.flatMap((line) => {
    const arrow = inOnePath(line);
    return arrow ? [{line, arrow}] : [];
  });
  const used = new Set([
    ...pointed,
    ...tips.flatMap(({line, heads}) => (pointed.has(line) ? [...heads] : [])),
    ...whole.map(({line}) => line),
  ]);
  return {
    arrows: [...pointed, ...whole.map(({arrow}) => arrow)],
    rest: lines.filter((line) => !used.has(line)),
  };
}
