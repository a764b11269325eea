import {describe, expect, it} from 'vitest';

import {
  alignmentsFrom,
  coordinates,
  onPrint,
  type Alignment,
  type Point,
} from '@/model/geometry/vectors.js';
import type {Print} from '@/model/print/repeating-print.js';
import type {Pattern} from '@/model/result/result.js';
import {apply} from '@/model/geometry/plane-map.js';
import {panelMarks} from '@/model/garment/panel-marks.js';
import {documentOf, draftedSquare} from '../../support/garments/documents.js';
import {imageCoordinates} from '@/model/print/image-coordinates.js';
import {pieceAt, realigned, reprinted, sceneOf} from '@/scene/scene.js';
import {symmetriesOf} from '@/scene/scene-marks.js';
import {seamStrokes} from '@/viewer/strokes.js';
import {
  plainPrint as print,
  square,
  squarePair,
  squarePiece,
} from '../../support/garments/two-squares.js';

const squareHole: Point[] = [
  [1, 1],
  [1, 3],
  [3, 3],
  [3, 1],
];
const home: Alignment = {angle: 0, translation: [0, 0]};
describe('a scene', () => {
  it('has the mismatch of the pieces as they lie in it, not that of the file', () => {
    const scene = sceneOf(squarePair(), print, {
      alignments: [home, {angle: 0, translation: [-4, 0.5]}],
    });
    expect(scene.seams[0]?.mismatch[0]).toBeCloseTo(0.5, 12);
    expect(scene.pieces[1]?.alignment.translation).toEqual([-4, 0.5]);
  });

  it('keeps its geometry when only alignments change', () => {
    const scene = sceneOf(squarePair(), print);
    const next = realigned(scene, alignmentsFrom(Float64Array.of(0, 0, 0, 0, -4, 0.25)));
    expect(next.seams[0]?.mismatch[0]).toBeCloseTo(0.25, 12);
    expect(next.symmetries).toBe(scene.symmetries);
    next.pieces.forEach(({points, offset, triangles}, k) => {
      expect(points).toBe(scene.pieces[k]?.points);
      expect(offset).toBe(scene.pieces[k]?.offset);
      expect(triangles).toBe(scene.pieces[k]?.triangles);
    });
  });

  it('measures by the new print when the print changes', () => {
    const half: Print = {group: 'p1', w1: [0.5, 0], w2: [0, 0.5]};
    const scene = sceneOf(squarePair(), print, {
      alignments: [home, {angle: 0, translation: [-4, 0.5]}],
    });
    const next = reprinted(scene, half);
    expect(next.seams[0]?.mismatch[0]).toBeCloseTo(0, 12);
  });

  it('knows where and how far a seam misses, and on which pieces there is no print', () => {
    const scene = sceneOf(squarePair(), print, {
      alignments: [home, {angle: 0, translation: [-4, 0.5]}],
      plain: new Set(['right_half']),
    });
    const [seam] = scene.seams;
    expect(seam).toMatchObject({kind: 'continuous', counts: true, worst: {edge: 0}});
    expect(seam?.worst.mismatch).toBeCloseTo(0.5, 12);
    expect(seam?.mean).toBeCloseTo(0.5, 12);
    expect(scene.pieces.map(({plain}) => plain)).toEqual([false, true]);
  });

  it('stays within its size, and no pieces touch, on wide and on narrow screens', () => {
    for (const viewport of [
      {width: 1600, height: 700},
      {width: 390, height: 800},
    ]) {
      const {pieces, size} = sceneOf(squarePair(), print, {viewport});
      const lows = pieces.map(({offset}) => offset);
      for (const [x, y] of lows) {
        expect(x).toBeGreaterThanOrEqual(0);
        expect(y).toBeGreaterThan(0); // the name is below
        expect(x + 4).toBeLessThanOrEqual(size[0] + 1e-9);
        expect(y + 4).toBeLessThanOrEqual(size[1] + 1e-9);
      }
      const [a = [0, 0], b = [0, 0]] = lows;
      expect(Math.max(Math.abs(a[0] - b[0]), Math.abs(a[1] - b[1]))).toBeGreaterThan(5);
    }
  });

  it('marks a pair with the same letter at mirrored places', () => {
    const symmetric = squarePair({
      symmetries: [
        {kind: 'pair', pieces: [0, 1], map: {angle: 0, translation: [4, 0]}, pairs: []},
        {kind: 'piece', piece: 0, map: {angle: 0, translation: [4, 0]}, pairs: []},
      ],
    });
    const [pair, axis] = sceneOf(symmetric, print).symmetries;
    expect(pair).toMatchObject({kind: 'pair', letter: 'α'});
    if (pair?.kind !== 'pair' || axis?.kind !== 'piece') throw new Error('other symmetries');
    const [first, second] = pair.marks;
    expect([first?.piece, second?.piece]).toEqual([0, 1]);
    expect(second?.at[0]).toBeCloseTo(4 - (first?.at[0] ?? NaN), 12);
    expect(second?.at[1]).toBeCloseTo(first?.at[1] ?? NaN, 12);
    expect(axis.axis.map(([x]) => x)).toEqual([2, 2]);
    expect(axis.axis.map(([, y]) => y)).toEqual([0, 4]);
  });

  it('gives a pair its letter whatever other pairs there are', () => {
    const four = squarePair({
      pieces: ['a', 'b', 'c', 'd'].map((name) => squarePiece(name)),
      seams: [],
    });
    const map = {angle: 0, translation: [4, 0]} as const;
    const [one, other] = (
      [
        [0, 2],
        [3, 1],
      ] as const
    ).map((pieces) => ({kind: 'pair', pieces, map, pairs: []}) as const);
    if (!one || !other) throw new Error('There are no pairs.');
    const lettersOf = (symmetries: Pattern['symmetries']): unknown[] =>
      symmetriesOf({...four, symmetries}, 'rest').map((pair) => 'letter' in pair && pair.letter);
    const [first, second] = lettersOf([one, other]);
    expect(first).not.toBe(second);
    expect(lettersOf([other, one])).toEqual([second, first]);
    expect(lettersOf([other])).toEqual([second]);
    expect(lettersOf([one])).toEqual([first]);
  });

  it('finds the piece under a point, and nothing in a cut-out or beside the pieces', () => {
    const pieces = [
      squarePiece('ring', {
        rest: [...square, ...squareHole],
        shape: [...square, ...squareHole],
        holes: [[4, 5, 6, 7]],
      }),
    ];
    const scene = sceneOf({print, pieces, seams: [], symmetries: []}, print);
    const [dx = NaN, dy = NaN] = scene.pieces[0]?.offset ?? [];
    const found = pieceAt(scene, [0.5 + dx, 0.25 + dy]);
    expect(found?.piece).toBe(0);
    expect(found?.point[0]).toBeCloseTo(0.5, 12);
    expect(found?.point[1]).toBeCloseTo(0.25, 12);
    expect(pieceAt(scene, [2 + dx, 2 + dy])).toBeUndefined();
    expect(pieceAt(scene, [5 + dx, 2 + dy])).toBeUndefined();
  });
});

