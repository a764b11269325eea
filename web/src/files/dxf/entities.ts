/**
 * Reads the entities of a DXF file that patterns use: lines, points, text and blocks. Lengths in
 * the file's unit, y up.
 */
import type {Run} from '../../model/garment/imported-drawing.js';
import {plus, radians, towards, type Point} from '../../model/geometry/vectors.js';
import {boxOf} from '../../model/geometry/polyline.js';
import {mapped, tracedRun} from '../base/bezier.js';
import {longerSide} from '../base/closed-lines.js';
import {splineThrough} from '../base/splines.js';
import {arcRun, bulgeRun, circleRun, ellipseRun} from './curved.js';
import {splineRun} from './nurbs.js';
import type {Group, Vertex} from './tags.js';
import {plainText} from './text.js';

interface OnLayer {
  readonly layer: string;
}

export interface LineEntity extends OnLayer {
  readonly kind: 'line';
  readonly points: readonly Point[];
  /** The exact curve; undefined if lines run from point to point. */
  readonly run?: Run;
  readonly isClosed: boolean;
  /**
   * True for a LINE. Curves are drawn with many of them, too, so their ends need not be corners.
   */
  readonly isSegment?: boolean;
}

export interface PointEntity extends OnLayer {
  readonly kind: 'point';
  readonly at: Point;
  /** Depth of a notch. */
  readonly depth?: number;
  readonly width?: number;
  /** A second point in the direction of a notch. */
  readonly towards?: Point;
}

export interface TextEntity extends OnLayer {
  readonly kind: 'text';
  readonly at: Point;
  readonly text: string;
}

export interface InsertEntity extends OnLayer {
  readonly kind: 'insert';
  readonly block: string;
  readonly at: Point;
  readonly scale: Point;
  /** [degrees] */
  readonly angle: number;
  /** Columns and rows of copies, and the distances between them. */
  readonly copies: {readonly counts: Point; readonly steps: Point};
}

export type Entity = LineEntity | PointEntity | TextEntity | InsertEntity;

/**
 * Greatest bulge: beyond it, an arc is a circle with a gap. A bulge is the tangent of a quarter of
 * the arc's angle.
 */
const greatestBulge = 100;

/** Greatest number of vertices; outlines have hundreds. */
export const mostVertices = 20_000;

/** Greatest degree of a spline in a pattern. */
const greatestDegree = 10;

const line = (layer: string, points: readonly Point[], isClosed = false): LineEntity => ({
  kind: 'line',
  layer,
  points,
  isClosed,
});

/** Greatest deviation of points from their curve, as a share of its size. */
const tracing = 2e-5;

/** A line along exact curves, with points close to them. */
function curve(layer: string, run: Run, isClosed = false): LineEntity {
  const size = longerSide(boxOf([run.start, ...run.cubics.flat()]));
  return {...line(layer, tracedRun(run, tracing * size || 1), isClosed), run};
}

const layerOf = (group: Group): string => group.text(8).trim();

/** Returns whether an entity is drawn on a plane that is seen from below. */
const isFromBelow = (group: Group): boolean => group.number(230, 1) < 0;

/** The map from coordinates on an entity's plane, whose x axis is reversed from below. */
const frameOf = (group: Group): ((point: Point) => Point) =>
  isFromBelow(group) ? ([x, y]) => [0 - x, y] : (point) => point;

type Reader = (group: Group) => Entity | undefined;

