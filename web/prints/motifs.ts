/** Small asymmetric motifs, drawn in cm with y up, growing from the origin along +y. */
import type {Point} from '../src/model/geometry.js';

/** A stroke or an area: one point, then three for every cubic Bezier curve; a dot: its centre and radius. */
export type Shape =
  | {readonly curves: readonly Point[]; readonly colour: number; readonly stroke?: number}
  | {readonly centre: Point; readonly radius: number; readonly colour: number};

/** Colours are numbers into the palette of the print that uses the motif. */
export type Motif = readonly Shape[];

const at = ([x, y]: Point, direction: number, along: number, aside: number): Point => {
  const a = (direction * Math.PI) / 180;
  // degrees from +y towards -x, that is, counter-clockwise
  return [
    x - Math.sin(a) * along - Math.cos(a) * aside,
    y + Math.cos(a) * along - Math.sin(a) * aside,
  ];
};

/** A leaf from its base along `direction` (degrees, counter-clockwise from +y), fuller on one side than on the other. */
function leaf(
  base: Point,
  direction: number,
  size: number,
  full: readonly [left: number, right: number],
  colour: number,
): Shape {
  const tip = at(base, direction, size, 0);
  const [left, right] = full;
  return {
    curves: [
      base,
      at(base, direction, 0.25 * size, left * size),
      at(base, direction, 0.75 * size, left * size * 0.9),
      tip,
      at(base, direction, 0.7 * size, -right * size * 0.8),
      at(base, direction, 0.2 * size, -right * size),
      base,
    ],
    colour,
  };
}

const dot = (centre: Point, radius: number, colour: number): Shape => ({centre, radius, colour});
const stroke = (width: number, colour: number, ...curves: Point[]): Shape => ({
  curves,
  colour,
  stroke: width,
});

/** A bending stem with leaves to both sides and a bud. 4 cm high. */
export const sprig: Motif = [
  stroke(0.09, 0, [0, 0], [0.35, 0.9], [-0.45, 1.9], [0.3, 3.1]),
  leaf([0.1, 0.55], 52, 1.25, [0.3, 0.2], 1),
  leaf([0.07, 0.95], -48, 1.05, [0.2, 0.32], 1),
  leaf([-0.03, 1.6], 44, 1.0, [0.32, 0.2], 1),
  leaf([-0.01, 2.05], -52, 0.85, [0.2, 0.32], 1),
  leaf([0.12, 2.65], 26, 0.65, [0.3, 0.2], 1),
  leaf([0.27, 3.0], -28, 1.05, [0.42, 0.34], 2),
  leaf([0.3, 3.05], -52, 0.7, [0.2, 0.3], 3),
];

/** A bloom seen from the side on a short stem, its petals curling over to the right. 3.4 cm high. */
export const bloom: Motif = [
  stroke(0.1, 0, [0, 0], [-0.35, 0.5], [-0.2, 1.1], [0.05, 1.6]),
  leaf([-0.16, 0.75], 58, 1.3, [0.34, 0.12], 1),
  leaf([-0.18, 0.9], -62, 0.85, [0.14, 0.34], 1),
  leaf([0.05, 1.5], 34, 1.55, [0.36, 0.3], 2),
  leaf([0.05, 1.5], -58, 1.5, [0.26, 0.4], 2),
  leaf([0.05, 1.5], -8, 1.75, [0.36, 0.4], 3),
  leaf([0.05, 1.5], -34, 1.3, [0.24, 0.3], 2),
  dot([0.62, 3.2], 0.11, 4),
  dot([0.98, 2.98], 0.09, 4),
];

/** A leaf with a light and a dark half and a bent rib. 3 cm high. */
export const frond: Motif = [
  {
    curves: [
      [0, 0],
      [-1.15, 0.7],
      [-0.95, 2.1],
      [0.35, 3],
      [0.05, 2.1],
      [0.1, 1.1],
      [0, 0],
    ],
    colour: 1,
  },
  {
    curves: [
      [0, 0],
      [0.1, 1.1],
      [0.05, 2.1],
      [0.35, 3],
      [1.05, 2.2],
      [0.85, 0.9],
      [0, 0],
    ],
    colour: 2,
  },
  stroke(0.07, 0, [-0.12, -0.5], [0.0, 0.2], [0.08, 1.4], [0.24, 2.5]),
];