describe('what the garment adds', () => {
  const garment = documentOf([
    draftedSquare('left_half', {
      label: 'Left half',
      grain: {
        line: [
          [1, 0.5],
          [1, 3.5],
        ],
      },
    }),
    draftedSquare('right_half'),
  ]);

  it('is a name and a grain line', () => {
    expect(panelMarks(garment).get('left_half')).toMatchObject({
      label: 'Left half',
      grain: [
        [1, 0.5],
        [1, 3.5],
      ],
    });
    expect(panelMarks(garment).get('right_half')).toEqual({
      label: 'Right half',
      drafted: garment.pieces[1],
    });
  });

  it('is drawn on its piece', () => {
    const scene = sceneOf(squarePair(), print, {garment});
    expect(scene.pieces.map(({label}) => label)).toEqual(['Left half', 'Right half']);
    expect(scene.pieces[0]?.grain).toEqual([
      [1, 0.5],
      [1, 3.5],
    ]);
    expect(scene.pieces[1]?.grain).toBeUndefined();
  });

  it('moves a grain line off a mirror axis', () => {
    const symmetries: Pattern['symmetries'] = [
      {kind: 'piece', piece: 0, map: {angle: 0, translation: [2, 0]}, pairs: []},
    ];
    const [from, to] = sceneOf(squarePair({symmetries}), print, {garment}).pieces[0]?.grain ?? [];
    expect(Math.abs((from?.[0] ?? NaN) - 1)).toBeCloseTo(2, 12);
    expect(to?.[0]).toBeCloseTo(from?.[0] ?? NaN, 12);
  });
});

