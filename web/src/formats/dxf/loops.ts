/** Closed lines: those that are drawn as such, and open ones that follow each other head to tail. */
import {distance, minus, radians, turnBetween, type Point} from '../../model/geometry.js';
import {isInside, signedArea} from '../../model/polyline.js';
import {nearestOn} from '../base/nearest.js';
import type {LineEntity} from './entities.js';

export interface Loop {
  /** None of them twice. */
  readonly points: readonly Point[];
  /** Numbers of the points at which one drawn line ends and the next begins. */
  readonly joints: readonly number[];
}

export interface Loops {
  readonly closed: readonly Loop[];
  /** Lines that lead nowhere. */
  readonly open: readonly (readonly Point[])[];
}

/** What a closed line goes round. */
export const areaOf = ({points}: Loop): number => Math.abs(signedArea(points));

/** Between two segments a lesser turn is part of a curve that is drawn by them. */
const cornerTurn = radians(20);

/** @param reach how far apart ends may be that meet */
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

/** A line with all that follow it, and the numbers of the points at which they do. */
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

/** No allowance is wider. [cm] */
const widest = 5;

/** Points of a sewn line that lie at one distance from the cut one, to within 1 mm: those of hems lie elsewhere. */
const alike = {share: 0.6, cm: 0.1};

/** Whether a line runs around inside another as the sewn one does in the cut one. */
export function isAllowance(inner: Loop, outer: Loop, cmPerUnit: number): boolean {
  const ratio = areaOf(inner) / areaOf(outer);
  if (ratio < 0.4 || ratio >= 1) return false;
  const every = Math.ceil(inner.points.length / 200); // enough to tell
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

/** Open lines by where they end. */
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

  /** The first that is left. */
  any(): OpenLine | undefined {
    const [line] = this.#lines;
    if (line) this.#remove(line);
    return line;
  }

  /** The one with the end that is nearest to a point, turned so that it begins there. */
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
