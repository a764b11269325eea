/** Finds the open edges of a garment, grouped into openings, and the hems among them. */
import {minus, turnBetween, type Point} from '../model/geometry/vectors.js';
import type {PanelMarks} from '../model/garment/panel-marks.js';
import {lengthOf} from '../model/geometry/polyline.js';
import {turned} from '../layout/on-body.js';
import {cornerOf, type EdgeEnd, type EdgeKey, type GarmentEdges} from './garment-edges.js';

/** Greatest turn at which an open edge continues in the next edge. [rad] */
const smoothTurn = 0.5;
/** Greatest turn of a hem, which otherwise would not lie flat when turned up. [rad] */
const greatestTurn = 0.7;
/**
 * Least cosine of the angle between a hem's outward normal and the direction down, or down the arm.
 */
const leastDown = 0.6;
/** Pieces with their middle farther aside are on an arm. [cm] */
const armAside = 25;

/** The total absolute turn of a line. [rad] */
const turnOf = (points: readonly Point[]): number =>
  points.slice(2).reduce((sum, c, k) => {
    const [a = c, b = c] = points.slice(k, k + 2);
    return sum + Math.abs(turnBetween(minus(b, a), minus(c, b)));
  }, 0);

/** The outward vector of a line, normal to its chord and of the same length. */
function outOf(points: readonly Point[]): Point {
  const [first = [0, 0], last = first] = [points[0], points.at(-1)];
  const [x, y] = minus(last, first);
  return [y, -x];
}

/**
 * The share of an edge's outward normal that points down, or down the arm, on the body; -1 to 1.
 */
function downwards(
  points: readonly Point[],
  outline: readonly Point[],
  marks?: PanelMarks,
): number {
  const [x, y] = outOf(points);
  const length = Math.hypot(x, y) || 1;
  const {placement, grain} = marks ?? {};
  if (!placement) {
    const [gx, gy] = grain ? minus(grain[1], grain[0]) : [0, 1];
    // for a piece drawn along the fabric roll, the upper end is unknown
    return Math.abs(gx) > Math.abs(gy) ? 0 : -y / length;
  }
  const {rotation = [0, 0, 0], translation} = placement;
  const out = turned([x / length, y / length, 0], rotation);
  const mean = (axis: 0 | 1) => outline.reduce((sum, p) => sum + p[axis], 0) / outline.length;
  const aside = translation[0] + turned([mean(0), mean(1), 0], rotation)[0];
  if (Math.abs(aside) < armAside) return -out[1];
  return (Math.sign(aside) * out[0] - out[1]) / Math.SQRT2;
}

/** Groups of consecutive open edges, on one piece or across a seam. */
function openings(garment: GarmentEdges): readonly (readonly EdgeKey[])[] {
  const {edges, seamEnds} = garment;
  const open = new Set([...edges.keys()].filter((key) => !edges.get(key)?.edge.seam));
  const joined = new Map<EdgeKey, EdgeKey[]>();
  const join = (a: EdgeKey, b: EdgeKey): void => {
    if (!open.has(a) || !open.has(b)) return;
    joined.set(a, [...(joined.get(a) ?? []), b]);
    joined.set(b, [...(joined.get(b) ?? []), a]);
  };
  for (const key of open) {
    const {other, turn} = cornerOf(garment, {key, at: 'end'});
    if (Math.abs(turn) < smoothTurn) join(key, other);
  }
  const beyond = (end: EdgeEnd): EdgeKey => cornerOf(garment, end).other;
  for (const [a, b] of seamEnds) join(beyond(a), beyond(b));
  const groups: EdgeKey[][] = [];
  const seen = new Set<EdgeKey>();
  for (const start of open) {
    if (seen.has(start)) continue;
    const group = [start];
    seen.add(start);
    for (const key of group) {
      for (const next of joined.get(key) ?? []) {
        if (!seen.has(next)) group.push(next);
        seen.add(next);
      }
    }
    groups.push(group);
  }
  return groups;
}

/**
 * The hems of a garment: openings at the bottom or at the end of an arm that turn little. Pieces
 * without a position on the body are assumed to be drawn upright.
 */
export function hems(garment: GarmentEdges, marks: readonly PanelMarks[]): ReadonlySet<EdgeKey> {
  const found = openings(garment).filter((group) => {
    let [down, total] = [0, 0];
    let turn = 0;
    for (const key of group) {
      const one = garment.edges.get(key);
      if (!one || one.loop > 0) return false;
      const {points} = one.edge;
      const length = lengthOf(points);
      total += length;
      down += length * downwards(points, garment.outlines[one.piece] ?? [], marks[one.piece]);
      turn = Math.max(turn, turnOf(points));
    }
    return down > leastDown * total && turn < greatestTurn;
  });
  return new Set(found.flat());
}
