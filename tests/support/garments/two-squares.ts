import type {Point} from '@/model/geometry/vectors.js';
import type {Print} from '@/model/print/repeating-print.js';
import type {Metrics, Pattern, ResultPiece} from '@/model/result/result.js';

/** A 10 x 10 cm print without any symmetry. */
export const plainPrint: Print & Pattern['print'] = {group: 'p1', w1: [10, 0], w2: [0, 10]};

/** Metrics for tests that ignore a result's figures. */
export const plainMetrics: Metrics = {
  ...{
    fitRandom: 1,
    fitSearch: 1,
    searchBound: 1,
    searchCost: 1,
    fitAligned: 1,
    fit: 1,
    fitStrict: 1,
    fitSeam: 1,
  },
  ...{maxMovedCm: 0, iterations: 1, factorisations: 1, method: 'best', seed: 1},
  milliseconds: {alignment: 1, deformation: 1, total: 2},
};

/** A square, 4 cm wide and high, its lower left corner at the origin. */
export const square: readonly Point[] = [
  [0, 0],
  [4, 0],
  [4, 4],
  [0, 4],
];

/** A square whose origin is at that of the print. */
export const squarePiece = (name: string, more: Partial<ResultPiece> = {}): ResultPiece => ({
  name,
  rest: square,
  shape: square,
  triangles: [
    [0, 1, 2],
    [0, 2, 3],
  ],
  outline: [0, 1, 2, 3],
  holes: [],
  alignment: {angle: 0, translation: [0, 0]},
  mirroredFromInput: false,
  ...more,
});

/**
 * The right side of one square is sewn to the left side of the other; the print continues across
 * the seam.
 */
export const squarePair = (more: Partial<Pattern> = {}): Pattern => ({
  print: plainPrint,
  pieces: [
    squarePiece('left_half'),
    squarePiece('right_half', {alignment: {angle: 0, translation: [-4, 0]}}),
  ],
  seams: [
    {
      a: {piece: 0, vertices: [1, 2]},
      b: {piece: 1, vertices: [0, 3]},
      weight: 1,
      matched: true,
      lengthRatio: 1,
      kind: 'continuous',
      mismatch: [0],
    },
  ],
  symmetries: [],
  ...more,
});