/** A spray of three berries over two leaves. 3 cm high. */
export const berries: Motif = [
  stroke(0.07, 0, [0, 0], [0.1, 0.6], [0.4, 1.2], [0.95, 1.75]),
  stroke(0.07, 0, [0.1, 0.6], [0.05, 1.1], [-0.1, 1.7], [0.05, 2.35]),
  stroke(0.07, 0, [0.07, 0.45], [-0.2, 0.9], [-0.5, 1.2], [-0.85, 1.35]),
  dot([1.08, 1.9], 0.34, 2),
  dot([0.1, 2.65], 0.38, 2),
  dot([-1.08, 1.5], 0.28, 3),
  leaf([0.05, 0.25], -70, 1.35, [0.14, 0.32], 1),
  leaf([0.0, 0.1], 72, 0.95, [0.34, 0.16], 1),
];

/** A swallow in flight. 3.4 cm from wing to wing. */
export const swallow: Motif = [
  {
    curves: [
      [0.1, 0.2],
      [0.7, 0.9],
      [1.5, 1.1],
      [2.1, 1.9],
      [1.35, 1.6],
      [0.6, 1.5],
      [-0.1, 0.75],
    ],
    colour: 0,
  },
  {
    curves: [
      [0.05, 0.1],
      [-0.6, 0.5],
      [-1.2, 0.3],
      [-1.7, -0.25],
      [-1.35, 0.4],
      [-0.8, 0.95],
      [-0.1, 0.8],
    ],
    colour: 0,
  },
  {
    curves: [
      [-0.35, 1.45],
      [-0.05, 1.5],
      [0.35, 0.9],
      [0.3, 0.1],
      [0.25, -0.5],
      [0.45, -1.1],
      [0.75, -1.6],
      [0.35, -1.25],
      [0.15, -0.95],
      [0.05, -0.8],
      [-0.05, -1.1],
      [-0.25, -1.4],
      [-0.5, -1.6],
      [-0.3, -1.0],
      [-0.25, -0.3],
      [-0.3, 0.2],
      [-0.35, 0.7],
      [-0.6, 1.1],
      [-0.35, 1.45],
    ],
    colour: 0,
  },
  {
    curves: [
      [-0.36, 1.4],
      [-0.1, 1.35],
      [0.05, 1.05],
      [0, 0.7],
      [-0.2, 0.75],
      [-0.45, 1.1],
      [-0.36, 1.4],
    ],
    colour: 2,
  },
];

/** A paisley drop with a curl, a seam of dots and a heart. 3.2 cm high. */
export const drop: Motif = [
  {
    curves: [
      [0, 0],
      [-1.5, 0.1],
      [-1.5, 2.1],
      [-0.3, 2.5],
      [0.35, 2.7],
      [0.9, 2.9],
      [0.95, 3.3],
      [1.5, 2.6],
      [1.4, 0.1],
      [0, 0],
    ],
    colour: 1,
  },
  {
    curves: [
      [0, 0.35],
      [-1.0, 0.45],
      [-1.0, 1.8],
      [-0.2, 2.1],
      [0.3, 2.25],
      [0.75, 2.35],
      [0.95, 2.6],
      [1.15, 1.9],
      [0.95, 0.45],
      [0, 0.35],
    ],
    colour: 2,
  },
  leaf([0.05, 0.65], 8, 1.25, [0.32, 0.26], 3),
  dot([-0.6, 1.2], 0.08, 0),
  dot([-0.35, 1.72], 0.07, 0),
  dot([0.6, 1.15], 0.08, 0),
  dot([0.55, 1.7], 0.07, 0),
];

/** A petal with a vein, bent to one side. 2.6 cm high. */
export const petal: Motif = [
  {
    curves: [
      [0, 0],
      [-0.75, 0.7],
      [-0.55, 2.0],
      [0.45, 2.6],
      [0.75, 1.9],
      [0.6, 0.7],
      [0, 0],
    ],
    colour: 2,
  },
  {
    curves: [
      [0.02, 0.3],
      [-0.25, 0.9],
      [-0.1, 1.6],
      [0.38, 2.2],
      [0.2, 1.6],
      [0.1, 0.9],
      [0.02, 0.3],
    ],
    colour: 3,
  },
];

/** A tendril with one leaf. 2 cm high. */
export const tendril: Motif = [
  stroke(
    0.09,
    0,
    [0, 0],
    [0.05, 0.8],
    [0.9, 0.9],
    [0.85, 1.55],
    [0.8, 2.0],
    [0.2, 1.95],
    [0.3, 1.5],
  ),
  leaf([0.16, 0.5], 50, 0.95, [0.32, 0.2], 1),
];

/** A single seed, tilted. */
export const seed: Motif = [leaf([0, 0], 0, 0.62, [0.34, 0.22], 3)];
