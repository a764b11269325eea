/** The symmetry elements of a print within a part of the plane, drawn with the usual symbols. */
import {determinant} from '../../src/model/geometry/plane-map.js';
import {
  angleOf,
  cross,
  dot,
  leftOf,
  minus,
  plus,
  towards,
  type Point,
} from '../../src/model/geometry/vectors.js';
import {latticeAround, printElements} from '../../src/model/print/wallpaper.js';
import {polyline, short} from '../../src/files/svg/written.js';
import type {Cell} from './tile.js';

/** A rotation centre: its rotations are multiples of 1 / `order` of a full turn. */
interface Centre {
  readonly at: Point;
  readonly order: number;
}

/**
 * The line of a mirror, or of a glide that is no mirror, from border to border of the visible part.
 */
interface Axis {
  readonly from: Point;
  readonly to: Point;
  readonly glide: boolean;
}

export interface Elements {
  readonly centres: readonly Centre[];
  readonly axes: readonly Axis[];
}

const tiny = 1e-6;

/**
 * The part of a line within a convex area whose corners run counter-clockwise; none when it only
 * touches.
 */
function within(
  area: readonly Point[],
  through: Point,
  along: Point,
): readonly [Point, Point] | null {
  let [enter, leave] = [-Infinity, Infinity];
  for (const [k, corner] of area.entries()) {
    const side = minus(area[(k + 1) % area.length] ?? corner, corner);
    const inside = cross(side, minus(through, corner));
    const gain = cross(side, along);
    if (Math.abs(gain) < tiny) {
      if (inside < -tiny) return null;
    } else if (gain > 0) enter = Math.max(enter, -inside / gain);
    else leave = Math.min(leave, -inside / gain);
  }
  const at = (t: number): Point => plus(through, along, t);
  return leave - enter > tiny ? [at(enter), at(leave)] : null;
}

/** All elements of the print's group in a convex area, whose corners run counter-clockwise. [cm] */
export function elementsWithin(cell: Cell, area: readonly Point[]): Elements {
  const {w1, w2} = cell;
  const centres = new Map<string, Centre>();
  const axes = new Map<string, Axis>();
  const shifts = latticeAround([w1, w2], 6);
  const inside = (p: Point): boolean =>
    area.every((corner, k) => {
      const side = minus(area[(k + 1) % area.length] ?? corner, corner);
      return cross(side, minus(p, corner)) > -tiny;
    });
  const key = (...values: number[]): string => values.map((v) => short(v + 1e-9)).join(' ');

  for (const {xx, xy, yx, yy, shift} of printElements(cell)) {
    const rotation = determinant({xx, xy, yx, yy, shift}) > 0;
    if (rotation && xx > 1 - tiny) continue;
    for (const vector of shifts) {
      const [x, y] = plus(shift, vector);
      if (rotation) {
        // the fixed point: (1 - A) c = a
        const d = (1 - xx) * (1 - yy) - xy * yx;
        const at: Point = [((1 - yy) * x + xy * y) / d, (yx * x + (1 - xx) * y) / d];
        const order = Math.round((2 * Math.PI) / Math.acos(Math.min(1, Math.max(-1, xx))));
        if (!inside(at) || order <= (centres.get(key(...at))?.order ?? 1)) continue;
        centres.set(key(...at), {at, order});
      } else {
        const along = towards(angleOf([xx, yx]) / 2);
        const slide = dot([x, y], along);
        const aside = cross(along, [x, y]) / 2;
        const line = within(area, plus([0, 0], leftOf(along), aside), along);
        const name = key(along[0], along[1], aside);
        if (!line || axes.get(name)?.glide === false) continue;
        axes.set(name, {from: line[0], to: line[1], glide: Math.abs(slide) > tiny});
      }
    }
  }
  return {centres: [...centres.values()], axes: [...axes.values()]};
}

/** The symbol of a centre at a place on the page. */
function sign({at: [x, y], order}: Centre, size: number): string {
  if (order === 2) {
    const bow = short(1.5 * size);
    const [a, b] = [-1.25, 1.25].map((way) => `${short(x)} ${short(y + way * size)}`);
    return `M${a}A${bow} ${bow} 0 0 1 ${b}A${bow} ${bow} 0 0 1 ${a}Z`;
  }
  const start = Math.PI / 2 + (order === 4 ? Math.PI / 4 : 0);
  const reach = size * (order === 3 ? 1.3 : 1.15);
  const corners = Array.from({length: order}, (_, k): Point => {
    const a = start + (2 * Math.PI * k) / order;
    return [x + reach * Math.cos(a), y - reach * Math.sin(a)];
  });
  return `${polyline(corners)}Z`;
}

interface Style {
  readonly line: string;
  readonly casing: string;
  /** Radius of the symbols. [px] */
  readonly size: number;
}

/**
 * Draws mirrors as solid lines, glides as dashed ones; centres as lens, triangle, square and
 * hexagon.
 */
export function drawElements(
  {centres, axes}: Elements,
  toPage: (p: Point) => Point,
  {line, casing, size}: Style,
): string {
  const path = (glide: boolean): string =>
    axes
      .filter((axis) => axis.glide === glide)
      .map(({from, to}) => polyline([toPage(from), toPage(to)]))
      .join('');
  const width = size / 4;
  const lines = [true, false].flatMap((glide) => {
    const data = path(glide);
    if (data === '') return [];
    const dashes = glide ? ` stroke-dasharray="${short(size)} ${short(size * 0.7)}"` : '';
    return [
      `<path d="${data}" stroke="${casing}" stroke-width="${short(width * 2.4)}" stroke-opacity=".7"${dashes}/>`,
      `<path d="${data}" stroke="${line}" stroke-width="${short(width)}"${dashes}/>`,
    ];
  });
  const signs = centres.map((centre) => sign({...centre, at: toPage(centre.at)}, size)).join('');
  return [
    `<g fill="none">${lines.join('')}</g>`,
    `<path d="${signs}" fill="${line}" stroke="${casing}" stroke-width="${short(width)}" stroke-linejoin="round"/>`,
  ].join('');
}
