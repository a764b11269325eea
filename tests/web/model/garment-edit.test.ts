/** Edits of garments as documents: edges and seams, and the data that refer to their numbers. */
import {describe, expect, it} from 'vitest';

import {designAfter} from '@/model/design/edited-design.js';
import {edgeLength, edgeLine, splitCurve} from '@/model/garment/edge-curve.js';
import {
  isOpen,
  removePiece,
  rename,
  seamAt,
  setAllowance,
  setOpen,
  sew,
  sideLength,
  splitEdge,
  turnSeam,
  unsew,
} from '@/model/garment/edits.js';
import type {DraftedEdge, GarmentDocument} from '@/model/garment/garment-document.js';
import {goesStraightOn} from '@/model/garment/join-edges.js';
import {distance, nearestShare, between, type Point} from '@/model/geometry/vectors.js';
import {lengthOf} from '@/model/geometry/polyline.js';
import type {Design} from '@/model/design/design.js';
import {documentOf, draftedSeam, draftedSquare} from '../../support/garments/documents.js';

const curves: Readonly<Record<string, DraftedEdge>> = {
  line: {
    points: [
      [1, 2],
      [7, -6],
    ],
  },
  quadratic: {
    points: [
      [0, 0],
      [5, 9],
      [12, 1],
    ],
  },
  cubic: {
    points: [
      [0, 0],
      [2, 11],
      [13, -8],
      [12, 3],
    ],
  },
  arc: {
    points: [
      [0, 0],
      [10, 0],
    ],
    ...{radius: 5, sweep: Math.PI},
  },
  'long arc to the right': {
    points: [
      [0, 0],
      [0, 6],
    ],
    ...{radius: 5, sweep: -2 * Math.PI + 2 * Math.asin(0.6)},
  },
  path: {
    points: [
      [0, 0],
      [1, 4],
      [4, 6],
      [8, 6],
      [11, 6],
      [14, 9],
      [20, 8],
    ],
  },
};

/** Distance from a point to a line through points. [cm] */
const apart = (point: Point, line: readonly Point[]): number =>
  Math.min(
    ...line.slice(1).map((to, k) => {
      const from = line[k] ?? to;
      return distance(between(from, to, nearestShare(from, to, point)), point);
    }),
  );

describe.each(Object.entries(curves))('a %s', (_, edge) => {
  it('is as long as the line through its points, nearly', () => {
    const line = edgeLine(edge);
    expect(line[0]).toEqual(edge.points[0]);
    expect(line.at(-1)).toEqual(edge.points.at(-1));
    expect(edgeLength(edge) - lengthOf(line)).toBeGreaterThan(-1e-9);
    expect(edgeLength(edge) - lengthOf(line)).toBeLessThan(0.002 * edgeLength(edge));
  });

  it.each([0.13, 0.5, 0.77])('runs as before once it is split at %f of its length', (share) => {
    const [first, second] = splitCurve(edge, share);
    const whole = edgeLength(edge);
    expect(edgeLength(first)).toBeCloseTo(share * whole, 8);
    expect(edgeLength(second)).toBeCloseTo((1 - share) * whole, 8);
    expect(first.points.at(-1)).toEqual(second.points[0]);
    const line = edgeLine(edge);
    // error of a line through 32 points for this curve
    for (const point of [...edgeLine(first), ...edgeLine(second)])
      expect(apart(point, line)).toBeLessThan(0.015);
  });
});

/** Two squares of 4 cm, the right side of the first sewn to the left side of the second. */
const squares = (changes: Partial<GarmentDocument> = {}): GarmentDocument =>
  documentOf([draftedSquare('one'), draftedSquare('other')], {seams: [draftedSeam()], ...changes});

