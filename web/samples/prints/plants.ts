/**
 * Parts of plants in the style of a block print: flat areas, with veins and folds cut out of them.
 */
import type {Point} from '../../src/model/geometry/vectors.js';
import {
  ahead,
  along,
  blade,
  dot,
  grown,
  joined,
  pebble,
  stroke,
  together,
  type Ink,
  type Motif,
  type Trace,
} from './shape.js';

const origin: Point = [0, 0];

/**
 * A leaf of length 1, fuller to its left, its tip bent to the right, with a cut rib and pairs of
 * side veins.
 */
export function leaf(ink: Ink = 'leaf', veins = 3): Motif {
  const vein = (from: Point, to: Point) => stroke('ground', [from, to], 0.022, 0.008);
  const sides = Array.from({length: veins}, (_, k) => {
    const y = 0.17 + 0.17 * k;
    const reach = 0.15 - 0.03 * k;
    return [
      vein([-0.02, y], [-0.02 - reach, y + 0.14]),
      vein([0, y + 0.06], [reach * 0.86, y + 0.2]),
    ];
  });
  return [
    blade(ink, '0,0 -0.15,0.2 -0.235,0.46 -0.13,0.78 0.1,1', '0.1,0.2 0.19,0.5 0.165,0.8'),
    ...joined([stroke('ground', '0,0.06 -0.025,0.45 0.055,0.84', 0.034, 0.008), ...sides.flat()]),
  ];
}

/** A narrow leaf of length 1, bent to the right, with a cut along its rib. */
export const willow = (ink: Ink = 'leaf'): Motif => [
  blade(ink, '0,0 -0.1,0.3 -0.045,0.68 0.16,1', '0.075,0.3 0.15,0.68'),
  stroke('ground', '0,0.08 -0.005,0.4 0.075,0.78', 0.03, 0.008),
];

/** A petal of length 1 with a notched, fuller left half. */
const petal = (ink: Ink): Motif => [
  pebble(ink, '0,0 -0.17,0.3 -0.36,0.66 -0.25,0.96 0,0.93 0.2,0.99 0.33,0.72 0.15,0.3'),
  ...joined([
    stroke('ground', '-0.02,0.42 -0.05,0.74', 0.03, 0.015),
    stroke('ground', '0.07,0.45 0.13,0.68', 0.025, 0.012),
    stroke('ground', '-0.1,0.45 -0.2,0.68', 0.025, 0.012),
  ]),
];

/** A flower seen from above, of radius 1, its lower petals shorter, with a heart of dots. */
export function blossom(ink: Ink = 'bloom', heart: Ink = 'spark', petals = 5): Motif {
  const lengths = [1, 0.97, 0.88, 0.84, 0.94, 0.98, 0.9, 0.95];
  const crown = Array.from({length: petals}, (_, k) => {
    const length = lengths[k % lengths.length] ?? 1;
    return grown(petal(ink), origin, 8 + (360 * k) / petals, length, (5 / petals) * length);
  });
  const stamens = Array.from({length: 6}, (_, k) =>
    dot(heart, ahead(origin, 20 + 60 * k, 0.33 + 0.03 * (k % 2)), 0.055),
  );
  return [
    ...together(...crown),
    dot('ground', origin, 0.25),
    ...joined([dot(heart, [0.01, -0.01], 0.16), ...stamens]),
  ];
}

/** A flower seen from the side, opening along +y from its foot; about 1 high and 1 wide. */
export const cup = (ink: Ink = 'bloom', inner: Ink = 'soft'): Motif => [
  ...joined([
    blade(inner, '-0.05,0.1 -0.36,0.42 -0.27,0.8 -0.17,1.04', '0.02,0.4 0,0.75'),
    blade(inner, '0.02,0.1 0.02,0.5 0.12,0.8 0.27,1', '0.26,0.36 0.34,0.72'),
  ]),
  ...joined([
    blade(ink, '0,0 -0.34,0.14 -0.53,0.5 -0.5,0.92', '-0.12,0.3 -0.24,0.62'),
    blade(ink, '0,0 0.12,0.3 0.27,0.58 0.54,0.82', '0.33,0.12 0.56,0.42'),
    blade(ink, '0,0 -0.17,0.3 -0.17,0.62 0.05,0.92', '0.17,0.28 0.21,0.6'),
  ]),
  ...joined([
    stroke('ground', '-0.1,0.12 -0.3,0.36 -0.39,0.62', 0.035, 0.012),
    stroke('ground', '0.1,0.1 0.29,0.3 0.4,0.52', 0.035, 0.012),
    stroke('ground', '0.0,0.3 0.01,0.64', 0.035, 0.012),
  ]),
];

/** A berry of radius 1 with a light cut into it. */
export const berry = (ink: Ink = 'spark'): Motif => [
  dot(ink, origin, 1),
  stroke('ground', '-0.55,0.1 -0.4,0.45 -0.05,0.6', 0.2, 0.1),
];

/** A bud of length 1 in its sepals. */
export const bud = (ink: Ink = 'bloom', sepal: Ink = 'line'): Motif => [
  blade(ink, '0,0.1 -0.24,0.42 -0.15,0.78 0.06,1', '0.22,0.4 0.2,0.74'),
  stroke('ground', '0.03,0.45 0,0.66 0.06,0.84', 0.045, 0.02),
  ...joined([
    blade(sepal, '0,0 -0.2,0.14 -0.24,0.3 -0.2,0.52', '-0.02,0.16 -0.06,0.3'),
    blade(sepal, '0,0 0.02,0.16 0.08,0.3 0.2,0.44', '0.15,0.12 0.21,0.26'),
  ]),
];

/**
 * A shoot of a stem: its motif, its place along the stem (0 to 1), its angle to it, its size; a
 * negative angle is to the right.
 */
type Shoot = readonly [motif: Motif, where: number, angle: number, size: number];

/** A tapering stem through points, with its shoots; those to the right are mirrored. */
export function stem(
  points: Trace,
  [width, end]: readonly [number, number],
  ...shoots: Shoot[]
): Motif {
  const line = along(points, 16);
  const parts = shoots.map(([motif, where, angle, size]) => {
    const {at, heading} = line[Math.round(where * (line.length - 1))] ?? {at: origin, heading: 0};
    return grown(motif, at, heading + angle, size, angle < 0 ? -size : size);
  });
  return joined([stroke('line', points, width, end), ...together(...parts)]);
}

/**
 * The same leaf on alternating sides of a stem, evenly from `from` to `to` along it, with sizes
 * from `size` to `last`.
 */
export function foliage(
  motif: Motif,
  count: number,
  [from, to]: readonly [number, number],
  angle: number,
  [size, last]: readonly [number, number],
): Shoot[] {
  return Array.from({length: count}, (_, k): Shoot => {
    const t = k / Math.max(count - 1, 1);
    const side = k % 2 === 0 ? 1 : -1;
    return [motif, from + (to - from) * t, side * angle, size + (last - size) * t];
  });
}
