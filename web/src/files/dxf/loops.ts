/** Finds closed lines, whether drawn closed or as consecutive open lines. */
import type {Run} from '../../model/garment/imported-drawing.js';
import {distance, minus, radians, turnBetween, type Point} from '../../model/geometry/vectors.js';
import {signedArea} from '../../model/geometry/polyline.js';
import {pointsOfChain, runOfChain, type Chain} from '../base/chain.js';
import {chainsOf} from '../base/chains.js';
import type {LineEntity} from './entities.js';

/** Gap between the ends of two lines. */
export interface Gap {
  readonly width: number;
  readonly at: Point;
}

export interface Loop {
  /** Points without repeating the first. */
  readonly points: readonly Point[];
  /** Indices of the points where one drawn line ends and the next begins. */
  readonly joints: readonly number[];
  /** The exact curve, if the file draws any. */
  readonly exact?: Run;
  readonly gap?: Gap;
  readonly layer: string;
  /** A cut-out that may be a line drawn on the piece. */
  readonly isDoubtful?: boolean;
}

/** Open lines that close nowhere. */
interface OpenChain {
  readonly points: readonly Point[];
  readonly layer: string;
}

export interface Loops {
  readonly closed: readonly Loop[];
  readonly open: readonly OpenChain[];
}

/** The enclosed area. */
export const areaOf = ({points}: Loop): number => Math.abs(signedArea(points));

/** Loops in order of their areas, the largest first. */
export const bySize = (loops: readonly Loop[]): Loop[] =>
  [...loops].sort((a, b) => areaOf(b) - areaOf(a));

/** Least turn of a corner between two segments; smaller turns belong to curves. */
const cornerTurn = radians(20);

/**
 * Closed and open lines.
 * @param reach greatest gap between ends that meet
 */
export function loopsOf(lines: readonly LineEntity[], reach: number): Loops {
  const closed: Loop[] = [];
  const single: LineEntity[] = [];
  for (const line of lines) {
    const points = distinct(line.points, reach);
    const {run, layer} = line;
    if (points.length < 2) continue;
    if (line.isClosed || (points.length > 3 && meet(points, reach / 30))) {
      closed.push({
        points: meet(points, reach / 30) ? points.slice(0, -1) : points,
        joints: [],
        ...(run && {exact: run}),
        layer,
      });
    } else single.push({...line, points});
  }
  const chains = chainsOf(single, reach);
  const layerOf = ({stretches}: Chain): string => single[stretches[0]?.id ?? 0]?.layer ?? '';
  return {
    closed: [
      ...closed,
      ...chains.filter(({isClosed}) => isClosed).map((chain) => loopOf(chain, single)),
    ].filter(({points}) => points.length > 2),
    open: chains
      .filter(({isClosed}) => !isClosed)
      .map((chain) => ({points: pointsOfChain(chain), layer: layerOf(chain)})),
  };
}

/** A closed chain as a loop, with joints at the ends of its lines. */
function loopOf(chain: Chain, lines: readonly LineEntity[]): Loop {
  const {stretches, gap} = chain;
  const isJoint = (k: number): boolean => {
    const [before, after] = [stretches.at(k - 1), stretches[k]];
    if (!before || !after) return true;
    if (lines[before.id]?.isSegment !== true || lines[after.id]?.isSegment !== true) return true;
    const [from, at] = before.points.slice(-2);
    const to = after.points[1];
    return (
      !from || !at || !to || Math.abs(turnBetween(minus(at, from), minus(to, at))) > cornerTurn
    );
  };
  let count = 0;
  const joints = stretches.flatMap(({points}, k) => {
    const at = count;
    count += points.length - 1;
    return isJoint(k) ? [at] : [];
  });
  const hasCurves = stretches.some(({run}) => run);
  return {
    points: pointsOfChain(chain).slice(0, -1),
    joints,
    ...(hasCurves && {exact: runOfChain(chain)}),
    ...(gap.width > 0 && {gap}),
    layer: lines[stretches[0]?.id ?? 0]?.layer ?? '',
  };
}

const meet = (line: readonly Point[], reach: number): boolean =>
  distance(line[0] ?? [0, 0], line.at(-1) ?? [0, 0]) <= reach;

const distinct = (points: readonly Point[], reach: number): Point[] =>
  points.filter((point, k) => k === 0 || distance(points[k - 1] ?? point, point) > reach / 100);
