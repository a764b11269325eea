import {describe, expect, it} from 'vitest';

import {askedSymmetries, noPicture} from '@/model/design/design.js';
import type {ResultPiece, ResultSymmetry, SolveResult} from '@/model/result/result.js';
import {solvedDesign, type SolvedFiles} from '@/model/design/solved-design.js';

const files: SolvedFiles = {
  garment: {name: 'coat.json', text: '{}'},
  print: {group: 'pmm', w1: [6, 0], w2: [0, 8]},
  picture: undefined,
  options: {maxChangeCm: 0.5},
  seed: 3,
};

const piece = (name: string, mirroredFromInput = false): ResultPiece => ({
  name,
  rest: [],
  shape: [],
  triangles: [],
  outline: [],
  holes: [],
  alignment: {angle: 0, translation: [0, 0]},
  mirroredFromInput,
});

const symmetriesFor = (symmetry: ResultSymmetry, pieces: readonly ResultPiece[]) =>
  askedSymmetries(
    solvedDesign(files, {
      pieces,
      symmetries: [symmetry],
      metrics: {method: 'best'},
    } as unknown as SolveResult),
  );

const folded = (angle: number, translation: readonly [number, number]): ResultSymmetry => ({
  kind: 'piece',
  piece: 0,
  map: {angle, translation},
  pairs: [],
});

describe('the design of a result', () => {
  it('holds garment, print and options as they were', () => {
    const design = solvedDesign(files, {
      pieces: [],
      symmetries: [],
      metrics: {method: 'paper'},
    } as unknown as SolveResult);
    expect(design).toEqual({
      garment: files.garment,
      print: {
        title: 'pmm',
        group: 'pmm',
        size: {width: 6, height: 8, angleDeg: 90},
        turnDeg: 0,
        oneWay: false,
        cell: 'primitive',
        image: noPicture,
      },
      symmetry: 'none',
      seed: 3,
      method: 'paper',
      options: {maxChangeCm: 0.5},
    });
  });

  it('asks for the axis that a piece was mirrored on: x to 10 - x is x = 5', () => {
    const [symmetry] = symmetriesFor(folded(0, [10, 0]), [piece('back')]);
    expect(symmetry).toEqual({
      kind: 'piece',
      piece: 'back',
      axis: [
        [5, -10],
        [5, 10],
      ],
    });
  });

  it('asks for an axis that lies across: y to 6 - y is y = 3', () => {
    const [symmetry] = symmetriesFor(folded(Math.PI, [0, 6]), [piece('yoke')]);
    const [first, second] = symmetry?.kind === 'piece' ? (symmetry.axis ?? []) : [];
    expect(first?.[1]).toBeCloseTo(3, 12);
    expect(second?.[1]).toBeCloseTo(3, 12);
    expect(first?.[0]).toBeCloseTo(10, 12);
  });

  it('asks for it in the coordinates of a file that shows the back of the piece', () => {
    const [symmetry] = symmetriesFor(folded(0, [10, 0]), [piece('back', true)]);
    expect(symmetry).toMatchObject({
      axis: [
        [-5, -10],
        [-5, 10],
      ],
    });
  });

  it('asks for pairs by their names', () => {
    const pair: ResultSymmetry = {
      kind: 'pair',
      pieces: [1, 0],
      map: {angle: 0, translation: [0, 0]},
      pairs: [],
    };
    expect(symmetriesFor(pair, [piece('left'), piece('right')])).toEqual([
      {kind: 'pair', pieces: ['right', 'left']},
    ]);
  });
});
