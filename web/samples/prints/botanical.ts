/** The plants of the collection. Each is drawn once, asymmetric; the group repeats it. */
import {berry, blossom, bud, cup, foliage, leaf, stem, willow} from './plants.js';
import {blade, dot, grown, joined, pebble, stroke, together, type Motif} from './shape.js';

/** An open flower on a leafy stem. 6 cm high. */
export const anemone: Motif = [
  ...stem(
    '0,0 0.5,1.4 0.2,3 0.45,4.2',
    [0.15, 0.1],
    [leaf('leaf', 3), 0.14, 52, 2.1],
    [leaf('leaf', 3), 0.3, -50, 2],
    [leaf('leaf', 2), 0.5, 46, 1.6],
    [leaf('leaf', 2), 0.62, -48, 1.3],
  ),
  ...grown(blossom('bloom', 'spark', 6), [0.5, 4.7], -14, 1.5),
];

/** A cup flower and a bud on one stem. 5.5 cm high. */
export const poppy: Motif = together(
  stem(
    '0,0 -0.5,1.2 -0.1,2.6 -0.35,3.7',
    [0.14, 0.09],
    [leaf('leaf', 3), 0.16, 48, 1.9],
    [leaf('leaf', 3), 0.34, -56, 1.9],
    [leaf('leaf', 2), 0.6, 46, 1.3],
  ),
  stem('-0.3,1.9 0.3,2.6 0.75,3.3', [0.09, 0.07], [bud(), 1, -6, 1]),
  grown(cup(), [-0.38, 3.66], 6, 1.9),
);

/** Berries on thin stalks over two leaves. 3.3 cm high. */
export const rowan: Motif = together(
  stem(
    '0,0 0.1,0.9 -0.1,1.8',
    [0.1, 0.05],
    [leaf('leaf', 2), 0.08, 62, 1.6],
    [leaf('leaf', 2), 0.2, -58, 1.9],
    [berry(), 1, 4, 0.33],
  ),
  stem('0.06,0.5 0.5,1.3 0.85,2', [0.08, 0.05], [berry(), 1, -4, 0.36]),
  stem('0.05,0.7 -0.5,1.4 -0.9,1.8', [0.08, 0.05], [berry(), 1, 4, 0.3]),
  stem('0.05,1.2 0.5,2 0.45,2.8', [0.07, 0.05], [berry('bloom'), 1, 4, 0.28]),
  stem('-0.06,1.5 -0.6,2.2 -0.7,2.7', [0.07, 0.05], [berry('bloom'), 1, 4, 0.26]),
);

const stalks = [1.15, 1.45, 1.6, 1.7, 1.4, 1.1];

/** A seed head: thin stalks that end in dots. 3.4 cm high. */
export const umbel: Motif = together(
  stem('0,0 0.15,0.8 0,1.6', [0.1, 0.07], [willow(), 0.22, 50, 1.3], [willow(), 0.4, -46, 1.1]),
  ...stalks.map((long, k) =>
    grown(
      joined([
        stroke(
          'line',
          [
            [0, 0],
            [0.06 * long, 0.5 * long],
            [0, long],
          ],
          0.05,
          0.035,
        ),
        dot('spark', [0, long], 0.15),
      ]),
      [0, 1.6],
      24 * k - 62,
    ),
  ),
);

/** A sprig of narrow leaves. 3.3 cm high, with the leaf at its tip 4.2. */
export const rosemary: Motif = stem(
  '0,0 -0.3,1.2 0.1,2.4 0,3.3',
  [0.1, 0.05],
  ...foliage(willow(), 9, [0.1, 0.88], 40, [1.35, 0.9]),
  [willow(), 1, 2, 0.9],
);

/** Two small leaves. */
export const sproutlet: Motif = together(
  grown(leaf('soft', 0), [0, 0], 34, 1.05),
  grown(leaf('soft', 0), [0, 0], -38, 0.85, -0.85),
);

/** A small flower and its two leaves. 1.5 cm wide. */
export const daisy: Motif = together(
  grown(leaf('leaf', 0), [0, -0.3], 150, 0.95),
  grown(leaf('leaf', 0), [0.1, -0.3], -142, 0.8, -0.8),
  grown(blossom(), [0, 0], 0, 0.66),
);

/**
 * Half a wave of a trailing branch, which a half turn about either end continues. From (0, 0) to
 * (1.3, 4.75).
 */
export const trail: Motif = stem(
  '0,0 1.35,1.1 1.75,2.5 1.2,3.7 1.3,4.75',
  [0.13, 0.13],
  [leaf(), 0.1, -62, 2.4],
  [leaf(), 0.26, 44, 2],
  [leaf(), 0.42, -48, 2.3],
  [leaf(), 0.62, 62, 2.3],
  [leaf(), 0.82, -60, 2],
);

