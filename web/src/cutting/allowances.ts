/** Seam allowances of edges, and their shape at corners. Lengths in cm, angles in radians. */
import type {PanelMarks} from '../model/garment/panel-marks.js';
import {minus, unit, type Point} from '../model/geometry/vectors.js';
import {crossingsOf, distanceTo} from '../model/geometry/polyline.js';
import type {ResultPiece} from '../model/result/result.js';
import {pick} from '../scene/marks.js';
import type {AllowanceRule} from './allowance-rule.js';
import {bandOf, type CornerPlan, type Own} from './corners.js';
import {cornerOf, type EdgeEnd, type EdgeKey, type GarmentEdges} from './garment-edges.js';
import {hems} from './openings.js';

export interface Allowances {
  readonly widths: ReadonlyMap<EdgeKey, number>;
  /** Edges whose width is stated or drawn in the garment, and therefore overrides the rule. */
  readonly own: ReadonlySet<EdgeKey>;
  /** Corners, by the edge that begins there. */
  readonly corners: ReadonlyMap<EdgeKey, CornerPlan>;
  readonly hems: ReadonlySet<EdgeKey>;
}

/** The share of edges with their own width. */
export type OwnShare = 'none' | 'some' | 'all';

/**
 * The share of edges with their own width.
 * @param held for each edge, whether it has its own width
 */
export const ownShare = (held: readonly boolean[]): OwnShare =>
  !held.includes(true) ? 'none' : held.includes(false) ? 'some' : 'all';

/** A drawn cut line farther away belongs to another edge. */
const greatestWidth = 12;
/** Least angle of a seam's end, from 0 and from 180 degrees, at which it is cut across. */
const leastAngle = 0.35;
/** Cut ends whose reaches differ by less meet. */
const sameReach = 0.03;
/** Equal angles of two mirrored corners, whose cut ends meet. [rad] */
const sameAngle = 0.05;
/** Greatest extension of a seam, in widths of the allowance beyond it. */
const greatestReach = 2.5;

/** The drawn allowance: the median distance of the cut line. */
function drawnWidth(
  {rest}: ResultPiece,
  vertices: readonly number[],
  cutLine: readonly Point[],
): number | undefined {
  const apart = pick(rest, vertices)
    .map((p) => distanceTo(cutLine, p))
    .sort((a, b) => a - b);
  const median = apart[Math.floor(apart.length / 2)] ?? Infinity;
  return median < greatestWidth ? Math.round(1000 * median) / 1000 : undefined;
}

/** One side of a seam at the seam's end. */
interface Cut {
  /** Interior angle of the piece. */
  readonly angle: number;
  /** Allowance of the next edge, whose cut line crosses the seam. */
  readonly width: number;
  /** Distance from the end of the seam to the cut. */
  readonly reach: number;
}

/** The distance beyond the end of an edge where the next edge's cut line crosses it. */
function crossedAt(garment: GarmentEdges, end: EdgeEnd, width: number): number | undefined {
  const points = garment.edges.get(end.key)?.edge.points ?? [];
  const [from, to] = end.at === 'end' ? points.slice(-2) : points.slice(0, 2).reverse();
  const beyond = garment.edges.get(cornerOf(garment, end).other)?.edge.points ?? [];
  if (!from || !to) return undefined;
  const {cut} = bandOf(beyond, width);
  const along = unit(minus(to, from));
  // the line is open: its closing segment does not count
  const found = cut
    .slice(1)
    .flatMap((q, k) => crossingsOf([cut[k] ?? q, q], to, along).slice(0, 1));
  const ahead = found.filter((at) => at > 0);
  return ahead.length > 0 ? Math.min(...ahead) : undefined;
}

function cutOf(garment: GarmentEdges, widths: Allowances['widths'], end: EdgeEnd): Cut | undefined {
  const {other, turn} = cornerOf(garment, end);
  const angle = Math.PI - turn;
  const width = widths.get(other) ?? 0;
  if (angle < leastAngle || angle > Math.PI - leastAngle || width === 0) return undefined;
  return {angle, width, reach: crossedAt(garment, end, width) ?? width / Math.sin(angle)};
}

