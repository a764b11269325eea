/** Converts SVG shapes to chains of cubics. */
import svgpath from 'svgpath';

import type {Run} from '../../model/garment/imported-drawing.js';
import {between, distance, type Point} from '../../model/geometry/vectors.js';
import {fieldOf} from '../../model/base/read.js';
import type {XmlElement} from '../base/xml.js';
import {endOf, straight, type CubicFrom} from '../base/bezier.js';
import {lengthOf, mapped, numbersOf, type Matrix} from './matrix.js';

/** A subpath. */
export interface Line extends Run {
  readonly isClosed: boolean;
}

/** Lengths of 100 per cent: across, down, and in any other direction. */
const wholeOf = (name: string, [across, down]: Point): number =>
  /^(?:c?x\d?|rx|width)$/.test(name)
    ? across
    : /^(?:c?y\d?|ry|height)$/.test(name)
      ? down
      : Math.hypot(across, down) / Math.SQRT2;

/** The path data of an element; undefined if it is no shape. */
function pathOf({name, attributes}: XmlElement, view: Point): string | undefined {
  const length = (one: string): number | undefined =>
    lengthOf(attributes.get(one), wholeOf(one, view));
  const at = (...names: string[]): number[] => names.map((one) => length(one) ?? 0);
  if (name === 'path') return attributes.get('d') ?? '';
  if (name === 'polygon' || name === 'polyline') {
    const numbers = numbersOf(attributes.get('points'));
    const even = numbers.slice(0, numbers.length - (numbers.length % 2)).join(' ');
    return even === '' ? '' : `M${even}${name === 'polygon' ? 'z' : ''}`;
  }
  if (name === 'line') {
    const [x = 0, y = 0, toX = 0, toY = 0] = at('x1', 'y1', 'x2', 'y2');
    return `M${x} ${y}L${toX} ${toY}`;
  }
  if (name === 'rect')
    return rectangle(at('x', 'y', 'width', 'height'), radii(length('rx'), length('ry')));
  if (name === 'circle' || name === 'ellipse') {
    const [x = 0, y = 0, r = 0, rx = r, ry = r] = at('cx', 'cy', 'r');
    const across = name === 'circle' ? rx : (at('rx')[0] ?? 0);
    const up = name === 'circle' ? ry : (at('ry')[0] ?? 0);
    return oval(x, y, across, up);
  }
  return undefined;
}

const oval = (x: number, y: number, rx: number, ry: number): string =>
  rx > 0 && ry > 0
    ? `M${x - rx} ${y}A${rx} ${ry} 0 0 1 ${x + rx} ${y}A${rx} ${ry} 0 0 1 ${x - rx} ${y}z`
    : '';

const radii = (rx: number | undefined, ry: number | undefined): readonly [number, number] => [
  rx ?? ry ?? 0,
  ry ?? rx ?? 0,
];

function rectangle(
  [x = 0, y = 0, width = 0, height = 0]: readonly number[],
  [rx, ry]: readonly [number, number],
): string {
  if (!(width > 0 && height > 0)) return '';
  const [a, b] = [Math.min(rx, width / 2), Math.min(ry, height / 2)];
  if (!(a > 0 && b > 0)) return `M${x} ${y}h${width}v${height}h${-width}z`;
  const corner = (toX: number, toY: number): string => `a${a} ${b} 0 0 1 ${toX} ${toY}`;
  return `M${x + a} ${y}h${width - 2 * a}${corner(a, b)}v${height - 2 * b}${corner(-a, b)}h${2 * a - width}${corner(-a, -b)}v${2 * b - height}${corner(a, -b)}z`;
}

/** Greatest distance between ends that meet. [mm] */
export const meeting = 0.1;

/**
 * The transformed lines of a shape; undefined if it is none. Reads the valid prefix of an invalid
 * path, as browsers do.
 * @param view width and height of the view, for lengths in per cent
 */
export function linesOf(
  element: XmlElement,
  matrix: Matrix,
  view: Point,
): {readonly lines: readonly Line[]; readonly isDamaged: boolean} | undefined {
  const path = pathOf(element, view);
  if (path === undefined) return undefined;
  const lines: Line[] = [];
  let pen: {start: Point; cubics: CubicFrom[]; closes: boolean} | undefined;
  const finish = (): void => {
    if (pen && pen.cubics.length > 0) lines.push(closedIfMet(pen.start, pen.cubics, pen.closes));
    pen = undefined;
  };
  const parsed = svgpath(path);
  const isDamaged = Boolean(fieldOf(parsed, 'err'));
  parsed
    .abs()
    .unshort()
    .unarc()
    .iterate((segment, _, x, y) => {
      const from = mapped(matrix, [x, y]);
      if (segment[0] === 'M') finish();
      else pen ??= {start: from, cubics: [], closes: false};
      if (!pen) return;
      const next = cubicOf(segment, [x, y], matrix);
      if (next) pen.cubics.push(next);
      if (segment[0] !== 'Z' && segment[0] !== 'z') return;
      pen.closes = true;
      finish();
    });
  finish();
  return {lines, isDamaged};
}

function closedIfMet(start: Point, cubics: CubicFrom[], closes: boolean): Line {
  const line = {start, cubics};
  const gap = distance(endOf(line), start);
  if (!closes && gap > meeting) return {...line, isClosed: false};
  if (gap > meeting) cubics.push(straight(endOf(line), start));
  const last = cubics.pop();
  if (last) cubics.push([last[0], last[1], start]);
  return {...line, isClosed: true};
}

/** A segment as a cubic; undefined if it draws nothing. */
function cubicOf(
  segment: readonly (string | number)[],
  from: Point,
  matrix: Matrix,
): CubicFrom | undefined {
  const [kind, ...numbers] = segment as [string, ...number[]];
  const [p = 0, q = 0, r = 0, s = 0, t = 0, u = 0] = numbers;
  const at = (x: number, y: number): Point => mapped(matrix, [x, y]);
  switch (kind) {
    case 'L':
      return straight(at(...from), at(p, q));
    case 'H':
      return straight(at(...from), at(p, from[1]));
    case 'V':
      return straight(at(...from), at(from[0], p));
    case 'Q':
      return [at(...between(from, [p, q], 2 / 3)), at(...between([r, s], [p, q], 2 / 3)), at(r, s)];
    case 'C':
      return [at(p, q), at(r, s), at(t, u)];
    default:
      return undefined;
  }
}
