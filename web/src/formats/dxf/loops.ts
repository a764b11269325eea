/** Finds closed lines, whether drawn closed or as consecutive open lines. */
import {distance, minus, radians, turnBetween, type Point} from '../../model/geometry/vectors.js';
import {isInside, signedArea} from '../../model/geometry/polyline.js';
import {nearestOn} from '../base/nearest.js';
import type {LineEntity} from './entities.js';

export interface Loop {
  /** Points without repeating the first. */
  readonly points: readonly Point[];
  /** Indices of the points where one drawn line ends and the next begins. */
  readonly joints: readonly number[];
}

export interface Loops {
  readonly closed: readonly Loop[];
  /** Open lines that close nowhere. */
  readonly open: readonly (readonly Point[])[];
}

/** The enclosed area. */
export const areaOf = ({points}: Loop): number => Math.abs(signedArea(points));

/** Least turn of a corner between two segments; smaller turns belong to curves. */
const cornerTurn = radians(20);

/**
 * Closed and open lines.
 * @param reach greatest gap between ends that meet
 */
export function loopsOf(lines: readonly LineEntity[], reach: number): Loops {
  const closed: Loop[] = [];
  const open: (readonly Point[])[] = [];
  const ends = new Ends(reach);
  for (const {points, isClosed, isSegment = false} of lines) {
    const own = distinct(points, reach);
    if (own.length < 2) continue;
    const isWhole = isClosed || (own.length > 3 && meet(own, reach));
    if (isWhole) closed.push({points: meet(own, reach) ? own.slice(0, -1) : own, joints: []});
    else ends.add({points: own, isSegment});
  }
  for (let first = ends.any(); first; first = ends.any()) {
    const {line, joints} = chained(first, ends);
    if (line.length > 3 && meet(line, reach)) closed.push({points: line.slice(0, -1), joints});
    else open.push(line);
  }
  return {closed: closed.filter(({points}) => points.length > 2), open};
}

/** A chain of consecutive lines, and the indices of its joints. */
function chained(
  first: OpenLine,
  ends: Ends,
): {readonly line: readonly Point[]; readonly joints: readonly number[]} {
  const line = [...first.points];
  const joints: number[] = [];
  const isJoint = (before: OpenLine, after: OpenLine): boolean => {
    if (!before.isSegment || !after.isSegment) return true;
    const [from, at] = before.points.slice(-2);
    const to = after.points[1];
    return (
      !from || !at || !to || Math.abs(turnBetween(minus(at, from), minus(to, at))) > cornerTurn
    );
  };
  let before = first;
  while (!meet(line, ends.reach)) {
    const next = ends.from(line.at(-1) ?? [0, 0]);
    if (!next) break;
    if (isJoint(before, next)) joints.push(line.length - 1);
    for (const point of next.points.slice(1)) line.push(point);
    before = next;
  }
  return {line, joints: isJoint(before, first) ? [0, ...joints] : joints};
}

/** Greatest width of an allowance. [cm] */
const widest = 5;

/**
 * Least share of a sewn line's points at a constant distance from the cut line, within 0.1 cm; hems
 * have other distances.
 */
const alike = {share: 0.6, cm: 0.1};

/** Returns whether a line is a sewn line inside a cut line. */
export function isAllowance(inner: Loop, outer: Loop, cmPerUnit: number): boolean {
  const ratio = areaOf(inner) / areaOf(outer);
  if (ratio < 0.4 || ratio >= 1) return false;
  const every = Math.ceil(inner.points.length / 200); // a sample suffices
  const some = inner.points.filter((_, k) => k % every === 0);
  if (!some.every((point) => isInside(outer.points, point))) return false;
  const away = some.map((point) => nearestOn(outer.points, point, true).off * cmPerUnit);
  const usual = [...away].sort((a, b) => a - b)[Math.floor(away.length / 2)] ?? 0;
  const near = away.filter((one) => Math.abs(one - usual) <= alike.cm);
  return Math.max(...away) <= widest && near.length >= alike.share * away.length;
}

const meet = (line: readonly Point[], reach: number): boolean =>
  distance(line[0] ?? [0, 0], line.at(-1) ?? [0, 0]) <= reach;

const distinct = (points: readonly Point[], reach: number): Point[] =>
  points.filter((point, k) => k === 0 || distance(points[k - 1] ?? point, point) > reach / 100);

interface OpenLine {
  readonly points: readonly Point[];
  readonly isSegment: boolean;
}

/** Open lines indexed by their ends. */
class Ends {
  readonly reach: number;
  readonly #cells = new Map<string, Set<OpenLine>>();
  readonly #lines = new Set<OpenLine>();

  constructor(reach: number) {
    this.reach = reach;
  }

  add(line: OpenLine): void {
    this.#lines.add(line);
    for (const key of this.#keys(line)) {
      const cell = this.#cells.get(key);
      if (cell) cell.add(line);
      else this.#cells.set(key, new Set([line]));
    }
  }

  /** Removes and returns the first remaining line. */
  any(): OpenLine | undefined {
    const [line] = this.#lines;
    if (line) this.#remove(line);
    return line;
  }

  /**
   * Removes and returns the line with the end nearest to a point, reversed if needed to start
   * there.
   */
  from(point: Point): OpenLine | undefined {
    let best:
      {readonly line: OpenLine; readonly off: number; readonly isTurned: boolean} | undefined;
    for (const line of this.#near(point)) {
      const [head, tail] = endsOf(line).map((end) => distance(end, point));
      const off = Math.min(head ?? Infinity, tail ?? Infinity);
      if (off <= this.reach && !(best && best.off <= off))
        best = {line, off, isTurned: off !== head};
    }
    if (!best) return undefined;
    const {line, isTurned} = best;
    this.#remove(line);
    return isTurned ? {...line, points: [...line.points].reverse()} : line;
  }

  #remove(line: OpenLine): void {
    this.#lines.delete(line);
    for (const key of this.#keys(line)) this.#cells.get(key)?.delete(line);
  }

  *#near(point: Point): Generator<OpenLine> {
    const [column, row] = this.#cell(point);
    for (const i of [column - 1, column, column + 1]) {
      for (const j of [row - 1, row, row + 1]) yield* this.#cells.get(`${i} ${j}`) ?? [];
    }
  }

  #cell([x, y]: Point): Point {
    return [Math.floor(x / this.reach), Math.floor(y / this.reach)];
  }

  #keys(line: OpenLine): Set<string> {
    return new Set(endsOf(line).map((end) => this.#cell(end).join(' ')));
  }
}

const endsOf = ({points}: OpenLine): Point[] =>
  [points[0], points.at(-1)].flatMap((end) => (end ? [end] : []));
