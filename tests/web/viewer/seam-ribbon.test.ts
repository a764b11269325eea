import {describe, expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import {sceneOf, type PatternScene} from '@/scene/scene.js';
import {onPieceAt, straightSeam, type StraightSeam} from '@/viewer/seam-ribbon.js';
import {plainPrint as print, squarePair, squarePiece} from '../../support/garments/two-squares.js';

function straight(scene: PatternScene): StraightSeam {
  const seam = straightSeam(scene, 0);
  if (!seam) throw new Error('The seam has no length.');
  return seam;
}

/** The left square with other points. */
const withLeft = (points: readonly Point[], outline: readonly number[]): PatternScene =>
  sceneOf(
    squarePair({
      pieces: [squarePiece('left_half', {shape: points, rest: points, outline}), squarePiece('b')],
    }),
    print,
  );

describe('a straightened seam', () => {
  const seam = straight(sceneOf(squarePair(), print));

  it('is as long as its sides, and reaches to the other end of narrow pieces', () => {
    expect(seam.length).toBe(4);
    for (const {columns} of [seam.a, seam.b]) {
      expect(columns).toHaveLength(21);
      for (const {depth} of columns) expect(depth).toBeCloseTo(4, 9);
    }
  });

  it('leads from a share and an offset to the place on each piece', () => {
    expect(onPieceAt(seam, {side: 'a', share: 0.25, offset: 1})).toEqual({piece: 0, point: [3, 1]});
    expect(onPieceAt(seam, {side: 'b', share: 0.25, offset: 1})).toEqual({piece: 1, point: [1, 1]});
  });

  it('runs to the right when its first side lies left of it, else to the left', () => {
    expect(seam.runsLeft).toBe(false);
    const turned = squarePair({
      seams: squarePair().seams.map((one) => ({...one, a: one.b, b: one.a})),
    });
    expect(straight(sceneOf(turned, print)).runsLeft).toBe(true);
  });

  it('ends at a cut-out', () => {
    const hole: Point[] = [
      [2, 1],
      [2, 3],
      [3, 3],
      [3, 1],
    ];
    const pieces = squarePair().pieces.map((piece, k) =>
      k === 0 ? {...piece, shape: [...piece.shape, ...hole], holes: [[4, 5, 6, 7]]} : piece,
    );
    const {columns} = straight(sceneOf(squarePair({pieces}), print)).a;
    expect(columns[10]?.depth).toBeCloseTo(1, 9);
    expect(columns[2]?.depth).toBeCloseTo(4, 9);
  });

  it('is bare beyond a corner at which the piece is cut back', () => {
    // the left side leans in from the lower end of the seam
    const leaning: Point[] = [
      [4, 0],
      [4, 4],
      [0, 4],
      [3, 2],
    ];
    const scene = withLeft(leaning, [0, 1, 2, 3]);
    const seams = scene.seams.map((one) => ({...one, a: {piece: 0, vertices: [0, 1]}}));
    const {columns} = straight({...scene, seams}).a;
    expect(columns[0]?.depth).toBeLessThan(0.1);
    expect(columns[5]?.depth).toBeCloseTo(0.5, 9); // halfway from (4, 0) to (3, 2)
  });

  it('does not fold where the line is hollow', () => {
    // half a circle of radius 3 about (4, 4), with the piece inside
    const arc = Array.from({length: 31}, (_, k): Point => {
      const turn = -Math.PI / 2 + (k / 30) * Math.PI;
      return [4 + 3 * Math.cos(turn), 4 + 3 * Math.sin(turn)];
    });
    const points: Point[] = [...arc, [-4, 7], [-4, 1]];
    const scene = withLeft(
      points,
      points.map((_, k) => k),
    );
    const line = arc.map((_, k) => k);
    const bent = straightSeam(
      {
        ...scene,
        seams: scene.seams.map((one) => ({
          ...one,
          a: {piece: 0, vertices: line},
          b: {piece: 0, vertices: line},
        })),
      },
      0,
    );
    const middle = bent?.a.columns[Math.floor(bent.a.columns.length / 2)];
    expect(middle?.depth).toBeGreaterThan(2.9);
    expect(middle?.depth).toBeLessThan(3.05); // all normals meet at the centre
  });
});
