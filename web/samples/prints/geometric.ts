/**
 * The geometric figures of the collection: sails, darts, bands and kites, in the style of the
 * plants.
 */
import type {Point} from '../../src/model/geometry/vectors.js';
import {
  ahead,
  blade,
  dot,
  grown,
  joined,
  polygon,
  stroke,
  together,
  type Ink,
  type Motif,
} from './shape.js';

/** A slim lens of length 1 along +y, its right edge fuller, cut along its middle. */
export const dart = (ink: Ink): Motif => [
  blade(ink, '0,0 -0.13,0.5 0.02,1', '0.17,0.48'),
  stroke('ground', '0.01,0.16 0.02,0.5 0.02,0.8', 0.028, 0.01),
];

/** A crescent of height 1 from the origin, sweeping to the left, with a cut along its back. */
export const sail = (ink: Ink): Motif => [
  blade(ink, '0,0 0.02,0.3 -0.12,0.68 -0.42,0.96', '0.26,0.3 0.27,0.62 -0.03,0.92'),
  stroke('ground', '0.09,0.14 0.16,0.45 0.04,0.74 -0.16,0.88', 0.03, 0.012),
];

/**
 * A triangular vane of a windmill, its foot at the origin, its long side along +x, with slanting
 * cuts.
 */
export function vane(ink: Ink, long: number, high: number, cuts: number): Motif {
  const edge = (x: number, y: number): Point => [x, y];
  const slits = Array.from({length: cuts}, (_, k) => {
    const x = (long * (k + 2)) / (cuts + 2);
    return stroke('ground', [edge(x - 0.6 * high, -0.1), edge(x, ((x + 0.2) * high) / long)], 0.09);
  });
  return [polygon(ink, [edge(0, 0), edge(long, 0), edge(long, high)]), ...joined(slits)];
}

/**
 * A kite along +y from its foot, its right half a little fuller, with a smaller one cut into it.
 */
export function kite(ink: Ink, long: number, wide: number, waist: number): Motif {
  const area = (size: number, foot: number): Point[] => [
    [0, foot],
    [wide * size, foot + waist * size],
    [0, foot + long * size],
    [-0.8 * wide * size, foot + 1.1 * waist * size],
  ];
  return [polygon(ink, area(1, 0)), polygon('ground', area(0.42, waist * 0.62))];
}

/**
 * A quarter of a diamond around the origin with the half axes a and b, or the band between two of
 * its sizes.
 */
export function diamond(ink: Ink, [a, b]: Point, from: number, to: number): Motif {
  const over = 0.06; // across the axes, so that the mirror images join
  const outer: Point[] = [
    [a * (to - over / b), -over],
    [a * to, 0],
    [0, b * to],
    [-over, b * (to - over / a)],
  ];
  const inner: Point[] = [
    [-over, b * from],
    [0, b * from],
    [a * from, 0],
    [a * from, -over],
  ];
  return [polygon(ink, [...outer, ...(from > 0 ? inner : [ahead([0, 0], 135, over)])])];
}

/** Darts in a quarter of a diamond, from the diamond of size `from` to that of size `to`. */
export function dartRow(ink: Ink, [a, b]: Point, from: number, to: number, count: number): Motif {
  const length = ((to - from) * a * b) / Math.hypot(a, b);
  const heading = (Math.atan2(-b, a) * 180) / Math.PI + 4;
  const feet = Array.from({length: count}, (_, k): Point => {
    const t = (k + 0.5) / count;
    return [a * from * t, b * from * (1 - t)];
  });
  return together(...feet.map((foot) => grown(dart(ink), foot, heading, length, 1.3 * length)));
}

/**
 * The half of a fan right of x = 0: its blades in alternating inks, `reach` high at the axis and
 * `spread` wide at its foot.
 */
export function halfFan(
  inks: readonly [Ink, Ink],
  blades: number,
  reach: number,
  spread: number,
): Motif {
  const step = 100 / (blades - 0.5);
  const fan = Array.from({length: blades}, (_, k) => {
    const t = (1 - k / (blades - 1)) ** 1.2;
    const long = reach * t + spread * (1 - t);
    const heading = -k * step - (k === 0 ? 3 : 0);
    return grown(dart(inks[k % 2 === 0 ? 0 : 1]), [0, 0], heading, long, 1.15 * long);
  });
  return [...together(...fan), dot('spark', [0, 0], 0.3)];
}

/** A convex area without the part further than `reach` along a direction. */
function clipped(area: readonly Point[], n: Point, reach: number): Point[] {
  const beyond = ([x, y]: Point): number => x * n[0] + y * n[1] - reach;
  return area.flatMap((from, k) => {
    const to = area[(k + 1) % area.length] ?? from;
    const [a, b] = [beyond(from), beyond(to)];
    const kept = a <= 0 ? [from] : [];
    if (a * b >= 0) return kept;
    const t = a / (a - b);
    const crossing: Point = [from[0] + (to[0] - from[0]) * t, from[1] + (to[1] - from[1]) * t];
    return [...kept, crossing];
  });
}

/**
 * Slanting bars within a block of `width` by `height` around the origin; inks, widths and following
 * gaps run across.
 */
export function thatch(
  [width, height]: Point,
  heading: number,
  bars: readonly (readonly [ink: Ink, width: number, gap: number])[],
): Motif {
  const total = bars.reduce((sum, [, bar, gap]) => sum + bar + gap, 0);
  const far = width + height;
  let across = total / 2;
  const shapes = bars.map(([ink, bar, gap]) => {
    const corner = (along: number, aside: number): Point => ahead([0, 0], heading, along, aside);
    const strip = [
      corner(-far, across),
      corner(far, across),
      corner(far, across - bar),
      corner(-far, across - bar),
    ];
    across -= bar + gap;
    const upright = clipped(clipped(strip, [1, 0], width / 2), [-1, 0], width / 2);
    return polygon(ink, clipped(clipped(upright, [0, 1], height / 2), [0, -1], height / 2));
  });
  return joined(shapes);
}
