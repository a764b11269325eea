/** Folds by places on a piece, and the edges and seams that follow them. */
import {expect, it} from 'vitest';

import {edgeLength} from '@/model/garment/edge-curve.js';
import {edgeOf} from '@/model/garment/edits.js';
import type {DraftedFold} from '@/model/garment/garment-document.js';
import type {Point} from '@/model/geometry/vectors.js';
import {
  foldImage,
  isSameFold,
  overlapsPleat,
  replaceFold,
  withFold,
  withoutFold,
} from '@/sewing/fold-edits.js';
import {
  foldAt,
  innerLineAt,
  uptakeOf,
  withLength,
  withUptake,
  type FoldPlace,
} from '@/sewing/fold-places.js';
import {
  documentOf,
  draftedPolygon,
  draftedRectangle,
  draftedSeam,
} from '../../support/garments/documents.js';

const skirt = draftedRectangle('skirt', 50, 40);
/** A skirt whose waist, edge 2, is sewn to a band that is 10 cm shorter. */
const garment = documentOf([skirt, draftedRectangle('band', 40, 40)], {
  seams: [draftedSeam({a: {piece: 0, edge: 2}, b: {piece: 1, edge: 0}, name: 'Waist'})],
});
const at = (x: number, y = 40): FoldPlace => ({point: [x, y]});

/** Fails the test if the places give no fold. */
function fold(...[piece, kind, places, lengthCm]: Parameters<typeof foldAt>): DraftedFold {
  const made = foldAt(piece, kind, places, lengthCm);
  if (typeof made === 'string') throw new Error(made);
  return made;
}
const rounded = (one: DraftedFold) => ({
  line: one.line.map(([x, y]) => [Math.round(x), Math.round(y)]),
  to: one.to?.map(([x, y]) => [Math.round(x), Math.round(y)]),
});
const pleat = fold(skirt, 'inverted', [at(20), at(30)]);

it('runs from the edge to the other side of the piece, at a right angle', () => {
  expect(rounded(pleat)).toEqual({
    line: [
      [20, 40],
      [20, 0],
    ],
    to: [
      [30, 40],
      [30, 0],
    ],
  });
});

it('starts at the nearest edge from a place inside the piece', () => {
  expect(rounded(fold(skirt, 'knife', [at(20, 3), at(24, 3)])).line).toEqual([
    [20, 0],
    [20, 40],
  ]);
});

it('takes the longer way from a corner', () => {
  expect(rounded(fold(skirt, 'knife', [at(0, 0), at(4, 20)])).line).toEqual([
    [0, 0],
    [50, 0],
  ]);
});

it('is parallel to the grain, or to another pleat, where the edge is nearly square to it', () => {
  const slanted = draftedPolygon('skirt', [
    [0, 0],
    [50, 5],
    [50, 40],
    [0, 40],
  ]);
  const [from, to] = fold(slanted, 'knife', [at(20, 2), at(24, 2.4)]).line;
  expect(to[0] - from[0]).toBeCloseTo(0);
});

it('ends a tuck at its length', () => {
  expect(rounded(fold(skirt, 'tuck', [at(20), at(24)], 15)).to?.[1]).toEqual([24, 25]);
});

it('follows lines that are drawn on the piece', () => {
  const line: readonly Point[] = [
    [10, 1],
    [12, 39],
  ];
  const drawn = {...skirt, internalLines: [line]};
  const inner = innerLineAt(drawn, [11, 20], 1);
  expect(inner).toEqual([line[0], line[1]]);
  expect(
    fold(drawn, 'press', [{point: [11, 20], ...(inner && {line: inner})}, at(0)]).line,
  ).toEqual(line);
});

it('refuses lines that are too near', () => {
  expect(foldAt(skirt, 'knife', [at(20), at(20.1)])).toBe('near');
  expect(foldAt(skirt, 'roll', [at(20), at(20.1)])).toBe('near');
});

it('changes the fabric and the length of a pleat', () => {
  expect(uptakeOf(withUptake(skirt, pleat, 12))).toBeCloseTo(12);
  const short = withLength(skirt, pleat, 9);
  expect(rounded(short).line[1]).toEqual([20, 31]);
  expect(rounded(withLength(skirt, short, undefined))).toEqual(rounded(pleat));
});

it('sews the edge beside a new pleat, and the whole edge once it is removed', () => {
  const {document, seamsOf} = withFold(garment, 0, pleat);
  const lengths = document.seams.map(({a, b}) =>
    [a, b].map((edge) => {
      const drafted = edgeOf(document, edge);
      return drafted && Math.round(edgeLength(drafted));
    }),
  );
  expect(lengths).toEqual([
    [20, 20],
    [20, 20],
  ]);
  expect(seamsOf(0)).toEqual([0, 1]);
  const back = withoutFold(document, 0, 0);
  expect(back.document.pieces.map(({outline}) => outline.length)).toEqual([4, 4]);
  expect(back.document.seams).toEqual(garment.seams);
  expect(back.seamsOf(1)).toEqual([0]);
});

it('keeps the corners of the pleats that remain', () => {
  const other = fold(skirt, 'knife', [at(5), at(9)]);
  const both = withFold(withFold(garment, 0, pleat).document, 0, other).document;
  expect(both.pieces[0]?.outline).toHaveLength(12);
  const left = withoutFold(both, 0, 0).document;
  expect(left.pieces[0]?.outline).toHaveLength(8);
  expect(left.seams).toHaveLength(2);
});

it('replaces a kind in place, and moves edges with other lines', () => {
  const {document} = withFold(garment, 0, pleat);
  const box = replaceFold(document, 0, 0, {...pleat, kind: 'box'}).document;
  expect(box.pieces[0]?.outline).toBe(document.pieces[0]?.outline);
  const wide = replaceFold(document, 0, 0, withUptake(skirt, pleat, 14)).document;
  expect(wide.pieces[0]?.outline).toHaveLength(8);
  expect(wide.seams).toHaveLength(2);
});

it('finds pleats that overlap', () => {
  const {document} = withFold(garment, 0, pleat);
  expect(overlapsPleat(document, 0, fold(skirt, 'knife', [at(25), at(35)]))).toBe(true);
  expect(overlapsPleat(document, 0, fold(skirt, 'knife', [at(30), at(35)]))).toBe(false);
});

it('mirrors a fold, and knows one that is its own image', () => {
  const mirror = {angle: 0, translation: [50, 0] as Point};
  expect(isSameFold(foldImage(pleat, mirror), pleat)).toBe(true);
  const left = fold(skirt, 'knife', [at(5), at(9)]);
  expect(rounded(foldImage(left, mirror)).line[0]).toEqual([45, 40]);
});
