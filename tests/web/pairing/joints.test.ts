import {describe, expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import {measured} from '@/pairing/edges.js';
import {surroundingsOf} from '@/pairing/features.js';
import {beliefsOf, jointFeatures} from '@/pairing/joints.js';
import {draftedSquare} from '../../support/garments/documents.js';

/** Edges by piece and number. */
type Edge = readonly [piece: number, edge: number];

/** Kinds of joints in the order of their features, which begin with number 11. */
const kinds = [
  'beside',
  'besideStraight',
  'freeStraight',
  'three',
  'threeWhole',
  'four',
  'fourWhole',
  'border',
  'free',
  'straight',
];

/** Scores of both ends of a pair of edges, added up, if these seams and no others are known. */
function joints(
  pieces: readonly (readonly Point[])[],
  seams: readonly (readonly [Edge, Edge])[],
  [a, b]: readonly [Edge, Edge],
): Record<string, number> {
  const outlines = pieces.map((corners, k) =>
    draftedSquare(String(k), {
      outline: corners.map((from, n) => ({
        points: [from, corners[(n + 1) % corners.length] ?? from],
      })),
    }),
  );
  const garment = measured(outlines);
  const {edges} = garment;
  const numberOf = ([piece, edge]: Edge): number =>
    edges.findIndex(({at}) => at.piece === piece && at.edge === edge);
  const values = new Float64Array(edges.length ** 2);
  for (const [one, other] of seams.map((seam) => seam.map(numberOf))) {
    values[(one ?? 0) * edges.length + (other ?? 0)] = 1;
    values[(other ?? 0) * edges.length + (one ?? 0)] = 1;
  }
  const all = surroundingsOf(garment, new Int32Array(edges.length).fill(-1));
  const beliefs = beliefsOf(all, {size: edges.length, values}, 1);
  const features = jointFeatures(all, beliefs, numberOf(a), numberOf(b));
  return Object.fromEntries(kinds.map((kind, k) => [kind, features[11 + k] ?? NaN]));
}

/** Edges: 0 bottom, 1 right, 2 top, 3 left. */
const square: readonly Point[] = [
  [0, 0],
  [10, 0],
  [10, 10],
  [0, 10],
];
/** A square whose lower left corner has 45 degrees. */
const slanted: readonly Point[] = [
  [0, 0],
  [10, 0],
  [20, 10],
  [10, 10],
];
/** A rectangle with two edges at the bottom. */
const long: readonly Point[] = [
  [0, 0],
  [10, 0],
  [20, 0],
  [20, 10],
  [0, 10],
];

const beside: readonly [Edge, Edge] = [
  [0, 1],
  [1, 3],
];

describe('a seam', () => {
  it('of two squares ends at a straight border, and of a slanted one at a corner', () => {
    expect(joints([square, square], [beside], beside)).toMatchObject({free: 2, straight: 2});
    expect(joints([square, slanted], [beside], beside).straight).toBeLessThan(0.3);
  });

  it('of two squares ends where a third piece closes the joint', () => {
    const seams: readonly (readonly [Edge, Edge])[] = [
      beside,
      [
        [0, 2],
        [2, 0],
      ],
      [
        [1, 2],
        [2, 1],
      ],
    ];
    const {three, threeWhole} = joints([square, square, long], seams, beside);
    expect([three, threeWhole]).toEqual([1, 1]);
  });

  it('of two squares ends where two more close the joint, unless angles are missing', () => {
    const seams: readonly (readonly [Edge, Edge])[] = [
      beside,
      [
        [1, 2],
        [2, 0],
      ],
      [
        [2, 3],
        [3, 1],
      ],
      [
        [3, 0],
        [0, 2],
      ],
    ];
    const closed = joints([square, square, square, square], seams, beside);
    expect([closed.four, closed.fourWhole]).toEqual([1, 1]);
    const open = joints([square, square, slanted, square], seams, beside);
    expect(open.four).toBe(1);
    expect(open.fourWhole).toBeLessThan(0.2);
  });
});
