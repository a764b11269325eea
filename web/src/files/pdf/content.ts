/** Operators of content streams with their numbers, in the unit of the current matrix. */
import type {Colour} from '../base/colours.js';
import type {Point} from '../../model/geometry/vectors.js';
import type {PlaneMap} from '../../model/geometry/plane-map.js';

/** Points per centimetre. */
export const pointsPerCm = 72 / 2.54;

/** Formats a number; four digits of a centimetre are a micrometre, more exact than paper. */
export const num = (value: number, digits = 4): string => String(Number(value.toFixed(digits)) + 0);

export const nums = (...values: readonly number[]): string =>
  values.map((value) => num(value)).join(' ');

/**
 * The operator for a map. Its linear part has more digits, since it is multiplied by long
 * distances.
 */
export const through = ({xx, xy, yx, yy, shift}: PlaneMap): string =>
  `${[xx, yx, xy, yy].map((value) => num(value, 8)).join(' ')} ${shift.map((value) => num(value, 5)).join(' ')} cm`;

/** Encloses content in a graphics state of its own. */
export const scoped = (...parts: readonly string[]): string =>
  ['q', ...parts.filter((part) => part !== ''), 'Q'].join('\n');

export const line = (points: readonly Point[], isClosed = false): string =>
  points.map(([x, y], k) => `${nums(x, y)} ${k === 0 ? 'm' : 'l'}`).join('\n') +
  (isClosed ? '\nh' : '');

export const box = ([x, y]: Point, width: number, height: number): string =>
  `${nums(x, y, width, height)} re`;

/** Assigns content to a layer, by its name in the page's resources. */
export const onLayer = (layer: string, ...parts: readonly string[]): string =>
  parts.every((part) => part === '') ? '' : [`/OC /${layer} BDC`, ...parts, 'EMC'].join('\n');

export const filledWith = (colour: Colour): string => `${nums(...colour)} rg`;
export const strokedWith = (colour: Colour): string => `${nums(...colour)} RG`;
