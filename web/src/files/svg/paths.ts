/** Converts the shapes of an SVG to moves, lines and cubics. */
import svgpath from 'svgpath';

import {fieldOf} from '../../model/base/read.js';
import {between, type Point} from '../../model/geometry/vectors.js';
import type {XmlElement} from '../base/xml.js';
import {lengthOf, numbersOf} from './values.js';

/** A move, a line, a cubic, or the closing of a subpath, named as PDF's operators. */
export interface PathStep {
  readonly kind: 'm' | 'l' | 'c' | 'h';
  /** Control points, and the end; none for a closing. */
  readonly points: readonly Point[];
}

/** Lengths of 100 per cent: across, down, and in any other direction. */
const wholeOf = (name: string, [across, down]: Point): number =>
  /^(?:c?x\d?|rx|width)$/.test(name)
    ? across
    : /^(?:c?y\d?|ry|height)$/.test(name)
      ? down
      : Math.hypot(across, down) / Math.SQRT2;

/**
 * The path data of an element; undefined if it is no shape.
 * @param view width and height of the view, for lengths in per cent
 */
export function pathOf({name, attributes}: XmlElement, view: Point): string | undefined {
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
    const [x = 0, y = 0, r = 0] = at('cx', 'cy', 'r');
    const [across, up] = name === 'circle' ? [r, r] : radii(length('rx'), length('ry'));
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

/** The steps of path data: those before its first fault, as browsers draw it. */
export function stepsOf(data: string): {
  readonly steps: readonly PathStep[];
  readonly isDamaged: boolean;
} {
  const parsed = svgpath(data);
  const isDamaged = Boolean(fieldOf(parsed, 'err'));
  const steps: PathStep[] = [];
  parsed
    .abs()
    .unshort()
    .unarc()
    .iterate((segment, _, x, y) => {
      steps.push(stepOf(segment, [x, y]));
    });
  return {steps, isDamaged};
}

function stepOf(segment: readonly (string | number)[], from: Point): PathStep {
  const [kind, ...numbers] = segment as [string, ...number[]];
  const [p = 0, q = 0, r = 0, s = 0, t = 0, u = 0] = numbers;
  switch (kind) {
    case 'M':
      return {kind: 'm', points: [[p, q]]};
    case 'L':
      return {kind: 'l', points: [[p, q]]};
    case 'H':
      return {kind: 'l', points: [[p, from[1]]]};
    case 'V':
      return {kind: 'l', points: [[from[0], p]]};
    case 'Q':
      return {
        kind: 'c',
        points: [between(from, [p, q], 2 / 3), between([r, s], [p, q], 2 / 3), [r, s]],
      };
    case 'C':
      return {
        kind: 'c',
        points: [
          [p, q],
          [r, s],
          [t, u],
        ],
      };
    default:
      return {kind: 'h', points: []};
  }
}