const readers: Readonly<Record<string, Reader>> = {
  LINE: (group) => ({
    ...line(layerOf(group), [group.point(10), group.point(11)]),
    isSegment: true,
  }),
  ARC: (group) => {
    const angles = [group.number(50), group.number(51)] as const;
    const run = arcRun(group.point(10), group.number(40), angles);
    return curve(layerOf(group), mapped(run, frameOf(group)));
  },
  CIRCLE: (group) =>
    curve(
      layerOf(group),
      mapped(circleRun(group.point(10), group.number(40)), frameOf(group)),
      true,
    ),
  // the centre and the axis are in world coordinates; from below, the other axis is reversed
  ELLIPSE: (group) => {
    const span = [group.number(41, 0), group.number(42, 2 * Math.PI)] as const;
    const ratio = group.number(40) * (isFromBelow(group) ? -1 : 1);
    const run = ellipseRun(group.point(10), group.point(11), ratio, span);
    return curve(layerOf(group), run, Math.abs(span[1] - span[0]) > 2 * Math.PI - 1e-6);
  },
  LWPOLYLINE: (group) => polyline(group, group.vertices(), frameOf(group)),
  SPLINE: (group) => curve(layerOf(group), spline(group), (group.number(70, 0) & 1) === 1),
  POINT: (group) => {
    const [depth, width] = [30, 39].map((code) => Math.abs(group.number(code, 0)));
    const at = group.point(10);
    const angle = group.number(50, NaN);
    return {
      ...{kind: 'point', layer: layerOf(group), at},
      ...(Number.isFinite(angle) && {towards: plus(at, towards(radians(angle)))}),
      ...(depth && {depth}),
      ...(width && {width}),
    };
  },
  TEXT: (group) => words(group, group.text(1), frameOf(group)),
  MTEXT: (group) =>
    words(
      group,
      group.tags.flatMap(({code, value}) => (code === 1 || code === 3 ? [value] : [])).join(''),
      (point) => point,
    ),
  INSERT: (group) => {
    const frame = frameOf(group);
    return {
      ...{kind: 'insert', layer: layerOf(group), block: group.text(2).trim()},
      at: frame([group.number(10, 0), group.number(20, 0)]),
      scale: frame([group.number(41, 1), group.number(42, 1)]),
      angle: group.number(50, 0) * (isFromBelow(group) ? -1 : 1),
      copies: {
        counts: [Math.max(1, group.number(70, 1)), Math.max(1, group.number(71, 1))],
        steps: frame([group.number(44, 0), group.number(45, 0)]),
      },
    };
  },
};

/**
 * The entity of a group; undefined if patterns do not use it.
 * @param vertices records of a polyline's vertices
 * @throws {FileError} for invalid entities
 */
export function entityOf(group: Group, vertices: readonly Group[]): Entity | undefined {
  if (group.type === 'POLYLINE') return oldPolyline(group, vertices);
  return Object.hasOwn(readers, group.type) ? readers[group.type]?.(group) : undefined;
}

const words = (group: Group, text: string, frame: (point: Point) => Point): TextEntity => ({
  ...{kind: 'text', layer: layerOf(group), text: plainText(text)},
  at: frame([group.number(10, 0), group.number(20, 0)]),
});

/** A polyline with one record per vertex; vertices that control a spline frame are skipped. */
function oldPolyline(group: Group, vertices: readonly Group[]): Entity | undefined {
  const flags = group.number(70, 0);
  const isMesh = (flags & (16 | 64)) > 0;
  if (isMesh) return undefined;
  const isInSpace = (flags & 8) > 0;
  const drawn = vertices.filter((vertex) => (vertex.number(70, 0) & 16) === 0);
  return polyline(
    group,
    drawn.map((vertex) => ({at: vertex.point(10), bulge: vertex.number(42, 0)})),
    isInSpace ? (point) => point : frameOf(group),
  );
}

function polyline(
  group: Group,
  vertices: readonly Vertex[],
  frame: (point: Point) => Point,
): LineEntity {
  if (vertices.length > mostVertices) throw group.error('has more points than any outline');
  const tooFar = vertices.find(({bulge}) => Math.abs(bulge) > greatestBulge);
  if (tooFar) throw group.error(`has an arc of bulge ${tooFar.bulge}, which no line has`);
  const isClosed = (group.number(70, 0) & 1) === 1;
  const isStraight = vertices.every(({bulge}) => bulge === 0);
  return isStraight
    ? line(
        layerOf(group),
        vertices.map(({at}) => frame(at)),
        isClosed,
      )
    : curve(layerOf(group), mapped(bulgeRun(vertices, isClosed), frame), isClosed);
}

function spline(group: Group): Run {
  const controls = group.vertices(10).map(({at}) => at);
  const through = group.vertices(11).map(({at}) => at);
  const degree = group.number(71, 3);
  const knots = group.numbers(40);
  const isSound =
    degree >= 1 &&
    degree <= greatestDegree &&
    controls.length > degree &&
    knots.length === controls.length + degree + 1;
  if (isSound) return splineRun(controls, {degree, knots, weights: group.numbers(41)});
  const [start] = through;
  if (!start || through.length < 2) throw group.error('has no control points');
  return {start, cubics: splineThrough(through, 'natural')};
}
