/** Converts path data of pdf.js to lines. */
import {apply, type PlaneMap} from '../../../model/geometry/plane-map.js';
import type {Point} from '../../../model/geometry/vectors.js';
import {tracedRun, type CubicFrom} from '../../base/bezier.js';

/** Codes in path data. */
const codes = {move: 0, line: 1, curve: 2, quadratic: 3, close: 4};

/** Greatest deviation of traced curves. [mm] */
const tolerance = 0.02;

interface PathLine {
  readonly points: readonly Point[];
  readonly isClosed: boolean;
}

const isFinitePoint = ([x, y]: Point): boolean => Number.isFinite(x) && Number.isFinite(y);

/**
 * The lines of a path, with curves as points.
 * @param map from units of the content to mm
 */
export function linesOfPath(data: ArrayLike<number>, map: PlaneMap): PathLine[] {
  const lines: PathLine[] = [];
  let points: Point[] = [];
  const finish = (isClosed: boolean): void => {
    const rim = isClosed && samePlace(points[0], points.at(-1)) ? points.slice(0, -1) : points;
    if (rim.length > 1 && rim.every(isFinitePoint)) lines.push({points: rim, isClosed});
  };
  const at = (k: number): Point => apply(map, [data[k] ?? NaN, data[k + 1] ?? NaN]);
  const here = (): Point => points.at(-1) ?? [NaN, NaN];
  for (let k = 0; k < data.length;) {
    const code = data[k++];
    if (code === codes.move) {
      finish(false);
      points = [at(k)];
      k += 2;
    } else if (code === codes.line) {
      points.push(at(k));
      k += 2;
    } else if (code === codes.curve || code === codes.quadratic) {
      const isCubic = code === codes.curve;
      const curve: CubicFrom = isCubic
        ? [at(k), at(k + 2), at(k + 4)]
        : raised(here(), at(k), at(k + 2));
      const traced = tracedRun({start: here(), cubics: [curve]}, tolerance);
      for (const point of traced.slice(1)) points.push(point);
      k += isCubic ? 6 : 4;
    } else if (code === codes.close) {
      const [start] = points;
      finish(true);
      points = start ? [start] : [];
    } else break;
  }
  finish(samePlace(points[0], points.at(-1)) && points.length > 3);
  return lines;
}

/** A quadratic curve as a cubic one. */
const raised = (from: Point, control: Point, to: Point): CubicFrom => {
  const share = (end: Point): Point => [
    end[0] + (2 / 3) * (control[0] - end[0]),
    end[1] + (2 / 3) * (control[1] - end[1]),
  ];
  return [share(from), share(to), to];
};

/** Greatest distance between the ends of a closed line. [mm] */
const meeting = 0.01;

const samePlace = (a: Point | undefined, b: Point | undefined): boolean =>
  a !== undefined && b !== undefined && a !== b && Math.hypot(a[0] - b[0], a[1] - b[1]) <= meeting;
