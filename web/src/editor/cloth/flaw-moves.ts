/** A flaw of the cloth moved and made larger or smaller, by keys and by figures. Lengths in cm. */
import type {Bolt} from '../../marker/places.js';
import type {Point} from '../../model/geometry.js';
import {boxOf} from '../../model/polyline.js';
import type {Units} from '../../model/units.js';
import type {Flaw} from '../../workbench/lay-step.js';
import {ways} from './cloth-moves.js';

/** Of the box around a flaw, from the left edge of the cloth and from its cut edge. */
export interface FlawBox {
  readonly left: number;
  readonly start: number;
  readonly width: number;
  readonly length: number;
}

/** A flaw is at least so wide and long. */
export const leastFlaw = 0.5;
/** Further from the start nobody lays anything. */
export const mostStart = 5000;
/** What an arrow key adds, and how wide and long a flaw is at first. */
const steps: Readonly<Record<Units, number>> = {cm: 1, inch: 1.27};
const firstSizes: Readonly<Record<Units, number>> = {cm: 5, inch: 5.08};

export function boxAround(flaw: Flaw): FlawBox {
  const {low, high} = boxOf(flaw);
  return {left: low[0], start: low[1], width: high[0] - low[0], length: high[1] - low[1]};
}

const cornersOf = ({left, start, width, length}: FlawBox): Flaw => [
  [left, start],
  [left + width, start],
  [left + width, start + length],
  [left, start + length],
];

const within = (value: number, least: number, most: number): number =>
  Math.max(least, Math.min(most, value));

/** As far as the cloth goes. */
function onCloth({left, start, width, length}: FlawBox, {widthCm}: Pick<Bolt, 'widthCm'>): FlawBox {
  const wide = within(width, leastFlaw, widthCm);
  const long = within(length, leastFlaw, mostStart);
  return {
    left: within(left, 0, widthCm - wide),
    start: within(start, 0, mostStart),
    ...{width: wide, length: long},
  };
}

/** The same outline, in a box that is another. */
export function flawIn(flaw: Flaw, change: Partial<FlawBox>, bolt: Pick<Bolt, 'widthCm'>): Flaw {
  const from = boxAround(flaw);
  const to = onCloth({...from, ...change}, bolt);
  return flaw.map(([x, y]): Point => [
    to.left + ((x - from.left) * to.width) / from.width,
    to.start + ((y - from.start) * to.length) / from.length,
  ]);
}

/** A new one, a box, on whole steps of the arrow keys. */
export function flawAround([x, y]: Point, units: Units, bolt: Pick<Bolt, 'widthCm'>): Flaw {
  const size = firstSizes[units];
  const onStep = (at: number): number => steps[units] * Math.round((at - size / 2) / steps[units]);
  const [left, start] = [onStep(x), onStep(y)];
  return cornersOf(onCloth({left, start, width: size, length: size}, bolt));
}

/** What a key makes of a flaw: null where it removes it, undefined where it means nothing. With Shift arrows change its size. */
export function flawAfter(
  {key, shiftKey}: Pick<KeyboardEvent, 'key' | 'shiftKey'>,
  flaw: Flaw,
  units: Units,
  bolt: Pick<Bolt, 'widthCm'>,
): Flaw | null | undefined {
  if (key === 'Delete') return null;
  const way = ways[key];
  if (!way) return undefined;
  const [x, y] = [way[0] * steps[units], way[1] * steps[units]];
  const {left, start, width, length} = boxAround(flaw);
  if (!shiftKey) return flawIn(flaw, {left: left + x, start: start + y}, bolt);
  // what grows stays where it begins
  return flawIn(flaw, {width: Math.min(width + x, bolt.widthCm - left), length: length + y}, bolt);
}
