/** Converts arcs and ellipses to chains of cubics. */
import type {Run} from '../../model/garment/imported-drawing.js';
import {arcAround, unitArc} from '../../model/geometry/arc.js';
import {
  distance,
  leftOf,
  middle,
  minus,
  plus,
  radians,
  type Point,
} from '../../model/geometry/vectors.js';
import {mapped, straight, type CubicFrom} from '../base/bezier.js';
import type {Vertex} from './tags.js';

/** Greatest angle of one cubic: its error is 0.004 mm at a radius of 1 m. [rad] */
const greatestStep = Math.PI / 4;

/** The way around from one angle to another, positive; a whole turn if they are equal. [rad] */
function sweepOf(from: number, to: number): number {
  const sweep = to > from ? to - from : to - from + 2 * Math.PI;
  return Math.min(sweep, 2 * Math.PI);
}

/**
 * An elliptical arc.
 * @param axis vector of the major semi-axis
 * @param ratio of the minor axis to the major axis; negative if the ellipse is seen from below
 * @param span parameters of both ends [rad]
 */
export function ellipseRun(
  centre: Point,
  axis: Point,
  ratio: number,
  [from, to]: readonly [number, number],
): Run {
  return mapped(unitArc(from, sweepOf(from, to), greatestStep), ([c, s]) =>
    plus(plus(centre, axis, c), leftOf(axis), s * ratio),
  );
}

/**
 * A circular arc.
 * @param angles of both ends, counter-clockwise [degrees]
 */
export const arcRun = (centre: Point, radius: number, [from, to]: readonly [number, number]): Run =>
  ellipseRun(centre, [radius, 0], 1, [radians(from), radians(to)]);

export const circleRun = (centre: Point, radius: number): Run =>
  ellipseRun(centre, [radius, 0], 1, [0, 2 * Math.PI]);

/** A polyline with arcs. A bulge is the tangent of a quarter of the arc's angle. */
export function bulgeRun(vertices: readonly Vertex[], isClosed: boolean): Run {
  const cubics = vertices.flatMap(({at, bulge}, k): readonly CubicFrom[] => {
    const next = vertices[k + 1] ?? (isClosed ? vertices[0] : undefined);
    if (!next || distance(at, next.at) === 0) return [];
    if (bulge === 0) return [straight(at, next.at)];
    const off = (1 / bulge - bulge) / 4;
    const centre = plus(middle(at, next.at), leftOf(minus(next.at, at)), off);
    const arc = arcAround(centre, at, 4 * Math.atan(bulge), greatestStep);
    const last = arc.at(-1);
    return last ? [...arc.slice(0, -1), [last[0], last[1], next.at]] : [];
  });
  return {start: vertices[0]?.at ?? [0, 0], cubics};
}
