/** Unfolds half pieces along the fold on their outline. */
import {mappedFold} from '../model/garment/folds.js';
import type {DrawnPiece, Run} from '../model/garment/imported-drawing.js';
import {
  cross,
  distance,
  dot,
  minus,
  plus,
  turnBetween,
  unit,
  radians,
  type Point,
} from '../model/geometry/vectors.js';
import {cubicsOf, endOf, isLine, mapped, reversed, straight} from './base/bezier.js';

/** Greatest distance of the folded edge from the fold. [cm] */
const foldReach = 0.1;

/** Greatest turn at which an edge and its mirror image are joined. */
const smooth = radians(10);

interface Unfolded {
  readonly piece: DrawnPiece;
  /** The fold of a former half piece. */
  readonly axis?: readonly [Point, Point];
}

/** A mark at a point, with a second point in its direction if it has one. */
interface Mark {
  readonly at: Point;
  readonly towards?: Point;
}

type Mirror = (point: Point) => Point;

/**
 * Unfolds a piece if it has a fold.
 * @param piece in cm
 */
export function unfolded(piece: DrawnPiece): Unfolded {
  const {fold, sewn, cut, holes, notches, folds, internalLines, lineNames, drillHoles, ...rest} =
    piece;
  const whole = fold && wholeLoop(sewn, fold);
  if (!fold || !whole) return {piece};
  const mirror = mirrorIn(fold);
  const wholeCut = cut && (wholeLoop(cut, fold) ?? cut);
  const isApart = (point: Point): boolean => distance(point, mirror(point)) > foldReach;
  const image = <T extends Mark>({at, towards, ...mark}: T): Omit<T, keyof Mark> & Mark => ({
    ...mark,
    at: mirror(at),
    ...(towards && {towards: mirror(towards)}),
  });
  const doubled = <T extends Mark>(marks: readonly T[]): (Omit<T, keyof Mark> & Mark)[] =>
    marks.flatMap((mark) => (isApart(mark.at) ? [mark, image(mark)] : [mark]));
  return {
    axis: fold,
    piece: {
      ...rest,
      sewn: whole,
      ...(wholeCut && {cut: wholeCut}),
      holes: [...holes, ...holes.map((hole) => hole.map((run) => mapped(run, mirror)))],
      notches: doubled(notches),
      ...(folds && {folds: [...folds, ...folds.map((one) => mappedFold(one, mirror))]}),
      internalLines: [...internalLines, ...internalLines.map((line) => line.map(mirror))],
      ...(lineNames && {lineNames: [...lineNames, ...lineNames]}),
      drillHoles: doubled(drillHoles.map((at) => ({at}))).map(({at}) => at),
    },
  };
}

function mirrorIn([from, to]: readonly [Point, Point]): Mirror {
  const along = unit(minus(to, from));
  return (point) => {
    const off = minus(point, from);
    const foot = plus(from, along, dot(off, along));
    return plus(foot, minus(foot, point));
  };
}

/**
 * A closed line completed by the mirror image of its edges except the folded one; undefined if no
 * edge is on the fold.
 */
function wholeLoop(loop: readonly Run[], fold: readonly [Point, Point]): Run[] | undefined {
  const along = unit(minus(fold[1], fold[0]));
  const off = (point: Point): number => Math.abs(cross(along, minus(point, fold[0])));
  const isOn = (run: Run): boolean =>
    isLine(run, foldReach) && off(run.start) <= foldReach && off(endOf(run)) <= foldReach;
  const first = loop.findIndex((run, k) => isOn(run) && !isOn(loop.at(k - 1) ?? run));
  if (first < 0) return undefined;
  const turned = [...loop.slice(first), ...loop.slice(0, first)];
  const kept = turned.slice(turned.findIndex((run) => !isOn(run)));
  if (kept.length === 0 || kept.some(isOn)) return undefined;
  const onto = (point: Point): Point => plus(fold[0], along, dot(minus(point, fold[0]), along));
  const half = onFold(kept, onto);
  const mirror = mirrorIn(fold);
  const image = half.map((run) => reversed(mapped(run, mirror))).reverse();
  return joined(joined([...half, ...image], half.length), 0);
}

/** Moves both ends exactly onto the fold. */
function onFold(half: readonly Run[], onto: (point: Point) => Point): Run[] {
  const [last] = half.slice(-1);
  return half.map((run, k) => {
    const start = k === 0 ? onto(run.start) : run.start;
    if (run !== last) return {...run, start};
    const [first, second, end] = run.cubics.at(-1) ?? straight(start, start);
    return {start, cubics: [...run.cubics.slice(0, -1), [first, second, onto(end)]]};
  });
}

/** Joins the run at an index with the previous one if they meet smoothly. */
function joined(loop: readonly Run[], at: number): Run[] {
  const [before, after] = [loop.at(at - 1), loop[at]];
  if (!before || !after || loop.length <= 2) return [...loop];
  if (Math.abs(turnBetween(arriving(before), leaving(after))) > smooth) return [...loop];
  const isStraight = isLine(before, 1e-3) && isLine(after, 1e-3);
  const run: Run = {
    start: before.start,
    cubics: isStraight
      ? [straight(before.start, endOf(after))]
      : [...before.cubics, ...after.cubics],
  };
  return at === 0
    ? [run, ...loop.slice(1, -1)]
    : [...loop.slice(0, at - 1), run, ...loop.slice(at + 1)];
}

const leaving = (run: Run): Point => {
  const [first] = cubicsOf(run);
  const [start, ...rest] = first ?? [run.start];
  return minus(rest.find((point) => distance(point, start) > 1e-6) ?? start, start);
};

const arriving = (run: Run): Point => {
  const [x, y] = leaving(reversed(run));
  return [0 - x, 0 - y];
};
