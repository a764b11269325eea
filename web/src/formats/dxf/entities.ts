/**
 * Reads the entities of a DXF file that patterns use: lines, points, text and blocks. Lengths in
 * the file's unit, y up.
 */
import type {Point} from '../../model/geometry/vectors.js';
import {splineThrough} from '../base/splines.js';
import {tracedRun} from '../base/bezier.js';
import {bulgePoints, circlePoints, circularPoints, ellipsePoints, splinePoints} from './curved.js';
import type {Group, Vertex} from './tags.js';
import {plainText} from './text.js';

interface OnLayer {
  readonly layer: string;
}

export interface LineEntity extends OnLayer {
  readonly kind: 'line';
  readonly points: readonly Point[];
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

const layerOf = (group: Group): string => group.text(8).trim();

/** Coordinates of entities with a downward extrusion direction have the x axis reversed. */
const frameOf = (group: Group): ((point: Point) => Point) =>
  group.number(230, 1) < 0 ? ([x, y]) => [0 - x, y] : (point) => point;

type Reader = (group: Group) => Entity | undefined;

const readers: Readonly<Record<string, Reader>> = {
  LINE: (group) => ({
    ...line(layerOf(group), [group.point(10), group.point(11)]),
    isSegment: true,
  }),
  ARC: (group) => {
    const angles = [group.number(50), group.number(51)] as const;
    const points = circularPoints(group.point(10), group.number(40), angles);
    return line(layerOf(group), points.map(frameOf(group)));
  },
  CIRCLE: (group) =>
    line(layerOf(group), circlePoints(group.point(10), group.number(40)).map(frameOf(group)), true),
  ELLIPSE: (group) => {
    const span = [group.number(41, 0), group.number(42, 2 * Math.PI)] as const;
    const points = ellipsePoints(group.point(10), group.point(11), group.number(40), span);
    return line(layerOf(group), points, Math.abs(span[1] - span[0]) > 2 * Math.PI - 1e-6);
  },
  LWPOLYLINE: (group) => polyline(group, group.vertices()),
  SPLINE: (group) => line(layerOf(group), spline(group), (group.number(70, 0) & 1) === 1),
  POINT: (group) => {
    const [depth, width] = [30, 39].map((code) => Math.abs(group.number(code, 0)));
    return {
      ...{kind: 'point', layer: layerOf(group), at: group.point(10)},
      ...(depth && {depth}),
      ...(width && {width}),
    };
  },
  TEXT: (group) => words(group, group.text(1)),
  MTEXT: (group) =>
    words(
      group,
      group.tags.flatMap(({code, value}) => (code === 1 || code === 3 ? [value] : [])).join(''),
    ),
  INSERT: (group) => ({
    ...{kind: 'insert', layer: layerOf(group), block: group.text(2).trim()},
    at: frameOf(group)([group.number(10, 0), group.number(20, 0)]),
    scale: frameOf(group)([group.number(41, 1), group.number(42, 1)]),
    angle: group.number(50, 0),
  }),
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

const words = (group: Group, text: string): TextEntity => ({
  ...{kind: 'text', layer: layerOf(group), text: plainText(text)},
  at: [group.number(10, 0), group.number(20, 0)],
});

/** A polyline with one record per vertex; vertices that control a spline frame are skipped. */
function oldPolyline(group: Group, vertices: readonly Group[]): Entity | undefined {
  const isMesh = (group.number(70, 0) & (16 | 64)) > 0;
  if (isMesh) return undefined;
  const drawn = vertices.filter((vertex) => (vertex.number(70, 0) & 16) === 0);
  return polyline(
    group,
    drawn.map((vertex) => ({at: vertex.point(10), bulge: vertex.number(42, 0)})),
  );
}

function polyline(group: Group, vertices: readonly Vertex[]): LineEntity {
  if (vertices.length > mostVertices) throw group.error('has more points than any outline');
  const tooFar = vertices.find(({bulge}) => Math.abs(bulge) > greatestBulge);
  if (tooFar) throw group.error(`has an arc of bulge ${tooFar.bulge}, which no line has`);
  const isClosed = (group.number(70, 0) & 1) === 1;
  return line(layerOf(group), bulgePoints(vertices, isClosed).map(frameOf(group)), isClosed);
}

function spline(group: Group): readonly Point[] {
  const controls = group.vertices(10).map(({at}) => at);
  const through = group.vertices(11).map(({at}) => at);
  const degree = group.number(71, 3);
  const knots = group.numbers(40);
  const isSound =
    degree >= 1 &&
    degree <= greatestDegree &&
    controls.length > degree &&
    knots.length === controls.length + degree + 1;
  if (isSound) return splinePoints(controls, {degree, knots, weights: group.numbers(41)});
  const [start] = through;
  if (!start || through.length < 2) throw group.error('has no control points');
  return tracedRun({start, cubics: splineThrough(through, 'natural')}, 1e-3);
}
