/** The edges of a GarmentCode panel as drawn, for the checks of results. */
import type {GarmentCodeSpecification, PanelEdge, Point} from 'seamwise/node';

import {distance, middle, minus, plus, rotated, turnBetween} from '@/model/geometry/vectors.js';
import {alongLine, at, scale} from '../plane.js';

const steps = 60;

/** An edge as a polyline in the panel's own coordinates and units. */
function tracedEdge(
  vertices: readonly Point[],
  {endpoints, curvature}: PanelEdge,
  isAbsolute: boolean,
): Point[] {
  const [from, to] = [at(vertices, endpoints[0]), at(vertices, endpoints[1])];
  const along = minus(to, from);
  const control = ([x, y]: Point): Point =>
    isAbsolute ? [x, y] : plus(plus(from, scale(along, x)), scale([-along[1], along[0]], y));
  const fractions = Array.from({length: steps + 1}, (_, k) => k / steps);
  if (curvature && 'type' in curvature && curvature.type === 'circle') {
    return arc(from, to, curvature.params, fractions);
  }
  if (curvature && 'type' in curvature && curvature.type === 'path') {
    return curvature.params.reduce<Point[]>(
      (line, cubic) => {
        const ends = cubic.map(control);
        const controls = [line.at(-1) ?? from, ...ends, ...(ends.length < 3 ? [to] : [])];
        return [...line, ...fractions.slice(1).map((t) => bezier(controls, t))];
      },
      [from],
    );
  }
  const points = !curvature ? [] : 'type' in curvature ? curvature.params : [curvature];
  const controls = [from, ...points.map((p) => control(p)), to];
  return fractions.map((t) => bezier(controls, t));
}

function bezier(controls: readonly Point[], t: number): Point {
  if (controls.length === 1) return at(controls, 0);
  return bezier(
    alongLine(controls).map(([p, q]) => plus(scale(p, 1 - t), scale(q, t))),
    t,
  );
}

/** Traces an arc by its radius, large-arc flag, and right-hand flag. */
function arc(
  from: Point,
  to: Point,
  [radius, large, right]: readonly number[],
  fractions: readonly number[],
): Point[] {
  const chord = minus(to, from);
  const half = distance(from, to) / 2;
  const r = Math.max(radius ?? 0, half);
  const left: Point = scale([-chord[1], chord[0]], 1 / (2 * half));
  const side = (right ? 1 : -1) * (large ? -1 : 1);
  const centre = plus(middle(from, to), scale(left, side * Math.sqrt(r * r - half * half)));
  const short = Math.abs(turnBetween(minus(from, centre), minus(to, centre)));
  const angle = (right ? 1 : -1) * (large ? 2 * Math.PI - short : short);
  return fractions.map((t) => plus(centre, rotated(minus(from, centre), t * angle)));
}

/** Every edge of a panel in centimetres, x negated where the piece shows its other face. */
export function drawnOutline(
  {pattern, properties}: GarmentCodeSpecification,
  name: string,
  isMirrored: boolean,
): Point[][] {
  const panel = pattern.panels[name];
  const unit = 100 / (properties?.units_in_meter ?? 100);
  const isAbsolute = properties?.curvature_coords === 'absolute';
  return (panel?.edges ?? []).map((edge) =>
    tracedEdge(panel?.vertices ?? [], edge, isAbsolute).map(([x, y]): Point => [
      isMirrored ? -x * unit : x * unit,
      y * unit,
    ]),
  );
}