describe('splitting', () => {
  it('renumbers what comes after on the outline, and moves notches to their part', () => {
    const notches = [
      {edge: 0, at: 0.25},
      {edge: 0, at: 0.75},
      {edge: 2, at: 0.1},
    ];
    const piece = draftedSquare('one', {notches});
    const document = documentOf([piece, draftedSquare('other')], {
      seams: [draftedSeam()],
      symmetries: ['one', 'other'].map((name) => ({kind: 'piece', piece: name, seams: [1, 3]})),
    });
    const {document: next, edgesOf} = splitEdge(document, {piece: 0, edge: 0}, 0.5);
    expect(next.pieces[0]?.outline.map(({points}) => points[0])).toEqual([
      [0, 0],
      [2, 0],
      [4, 0],
      [4, 4],
      [0, 4],
    ]);
    expect(next.pieces[0]?.notches).toEqual([
      {edge: 0, at: 0.5},
      {edge: 1, at: 0.5},
      {edge: 3, at: 0.1},
    ]);
    expect(next.seams).toEqual([draftedSeam({a: {piece: 0, edge: 2}})]);
    expect(next.symmetries).toEqual([
      {kind: 'piece', piece: 'one', seams: [2, 4]},
      {kind: 'piece', piece: 'other', seams: [1, 3]},
    ]);
    expect(edgesOf({piece: 0, edge: 0})).toEqual([
      {piece: 0, edge: 0},
      {piece: 0, edge: 1},
    ]);
    expect(edgesOf({piece: 0, edge: 3})).toEqual([{piece: 0, edge: 4}]);
    expect(edgesOf({piece: 1, edge: 3})).toEqual([{piece: 1, edge: 3}]);
  });

  it('keeps what the program does not know on both parts', () => {
    const piece = draftedSquare('one');
    const outline = piece.outline.map((edge) => ({...edge, label: 'hem', more: {finish: 'raw'}}));
    const {document} = splitEdge(documentOf([{...piece, outline}]), {piece: 0, edge: 3}, 0.25);
    for (const edge of document.pieces[0]?.outline ?? [])
      expect(edge).toMatchObject({label: 'hem', more: {finish: 'raw'}});
  });

  it('splits what an edge is sewn to at the same place, and the seam with it', () => {
    const {document, seamsOf} = splitEdge(squares(), {piece: 0, edge: 1}, 0.25);
    expect(document.seams.map(({a, b}) => [a, b])).toEqual([
      [
        {piece: 0, edge: 1},
        {piece: 1, edge: 4},
      ],
      [
        {piece: 0, edge: 2},
        {piece: 1, edge: 3},
      ],
    ]);
    expect(document.pieces[1]?.outline[4]?.points).toEqual([
      [0, 1],
      [0, 0],
    ]);
    expect(seamsOf(0)).toEqual([0, 1]);
  });

  it('splits both legs of a dart, whichever is meant', () => {
    const dart = documentOf([draftedSquare('one')], {
      seams: [draftedSeam({a: {piece: 0, edge: 1}, b: {piece: 0, edge: 2}})],
    });
    for (const [edge, share] of [
      [1, 0.25],
      [2, 0.75],
    ] as const) {
      const {document} = splitEdge(dart, {piece: 0, edge}, share);
      expect(document.pieces[0]?.outline.length).toBe(6);
      expect(
        document.seams
          .map(({a, b}) => [a.edge, b.edge].sort().join(' '))
          .sort((one, other) => one.localeCompare(other)),
      ).toEqual(['1 4', '2 3']);
    }
  });

  it('says the axis where edges that a symmetry names are not whole any more', () => {
    const document = squares({symmetries: [{kind: 'piece', piece: 'other', seams: [1, 3]}]});
    const {document: next} = splitEdge(document, {piece: 1, edge: 1}, 0.4);
    expect(next.symmetries).toEqual([
      {
        ...{kind: 'piece', piece: 'other'},
        axis: [
          [2, 0],
          [2, 4],
        ],
      },
    ]);
  });
});

describe('sewing', () => {
  const bare = squares({seams: []});

  it('makes a seam, and takes it apart again', () => {
    const [a, b] = [
      {piece: 0, edge: 1},
      {piece: 1, edge: 3},
    ];
    const {document} = sew(bare, {a: [a], b: [b], sameDirection: false});
    expect(document).toEqual(squares());
    expect(seamAt(document, b)).toBe(0);
    expect(turnSeam(document, 0).document.seams[0]?.sameDirection).toBe(true);
    expect(unsew(document, 0).document).toEqual(bare);
  });

  it('numbers the seams after one that is taken apart anew', () => {
    const seams = [draftedSeam({name: 'x'}), draftedSeam({name: 'y'}), draftedSeam({name: 'z'})];
    const {document, seamsOf} = unsew({...bare, seams}, 1);
    expect(document.seams.map(({name}) => name)).toEqual(['x', 'z']);
    expect([0, 1, 2].map(seamsOf)).toEqual([[0], [], [1]]);
  });

  it.each([true, false])(
    'splits one edge where two meet that it is sewn to (%s)',
    (sameDirection) => {
      const two = splitEdge(bare, {piece: 0, edge: 1}, 0.25);
      const run = two.edgesOf({piece: 0, edge: 1});
      const one = [{piece: 1, edge: 3}];
      for (const [a, b] of [
        [run, one],
        [one, run],
      ] as const) {
        const {document} = sew(two.document, {a, b, sameDirection});
        expect(document.seams.length).toBe(2);
        expect(document.pieces.map(({outline}) => outline.length)).toEqual([5, 5]);
        for (const seam of document.seams)
          expect(sideLength(document, [seam.a])).toBeCloseTo(sideLength(document, [seam.b]), 9);
      }
    },
  );

  it('does not split where edges of both sides end at the same place', () => {
    const two = splitEdge(bare, {piece: 0, edge: 1}, 0.5);
    const both = splitEdge(two.document, {piece: 1, edge: 3}, 0.52);
    const a = [0, 1].map((k) => ({piece: 0, edge: 1 + k}));
    const b = [0, 1].map((k) => ({piece: 1, edge: 3 + k}));
    const {document} = sew(both.document, {a, b, sameDirection: false});
    expect(document.seams.map((seam) => [seam.a.edge, seam.b.edge])).toEqual([
      [1, 4],
      [2, 3],
    ]);
  });

  it('closes what was said to stay open', () => {
    const a = {piece: 0, edge: 1};
    const open = setOpen(bare, a, true).document;
    expect(isOpen(open.pieces[0]?.outline[1])).toBe(true);
    expect(sew(open, {a: [a], b: [{piece: 1, edge: 3}], sameDirection: false}).document).toEqual(
      squares(),
    );
    expect(setOpen(open, a, false).document).toEqual(bare);
  });
});