describe('coordinates in the image of a print', () => {
  const alignment: Alignment = {angle: 0.7, translation: [31, -57]};
  const prints: readonly Print[] = [
    {group: 'p2', w1: [8, 0], w2: [2.6, 9.5]},
    {group: 'cm', w1: [4.5, 6], w2: [-4.5, 6], cell: 'rectangular'},
    {group: 'p6m', w1: [13, 0], w2: [6.5, 6.5 * Math.sqrt(3)], cell: 'rectangular'},
  ];
  const sides: readonly (readonly [Point, Point])[] = [
    [
      [8, 0],
      [2.6, 9.5],
    ],
    [
      [0, 12],
      [-9, 0],
    ],
    [
      [13, 0],
      [0, 13 * Math.sqrt(3)],
    ],
  ];

  it.each(prints.map((one, k) => [one.group, one, sides[k]] as const))(
    'of %s lead back to where the piece lies on it, but for whole cells',
    (_, one, cell) => {
      const [a = [NaN, NaN], b = [NaN, NaN]] = cell ?? [];
      const map = imageCoordinates(one, alignment, [3, 4]);
      for (const p of [...square, [17, -9] as const]) {
        const [u, v] = apply(map, p);
        const [s, t] = coordinates([a, b], onPrint(alignment, p));
        const [i, j] = [s - u, t - v];
        expect(i).toBeCloseTo(Math.round(i), 9);
        expect(j).toBeCloseTo(Math.round(j), 9);
      }
    },
  );

  it('are those of the first cell near the point asked for', () => {
    const [u, v] = apply(imageCoordinates(print, alignment, [3, 4]), [3, 4]);
    for (const value of [u, v]) {
      expect(value).toBeGreaterThanOrEqual(0);
      expect(value).toBeLessThan(1);
    }
  });
});

describe('the lines along seams', () => {
  const styleAt = (mismatch: number, scale: 'absolute' | 'paper' = 'absolute'): unknown => {
    const scene = sceneOf(squarePair(), print, {scale});
    const seams = scene.seams.map((seam) => ({...seam, mismatch: [mismatch]}));
    const {styles} = seamStrokes({...scene, seams}, 'light').at(-1) ?? {styles: []};
    return 'width' in styles ? styles : styles[0];
  };

  it('are green to 1 mm, and red and as wide as they get above 6 mm, on every print', () => {
    expect(styleAt(0.1)).toEqual({colour: [43, 147, 88], width: 2.4});
    expect(styleAt(0.61)).toMatchObject({colour: [200, 48, 40], width: 4.6});
    expect(styleAt(3)).toEqual(styleAt(0.61));
    expect(styleAt(0.5)).not.toEqual(styleAt(0.61));
  });

  it('are red from 2 cm on the scale of the paper', () => {
    expect(styleAt(2, 'paper')).toMatchObject({colour: [200, 48, 40], width: 4.6});
    expect(styleAt(1.9, 'paper')).not.toEqual(styleAt(2, 'paper'));
  });
});
