/** Reads the values of SVG attributes: numbers, lengths and transforms. */
import {paperUnits} from '../base/units.js';
import type {XmlElement} from '../base/xml.js';
import {
  after,
  determinant,
  identity,
  planeMap,
  scaling,
  shifting,
  turning,
  type PlaneMap,
} from '../../model/geometry/plane-map.js';
import {radians, type Point} from '../../model/geometry/vectors.js';

/** The mean scale factor of lengths. */
export const growth = (map: PlaneMap): number => Math.sqrt(Math.abs(determinant(map)));

/** Returns whether a map collapses the plane to a line or a point. */
export const isFlat = (map: PlaneMap): boolean =>
  !(growth(map) ** 2 > 1e-6 * Math.hypot(map.xx, map.xy, map.yx, map.yy) ** 2);

const tan = (degrees: number): number => Math.tan(radians(degrees));

/** One function of a `transform`; undefined for a wrong number of arguments. */
function step(name: string, n: readonly number[]): PlaneMap | undefined {
  const [p = 0, q, r = 0, s = 0, t = 0, u = 0] = n;
  if (name === 'matrix' && n.length === 6) return planeMap(p, r, q ?? 0, s, t, u);
  if (name === 'translate' && n.length <= 2) return shifting(p, q ?? 0);
  if (name === 'scale' && n.length <= 2) return scaling(p, q ?? p);
  if (name === 'rotate' && n.length === 1) return turning(p);
  if (name === 'rotate' && n.length === 3) {
    return after(shifting(q ?? 0, r), after(turning(p), shifting(-(q ?? 0), -r)));
  }
  if (name === 'skewX' && n.length === 1) return planeMap(1, tan(p), 0, 1);
  return name === 'skewY' && n.length === 1 ? planeMap(1, 0, tan(p), 1) : undefined;
}

/** Numbers of a list separated by spaces or commas. */
export const numbersOf = (list: string | undefined): number[] =>
  (list ?? '').match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/gi)?.map(Number) ?? [];

/**
 * The scales of a view box in its view by `preserveAspectRatio`.
 * @param across view's width divided by that of its box
 * @param down the same of the heights
 */
export function fitOf(rule: string | undefined, across: number, down: number): Point {
  const words = (rule ?? '').trim().split(/\s+/);
  if (words[0] === 'none') return [across, down];
  const scale = words.includes('slice') ? Math.max(across, down) : Math.min(across, down);
  return [scale, scale];
}

/** User units per unit of a length; 1 for a unit that SVG does not know. */
export function userUnits(unit: string): number {
  const millimetres = paperUnits[unit];
  if (millimetres !== undefined) return (millimetres * 96) / 25.4;
  return unit === 'em' ? 16 : unit === 'ex' ? 8 : 1; // of the usual font size
}

/**
 * A length in user units; undefined if it is missing or invalid.
 * @param whole length of 100 per cent
 */
export function lengthOf(value: string | undefined, whole: number): number | undefined {
  const [number] = numbersOf(value);
  if (number === undefined) return undefined;
  const [, unit = ''] = /^[-+.\d]+(?:e[-+]?\d+)?([a-z%]*)/i.exec((value ?? '').trim()) ?? [];
  return unit === '%' ? (number / 100) * whole : number * userUnits(unit.toLowerCase());
}

/** The map of a `transform` attribute; undefined if it is invalid. */
export function transformOf(transform: string | undefined): PlaneMap | undefined {
  let whole = identity;
  const rest = (transform ?? '').replaceAll(
    /([a-z]{1,12}[XY]?)\s{0,9}\(([^()]{0,400})\)/gi,
    (_, name: string, list: string) => {
      const numbers = numbersOf(list);
      const next = numbers.length > 0 ? step(name, numbers) : undefined;
      if (next) whole = after(whole, next);
      return next ? '' : '?';
    },
  );
  const {xx, xy, yx, yy, shift} = whole;
  const isFinite = [xx, xy, yx, yy, ...shift].every(Number.isFinite);
  return /^[\s,]*$/.test(rest) && isFinite ? whole : undefined;
}

/** The reference of a `use`, in today's form or the former one; empty if it is missing. */
export const hrefOf = ({attributes}: XmlElement): string =>
  (attributes.get('href') ?? attributes.get('xlink:href') ?? '').trim();