/**
 * The common length at which both sides of a seam are cut off so that their ends meet; undefined if
 * they already meet.
 */
function commonReach(one: Cut, two: Cut): number | undefined {
  const isSame = Math.abs(one.reach - two.reach) < sameReach;
  if (isSame && Math.abs(one.angle - two.angle) < sameAngle) return undefined;
  const [less, more] = one.reach < two.reach ? [one, two] : [two, one];
  // an acute tip extends beyond its neighbour's allowance, so cutting it off takes nothing from the
  // neighbour
  const mayBeCut = more.angle < Math.PI / 2 && less.reach >= more.width * Math.sin(more.angle);
  const reach = mayBeCut ? less.reach : more.reach;
  return reach <= greatestReach * less.width ? reach : undefined;
}

/** Allowances defined by the garment: stated at the edge, otherwise from the drawn cut line. */
const ownWidths = (
  garment: GarmentEdges,
  pieces: readonly ResultPiece[],
  marks: readonly PanelMarks[],
): ReadonlyMap<EdgeKey, number> =>
  new Map(
    [...garment.edges].flatMap(([key, {edge, piece, loop}]) => {
      const {cutLine} = marks[piece]?.drafted ?? {};
      const result = pieces[piece];
      const drawn =
        cutLine && result && loop === 0 ? drawnWidth(result, edge.vertices, cutLine) : undefined;
      const width = edge.drafted?.allowance?.width ?? drawn;
      return width === undefined ? [] : [[key, width] as const];
    }),
  );

const ends = ['start', 'end'] as const;

/** The allowances of all edges of a garment and the corners between them. */
export function allowancesOf(
  garment: GarmentEdges,
  pieces: readonly ResultPiece[],
  marks: readonly PanelMarks[],
  {allowanceCm, hemCm = allowanceCm}: AllowanceRule,
): Allowances {
  const hem = hems(garment, marks);
  const own = ownWidths(garment, pieces, marks);
  const ruled = (key: EdgeKey): number => (hem.has(key) ? hemCm : allowanceCm);
  const widths = new Map([...garment.edges.keys()].map((key) => [key, own.get(key) ?? ruled(key)]));
  const corners = new Map<EdgeKey, CornerPlan>();
  const plan = (end: EdgeEnd, change: (own: Own, known: CornerPlan) => CornerPlan): void => {
    const [key, own] =
      end.at === 'start'
        ? ([end.key, 'after'] as const)
        : ([cornerOf(garment, end).other, 'before'] as const);
    corners.set(key, change(own, corners.get(key) ?? {}));
  };
  const square = (end: EdgeEnd, reach: number): void => {
    plan(end, (own, known) => ({...known, square: {...known.square, [own]: reach}}));
  };
  const turned = (end: EdgeEnd): void => {
    plan(end, (own, known) => ({...known, turned: own}));
  };

  for (const [a, b] of garment.seamEnds) {
    const [one, two] = [a, b].map((end) => cutOf(garment, widths, end));
    const reach = one && two && commonReach(one, two);
    if (reach !== undefined) for (const end of [a, b]) square(end, reach);
  }
  for (const key of hem) {
    for (const at of ends) {
      const {other} = cornerOf(garment, {key, at});
      const isWider = (widths.get(key) ?? 0) > (widths.get(other) ?? 0);
      if (isWider && !hem.has(other)) turned({key, at});
    }
  }
  for (const [key, {edge}] of garment.edges) {
    const corner = edge.drafted?.allowance?.corner;
    for (const at of corner ? ends : []) {
      const end = {key, at};
      const reach = cutOf(garment, widths, end)?.reach;
      if (corner === 'mirror') turned(end);
      else if (corner === 'square' && reach !== undefined) square(end, reach);
      else plan(end, () => ({}));
    }
  }
  return {widths, own: new Set(own.keys()), corners, hems: hem};
}
