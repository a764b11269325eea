/** The botanical prints of the collection. */
import {
  anemone,
  blossomBranch,
  daisy,
  ginkgo,
  halfTulip,
  ogee,
  pearBranch,
  poppy,
  rosemary,
  rowan,
  sproutlet,
  trail,
  umbel,
  vine,
} from './botanical.js';
import {
  botanical,
  hexagonal,
  hexagonalWarpwise,
  place,
  rhombic,
  slanted,
  square,
  upright,
  warpwise,
  type Design,
} from './design.js';
import {berry, blossom, bud, leaf, stem, willow} from './plants.js';
import {dot, stroke, type Motif} from './shape.js';

const pea = (radius: number): Motif => [dot('spark', [0, 0], radius)];

export const botanicalPrints: readonly Design[] = [
  botanical('p1', 'Meadow walk', ['linen', 'night', 'blush'], 'p1', upright(10, 12), [
    place(anemone, 2.4, 0.2, 14),
    place(poppy, 7.7, 5.3, -12),
    place(rowan, 2.2, 8, 24),
    place(umbel, 6.1, 1.2, -30),
    place(sproutlet, 4.9, 7.6, 20),
    place(daisy, 5, 10.9, -20),
    place(sproutlet, 8.8, 4.5, -70),
    place(daisy, 4.4, 5.4, 30, 0.8),
    place(rosemary, 9, 0.1, 10, 0.8),
  ]),
  botanical(
    'p2',
    'Trailing rose',
    ['night', 'celadon', 'linen'],
    'p2',
    slanted([8, 0], [2.6, 9.5]),
    [place(trail, 0, 0), place(blossom(), 4.9, 0.9, 20, 1.35), place(daisy, 5.6, 4.6, -60, 0.9)],
  ),
  botanical('pm', 'Espalier', ['celadon', 'clay', 'night'], 'pm', warpwise(11, 9), [
    place([stroke('line', '0,0 0,3.7 0,7.4 0,11', 0.16)], 0, 0),
    place(pearBranch, 0, 0.4, -40),
    place(blossomBranch, 0, 5.6, -32, 1.15),
    place(leaf(), 4.5, 5.7, -24, 2.2),
    place(bud(), 4.5, 7.9, -12, 1.7),
    place(pea(0.14), 4.5, 0.9),
  ]),
  botanical('pg', 'Climbing vine', ['mist', 'linen', 'moss'], 'pg', warpwise(11, 7), [
    place(vine, 0, 0),
    place(sproutlet, 3.7, 1.5, 30),
  ]),
  botanical('cm', 'Ogee tulip', ['blush', 'mist', 'plum'], 'cm', rhombic(9, 12), [
    place(ogee, 0, -6),
    place(halfTulip, 0, -3.4),
  ]),
  botanical('p4m', 'Majolica', ['mist', 'celadon', 'night'], 'p4m', square(11), [
    place(leaf('bloom', 3), 0.3, 0.3, -35, 3.6),
    place(leaf('leaf', 3), 0.9, 0.2, -68, 4.2),
    place(willow('line'), 5.3, 5.3, 62, 2.8),
    place(pea(0.2), 5.5, 0),
    place(pea(0.3), 0, 0),
    place(pea(0.16), 3.6, 3.6),
  ]),
  botanical('p4g', 'Bay trellis', ['night', 'smoke', 'moss'], 'p4g', square(12), [
    place(rosemary, 0, 0, -72, 1.3),
    place(leaf('bloom', 3), 3.2, 2.8, -20, 2.6),
  ]),
  botanical('p3', 'Ginkgo', ['blush', 'celadon', 'moss'], 'p3', hexagonal(9), [
    place(ginkgo, 0.25, 0.1, -20, 1.1),
    place(leaf('bloom', 1), 4.5, 2.6, 20, 1.5),
    place(willow('soft'), 9, 5.3, 0, 1.8),
  ]),
  botanical('p31m', 'Trillium', ['linen', 'plum', 'mist'], 'p31m', hexagonalWarpwise(11), [
    place(leaf('bloom', 3), 0, 0.2, -8, 3),
    place(leaf('leaf', 3), 0.2, 0.1, -40, 3.4),
    place(
      stem('0,0 0.5,1 0.2,2', [0.1, 0.06], [berry(), 1, 0, 0.3], [willow(), 0.4, -40, 1.4]),
      -3.175,
      5.5,
      20,
    ),
    place(pea(0.3), 0, 0),
  ]),
  botanical('bouquet', 'Cutting garden', ['clay', 'mist', 'plum'], 'p1', upright(9, 12), [
    place(anemone, 2.2, 0.4, 4),
    place(poppy, 7.1, 6.2, -4, 1.05),
    place(umbel, 5.6, 0.6, -8),
    place(rosemary, 4.7, 6.2, 8, 0.95),
    place(rowan, 1.6, 7.4, 4),
    place(daisy, 8.2, 4.2, -10),
    place(sproutlet, 4.2, 4.4),
    place(sproutlet, 8.8, 11),
  ]),
  botanical('ditsy', 'Ditsy', ['linen', 'blush', 'night'], 'pgg', upright(7, 8), [
    place(daisy, 1.3, 1.4, 20, 1.1),
    place(umbel, 3.3, 2.6, -70, 0.62),
    place(sproutlet, 0.6, 3.3, 50, 0.8),
    place(bud(), 2.9, 0.2, -30, 0.9),
  ]),
];
