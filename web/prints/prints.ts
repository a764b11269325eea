/** The shipped prints, one for each wallpaper group. Mirror axes that a garment wants upright lie along the warp, +y. */
import type {Point} from '../src/model/geometry.js';
import type {GroupName, Print} from '../src/model/print.js';
import {berries, bloom, drop, frond, petal, seed, sprig, swallow, tendril} from './motifs.js';
import type {Design, Placed} from './tile.js';

/** Ground, then stem, leaf, bloom, accent, spark. */
const palettes = {
  linen: ['#f3eee2', '#6d7a62', '#93a283', '#c57f60', '#e0b08b', '#8c5a44'],
  mist: ['#e2e8ea', '#3f5670', '#7d94a8', '#b8694f', '#d99e7f', '#f7f3ea'],
  night: ['#2f3d52', '#9aaa92', '#7f9480', '#d8a49c', '#efd9c6', '#e8c27a'],
  blush: ['#f3e5de', '#6b5a5a', '#8f8d66', '#a85f6b', '#d49a97', '#7a4455'],
  celadon: ['#dde6dc', '#44604f', '#6f8f78', '#cc9d45', '#e6c98a', '#f6f1e2'],
  clay: ['#ead9cb', '#5b4a42', '#8a7a5c', '#a9573f', '#cf8b6a', '#f5ebdd'],
  smoke: ['#e8e5e0', '#4c4c50', '#7e8b8c', '#5d8486', '#a9c0bd', '#c67f5d'],
} as const;

const square = (side: number): [Point, Point] => [
  [side, 0],
  [0, side],
];
const upright = (width: number, height: number): [Point, Point] => [
  [width, 0],
  [0, height],
];
/** w1 along the warp. */
const warpwise = (along: number, across: number): [Point, Point] => [
  [0, along],
  [-across, 0],
];
const hexagonal = (side: number): [Point, Point] => [
  [side, 0],
  [side / 2, (side * Math.sqrt(3)) / 2],
];
const hexagonalWarpwise = (side: number): [Point, Point] => [
  [0, side],
  [(-side * Math.sqrt(3)) / 2, side / 2],
];
/** w1 + w2 upright: the mirror lines of cm run along the warp. */
const rhombic = (width: number, height: number): [Point, Point] => [
  [width / 2, height / 2],
  [-width / 2, height / 2],
];
const rhombicLevel = (width: number, height: number): [Point, Point] => [
  [width / 2, -height / 2],
  [width / 2, height / 2],
];

function design(
  group: GroupName,
  [w1, w2]: [Point, Point],
  palette: keyof typeof palettes,
  motifs: readonly Placed[],
  oneWay = false,
): Design {
  const [ground, ...colours] = palettes[palette];
  const rectangular = ['cm', 'cmm', 'p3', 'p3m1', 'p31m', 'p6', 'p6m'].includes(group);
  const print: Print = {
    format: 'seamwise-print/1',
    group,
    w1,
    w2,
    image: `${group}.svg`,
    cell: rectangular ? 'rectangular' : 'primitive',
    oneWay,
    fabric: {usableWidthCm: 140},
  };
  return {print, ground, palette: colours, motifs};
}

const place = (
  motif: Placed['motif'],
  u: number,
  v: number,
  turn: number,
  size: number,
): Placed => ({motif, at: [u, v], turn, size});

export const designs: readonly Design[] = [
  design(
    'p1',
    upright(10, 12),
    'linen',
    [
      place(bloom, 0.3, 0.08, 14, 1.15),
      place(sprig, 0.8, 0.42, -18, 1.1),
      place(berries, 0.24, 0.6, 24, 0.95),
      place(seed, 0.66, 0.18, 50, 1),
      place(seed, 0.52, 0.82, -30, 1),
    ],
    true,
  ),
  design(
    'p2',
    [
      [8, 0],
      [2.6, 9.5],
    ],
    'night',
    [
      place(sprig, 0.2, 0.12, -12, 1.15),
      place(berries, 0.66, 0.12, 30, 0.75),
      place(seed, 0.5, 0.28, 10, 1),
    ],
  ),
  design(
    'pm',
    warpwise(11, 9),
    'celadon',
    [
      place(sprig, 0.05, 0.09, 18, 1.2),
      place(bloom, 0.56, 0.34, -10, 1.0),
      place(seed, 0.4, 0.3, 35, 1),
    ],
    true,
  ),
  design(
    'pg',
    warpwise(11, 7),
    'mist',
    [
      place(swallow, 0.14, 0.22, -28, 1.15),
      place(seed, 0.42, 0.1, 20, 1),
      place(seed, 0.36, 0.34, -40, 0.8),
    ],
    true,
  ),
  design(
    'cm',
    rhombic(9, 12),
    'blush',
    [place(bloom, 0.2, -0.15, 10, 1.15), place(tendril, 0.525, 0.392, 0, 0.9)],
    true,
  ),
  design('pmm', upright(10, 12), 'smoke', [
    place(sprig, 0.06, 0.06, -36, 1.1),
    place(drop, 0.36, 0.2, 0, 0.6),
  ]),
  design('pmg', warpwise(10, 12), 'clay', [
    place(frond, 0.1, 0.06, 20, 1.1),
    place(berries, 0.5, 0.085, 60, 0.7),
  ]),
  design('pgg', upright(9, 11), 'linen', [
    place(drop, 0.18, 0.06, 24, 1),
    place(seed, 0.42, 0.3, 50, 1),
  ]),
  design('cmm', rhombicLevel(10, 14), 'celadon', [
    place(frond, 0.03, 0.15, -38, 0.9),
    place(tendril, 0.35, 0.48, 6, 0.85),
    place(seed, 0.09, 0.42, 20, 0.9),
  ]),
  design('p4', square(9), 'clay', [
    place(bloom, 0.09, 0.04, -30, 1.05),
    place(seed, 0.44, 0.18, 30, 1),
  ]),
  design('p4m', square(11), 'mist', [
    place(petal, 0.06, 0.03, -66, 1.1),
    place(tendril, 0.3, 0.12, -40, 0.8),
    place(seed, 0.46, 0.4, 10, 1),
  ]),
  design('p4g', square(12), 'night', [
    place(sprig, 0.04, 0.08, -18, 1),
    place(seed, 0.34, 0.06, 40, 1),
  ]),
  design('p3', hexagonal(9), 'blush', [
    place(frond, 0.1, 0.04, -30, 1),
    place(berries, -0.295, 0.648, -120, 0.55),
  ]),
  design('p3m1', hexagonal(10), 'smoke', [
    place(petal, 0.05, 0.03, -76, 1.1),
    place(tendril, 0.452, -0.11, 10, 0.8),
    place(seed, 0.33, 0.25, -70, 1),
  ]),
  design('p31m', hexagonalWarpwise(11), 'linen', [
    place(petal, 0.05, 0.03, 27, 1.1),
    place(sprig, 0.4, 0.2, 60, 0.6),
  ]),
  design('p6', hexagonal(10), 'night', [
    place(frond, 0.07, 0.02, -50, 0.95),
    place(seed, 0.4, 0.25, 30, 1.1),
  ]),
  design('p6m', hexagonal(13), 'clay', [
    place(petal, 0.07, 0.02, -80, 1),
    place(tendril, 0.3, 0.1, -60, 0.8),
  ]),
];