it('says what is cut beyond an edge, or leaves it as usual', () => {
  const at = {piece: 0, edge: 0};
  const {document} = setAllowance(squares(), at, {width: 3, corner: 'mirror'});
  expect(document.pieces[0]?.outline[0]?.allowance).toEqual({width: 3, corner: 'mirror'});
  expect(setAllowance(document, at, undefined).document).toEqual(squares());
});

it('calls a piece otherwise, and leaves one out with all that names it', () => {
  const seams = [draftedSeam(), draftedSeam({a: {piece: 1, edge: 0}, b: {piece: 1, edge: 2}})];
  const document = squares({
    ...{seams, symmetries: [{kind: 'pair', pieces: ['one', 'other']}]},
    names: {one: 'Front', other: 'Back'},
  });
  expect(rename(document, 1, 'Back').document.pieces[1]?.label).toBe('Back');
  const {document: rest, edgesOf, seamsOf} = removePiece(document, 0);
  expect(rest).toEqual(
    documentOf([draftedSquare('other')], {
      seams: [draftedSeam({a: {piece: 0, edge: 0}, b: {piece: 0, edge: 2}})],
      names: {other: 'Back'},
    }),
  );
  expect([edgesOf({piece: 0, edge: 1}), edgesOf({piece: 1, edge: 1})]).toEqual([
    [],
    [{piece: 0, edge: 1}],
  ]);
  expect([seamsOf(0), seamsOf(1)]).toEqual([[], [0]]);
});

it('takes what a design decides of edges and seams along', () => {
  const seams = [draftedSeam(), draftedSeam({a: {piece: 0, edge: 0}, b: {piece: 1, edge: 0}})];
  const document = squares({seams});
  const design = {
    garment: {name: 'squares.json', text: '{}', sample: {style: 'tee', size: 'm'}},
    options: {locked: {one: [1, 2], other: true}, weights: {'0': 2, '1': 3}, unmatched: [0]},
    symmetry: [
      {kind: 'piece', piece: 'one', seams: [0, 2]},
      {kind: 'piece', piece: 'other', seams: [3, 1]},
    ],
  } satisfies Partial<Design>;
  const split = designAfter(design, document, splitEdge(document, {piece: 0, edge: 1}, 0.5));
  expect(split.options).toEqual({
    locked: {one: [1, 2, 3], other: true},
    weights: {'0': 2, '1': 3, '2': 2},
    unmatched: [0, 2],
  });
  expect(split.symmetry).toEqual([
    {kind: 'piece', piece: 'one', seams: [0, 3]},
    {
      ...{kind: 'piece', piece: 'other'},
      axis: [
        [2, 4],
        [2, 0],
      ],
    },
  ]);
  expect(split.garment.sample).toBeUndefined();
  const apart = designAfter(design, document, unsew(document, 0));
  expect(apart.options).toEqual({
    locked: {one: [1, 2], other: true},
    weights: {'0': 3},
    unmatched: [],
  });
});

it('an outline goes straight on where a curve ends along the next edge', () => {
  const corner: Point = [0, 0];
  const end: Point = [10, 5];
  const outline: DraftedEdge[] = [
    {points: [corner, [0, 5], [5, 5]]},
    {points: [[5, 5], end]},
    {points: [end, corner]},
  ];
  const document = documentOf([draftedSquare('a', {outline})]);
  expect([0, 1, 2].map((edge) => goesStraightOn(document, {piece: 0, edge}))).toEqual([
    true,
    false,
    false,
  ]);
});