/** A pear on its stalk, along +y. 2.4 cm long. */
const pear: Motif = [
  stroke('line', '0,-0.1 0.08,0.3 0,0.6', 0.08, 0.1),
  pebble(
    'bloom',
    '0,0.5 -0.32,0.75 -0.5,1.25 -0.78,1.75 -0.55,2.3 0.05,2.42 0.62,2.2 0.72,1.65 0.4,1.15 0.26,0.7',
  ),
  ...joined([
    stroke('ground', '-0.45,1.5 -0.55,1.85 -0.4,2.1', 0.09, 0.05),
    dot('ground', [0.2, 1.9], 0.05),
    dot('ground', [0.4, 1.65], 0.04),
    dot('ground', [0.05, 1.6], 0.04),
    dot('ground', [0.25, 1.4], 0.035),
  ]),
];

/** A side branch with a pear. */
export const pearBranch: Motif = [
  ...stem(
    '0,0 -0.5,1.6 0.1,3.1 1.1,3.7',
    [0.13, 0.08],
    [leaf(), 0.4, 44, 1.5],
    [leaf(), 0.3, -50, 1.7],
    [leaf(), 0.58, 46, 1.9],
    [leaf(), 0.8, 58, 1.7],
    [leaf(), 1, 8, 1.4],
  ),
  ...grown(pear, [0.5, 3.4], 194, 1.15),
];

/** A side branch with a flower. */
export const blossomBranch: Motif = [
  ...stem('0,0 -0.4,1.2 0.1,2.4', [0.12, 0.08], [leaf(), 0.54, 40, 1.15], [leaf(), 0.48, -54, 1.6]),
  ...grown(blossom(), [0.15, 3], 20, 1.15),
];

/** A curl. 1.1 cm high. */
const tendril: Motif = [
  stroke('line', '0,0 0.1,0.7 0.7,1.1 1.1,0.75 0.9,0.4 0.62,0.55 0.7,0.75', 0.09, 0.05),
];

/** Half a wave of a climbing vine, which a glide along it continues. From (0, 0) to (0, 5.5). */
export const vine: Motif = [
  ...together(
    stem(
      '0,0 0.95,1.3 1.1,2.8 0.75,4.2 0,5.5',
      [0.14, 0.14],
      [leaf(), 0.13, -56, 2.5],
      [leaf(), 0.36, 44, 1.7],
      [leaf(), 0.44, -52, 2],
      [leaf(), 0.84, -58, 1.6],
      [tendril, 0.7, 104, 0.9],
    ),
    stem('0.9,3.6 1.6,4 2.2,4.9', [0.1, 0.08], [leaf('leaf', 2), 0.4, -64, 1.1]),
  ),
  ...grown(cup(), [2.18, 4.85], -22, 1.8),
];

/** Half of an ogee's side with its leaves: from (0, 0) to (4.5, 6). */
export const ogee: Motif = stem(
  '0,0 1.5,1.1 2.3,2.6 2.55,4 3.3,5.2 4.5,6',
  [0.16, 0.16],
  [leaf(), 0.2, -52, 1.8],
  [leaf('leaf', 2), 0.3, 48, 1.35],
  [leaf(), 0.46, -50, 1.9],
  [leaf('leaf', 2), 0.6, 50, 1.4],
  [leaf(), 0.76, -56, 1.45],
);

/** Half of a tulip, to be mirrored in x = 0. 6 cm high. */
export const halfTulip: Motif = [
  stroke('line', '0,0 0,1 0,2.2', 0.17),
  ...together(
    grown(leaf('leaf', 3), [0.08, 0.2], -56, 2.2),
    grown(leaf('leaf', 2), [0.06, 1], -62, 1.35),
  ),
  blade('soft', '-0.1,2.3 -0.15,3.5 -0.1,4.6 0,5.9', '0.8,3.4 0.75,4.9'),
  ...joined([
    blade('bloom', '0,2 0.5,3.1 0.85,4.2 1.75,5.3', '1.2,2.5 1.95,4'),
    blade('bloom', '-0.06,2.1 -0.1,2.8 -0.08,3.4 0,4.5', '0.35,2.6 0.5,3.5'),
  ]),
  ...joined([
    stroke('ground', '0.35,2.5 1,3.3 1.45,4.3', 0.07, 0.03),
    stroke('ground', '0.55,2.5 1.25,3.1 1.68,3.9', 0.06, 0.025),
  ]),
  ...joined([dot('spark', [0, 2.1], 0.26), dot('spark', [1.95, 5.75], 0.13)]),
];

const ribs = [1.2, 1.5, 1.6, 1.2, 1.3, 1.6, 1.55, 1.25];

/** A ginkgo leaf on its bent stalk. 3.8 cm high. */
export const ginkgo: Motif = [
  stroke('line', '0,0 0.28,0.7 0.1,1.7', 0.13, 0.1),
  pebble(
    'leaf',
    '0.08,1.5 -0.7,2.05 -1.55,2.45 -1.75,2.95 -1.1,3.5 -0.4,3.62 -0.06,3.3 0.16,3.72 0.8,3.75 1.45,3.2 1.5,2.7 0.75,2.15',
  ),
  ...joined(
    ribs.flatMap((long, k) =>
      grown(
        [
          stroke(
            'ground',
            [
              [0, 0.3],
              [0, long],
            ],
            0.02,
            0.05,
          ),
        ],
        [0.08, 1.55],
        56 - 15.5 * k,
      ),
    ),
  ),
];
