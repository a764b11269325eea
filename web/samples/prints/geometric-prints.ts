/** The geometric prints of the collection. */
import {geometric, hexagonal, place, square, upright, warpwise, type Design} from './design.js';
import {dart, dartRow, diamond, halfFan, kite, sail, thatch, vane} from './geometric.js';
import {dot, type Motif} from './shape.js';

const lozenge = [5, 6] as const;
const pea = (radius: number): Motif => [dot('spark', [0, 0], radius)];

/** A quarter of the light diamond: a core, and darts between two lines. */
const light: Motif = [
  ...diamond('bloom', lozenge, 0, 0.22),
  ...diamond('line', lozenge, 0.3, 0.34),
  ...dartRow('leaf', lozenge, 0.42, 0.74, 5),
  ...diamond('line', lozenge, 0.8, 0.84),
];
/** A quarter of the dark diamond, with darts cut into it. */
const dark: Motif = [
  ...diamond('leaf', lozenge, 0, 0.86),
  ...dartRow('ground', lozenge, 0.46, 0.76, 5),
  ...diamond('ground', lozenge, 0.3, 0.35),
  ...diamond('spark', lozenge, 0, 0.2),
];

export const geometricPrints: readonly Design[] = [
  geometric('pmm', 'Harlequin', ['smoke', 'blush', 'night'], 'pmm', upright(10, 12), [
    place(light, 0, 0),
    place(dark, 5, 6),
  ]),
  geometric('pmg', 'Palm court', ['clay', 'celadon', 'night'], 'pmg', warpwise(10, 12), [
    place(halfFan(['leaf', 'line'], 6, 4.6, 2.9), 3, 0.3),
    place(halfFan(['bloom', 'soft'], 5, 4.2, 2.6), 3, 5.3),
  ]),
  geometric('pgg', 'Parquet', ['linen', 'smoke', 'plum'], 'pgg', upright(9, 11), [
    place(
      thatch([4.3, 5.3], -39.3, [
        ['line', 0.5, 0.2],
        ['leaf', 0.9, 0.2],
        ['leaf', 0.9, 0.2],
        ['soft', 0.9, 0.2],
        ['bloom', 0.5, 0],
      ]),
      2.25,
      2.75,
    ),
    place(pea(0.3), 4.5, 0.9),
  ]),
  geometric('p4', 'Windmill', ['clay', 'mist', 'moss'], 'p4', square(9), [
    place(vane('bloom', 4.2, 2.1, 3), 0.2, 0.12),
    place(vane('leaf', 3.9, 1.8, 0), 0.3, 0.44, 28),
    place(vane('soft', 3.6, 1.1, 0), 0.24, 0.6, 55),
    place(vane('line', 1.2, 0.6, 0), 4.55, 4.52),
  ]),
  geometric('p3m1', 'Kite star', ['smoke', 'clay', 'night'], 'p3m1', hexagonal(10), [
    place(kite('line', 4.4, 1.0, 1.9), 0, 0.25, 0),
    place(kite('bloom', 3.2, 0.9, 1.5), -0.22, 0.13, 60),
    place(dart('leaf'), 5, 2.887, 0, 2.4),
    place(dart('soft'), 5, 2.887, 56, 2.5),
    place(kite('leaf', 2.3, 0.7, 1.1), 10, 6.05, 0),
    place(pea(0.25), 10, 5.774),
  ]),
  geometric('p6', 'Whirl', ['night', 'linen', 'celadon'], 'p6', hexagonal(10), [
    place(sail('leaf'), 0.5, 0, -20, 3.6),
    place(sail('bloom'), 5, 2.887, 0, 1.8),
    place(pea(0.3), 0, 0),
  ]),
  geometric('p6m', 'Snow crystal', ['clay', 'mist', 'plum'], 'p6m', hexagonal(13), [
    place(dart('soft'), 0.5, 0.03, -86, 4.6),
    place(dart('leaf'), 0.4, 0.1, -72, 4.2),
    place(dart('line'), 6.5, 0.15, -65, 1.6),
    place(dart('bloom'), 6.5, 3.753, 30, 1.9),
    place(pea(0.2), 6.5, 3.753),
  ]),
];
