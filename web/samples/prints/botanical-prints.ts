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

const roseLattice = slanted([8, 0], [2.6, 9.5]);

const rowanberry = stem(
  '0,0 0.5,1 0.2,2',
  [0.1, 0.06],
  [willow(), 0.25, 44, 1.4],
  [willow(), 0.5, -44, 1.4],
  [berry(), 1, 0, 0.34],
);

const pea = (radius: number): Motif => [dot('spark', [0, 0], radius)];

/** A branch that winds around its mirror image, along the warp. 11 cm high. */
const braid = stroke(
  'line',
  '0,0 0.42,1.2 0.3,2.6 -0.3,4.4 -0.42,5.8 -0.2,7 0.3,8.4 0.36,9.8 0,11',
  0.13,
);

export const botanicalPrints: readonly Design[] = [
  botanical('p1', 'Meadow walk', ['linen', 'night', 'blush'], 'p1', upright(10, 12), [
    place(anemone, 0.8, 0.4, -24, 1.1),
    place(poppy, 7.8, 2.6, 172, 1.1),
    place(rowan, 4.9, 7.6, 48, 1.15),
    place(umbel, 5.2, 3.3, -42, 1.1),
    place(rosemary, 9.9, 4.6, -4, 1.05),
    place(daisy, 6.7, 7.3, -20, 1.15),
    place(daisy, 4.6, 1, 40, 1.1),
    place(sproutlet, 5.1, 11, -20, 1.2),
    place(sproutlet, 0.3, 10.4, 50, 1.2),
  ]),
  botanical('p2', 'Trailing rose', ['night', 'celadon', 'linen'], 'p2', roseLattice, [
    place(trail, 0, 0),
    place(blossom(), 4.9, 0.9, 20, 1.35),
    place(sproutlet, 3.7, 2.9, -120),
    place(daisy, 5.9, 4.9, -60, 1.05),
  ]),
  botanical('pm', 'Espalier', ['celadon', 'clay', 'night'], 'pm', warpwise(11, 9), [
    place([braid], 0, 0),
    place(pearBranch, 0, 0.4, -40),
    place(blossomBranch, 0, 4.3, -34, 1.2),
    place(leaf(), 4.5, 8.6, -24, 2.2),
    place(bud(), 4.5, 11, -10, 1.7),
    place(rosemary, 0, 8.5, -58, 0.7),
  ]),
  botanical('pg', 'Climbing vine', ['mist', 'linen', 'moss'], 'pg', warpwise(11, 7), [
    place(vine, 0, 0),
    place(sproutlet, 3.8, 1.7, 30, 1.25),
  ]),
  botanical('cm', 'Ogee tulip', ['blush', 'mist', 'plum'], 'cm', rhombic(9, 12), [
    place(ogee, 0, -6),
    place(halfTulip, 0, -3.4),
  ]),
  botanical('p4m', 'Majolica', ['mist', 'celadon', 'night'], 'p4m', square(11), [
    place(leaf('bloom', 0), 0.3, 0.3, -35, 3.9),
    place(leaf('leaf', 3), 0.9, 0.2, -68, 4.2),
    place(willow('line'), 5.3, 5.3, 62, 2.8),
    place(pea(0.2), 5.5, 0),
    place(pea(0.3), 0, 0),
    place(pea(0.16), 3.6, 3.6),
  ]),
  botanical('p4g', 'Bay trellis', ['night', 'smoke', 'moss'], 'p4g', square(12), [
    place(rosemary, 0, 0, -72, 1.12),
    place(leaf('bloom', 3), 3.15, 2.85, -20, 2.4),
    place(willow('bloom'), 6.3, 0.15, -64, 2.1),
    place(pea(0.22), 6, 0),
  ]),
  botanical('p3', 'Ginkgo', ['blush', 'celadon', 'moss'], 'p3', hexagonal(9), [
    place(ginkgo, 0, 0, -20, 1.12),
    place(leaf('bloom', 1), 4.5, 2.6, 20, 1.5),
    place(willow('soft'), 9, 5.196, 4, 1.5),
    place(pea(0.16), 0, 0),
  ]),
  botanical('p31m', 'Trillium', ['linen', 'plum', 'mist'], 'p31m', hexagonalWarpwise(11), [
    place(leaf('bloom', 2), 0, 0.2, -12, 3.1),
    place(leaf('leaf', 3), 0.2, 0.1, -40, 3.4),
    place(rowanberry, -3.1754, 5.5, 20),
    place(pea(0.3), 0, 0),
  ]),
  botanical('bouquet', 'Cutting garden', ['clay', 'mist', 'plum'], 'p1', upright(9, 12), [
    place(anemone, 2.1, 0, 8, 1.1),
    place(poppy, 6.9, 5.2, -4, 1.15),
    place(umbel, 6.3, 0.4, -8, 1.15),
    place(rosemary, 4.4, 6.8, 10, 1.05),
    place(rowan, 1.3, 7.7, 4, 1.15),
    place(daisy, 8.4, 4.6, -10, 1.1),
    place(daisy, 4.5, 0.1, 20, 1.15),
    place(sproutlet, 8.6, 11.6, 10, 1.2),
    place(bud(), 4.6, 5.6, 10, 1.2),
  ]),
  botanical('ditsy', 'Ditsy', ['linen', 'blush', 'night'], 'pgg', upright(7, 8), [
    place(umbel, 3.1, 1, -34, 0.7),
    place(daisy, 1.2, 1.1, 20, 1.25),
    place(sproutlet, 1.3, 3.2, 100, 0.85),
    place(bud(), 2.6, 3.4, 150, 0.9),
  ]),
];
