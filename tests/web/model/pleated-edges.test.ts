/** Edges divided where the lines of pleats meet them. */
import {expect, it} from 'vitest';

import {edgeLength} from '@/model/garment/edge-curve.js';
import type {DraftedFold} from '@/model/garment/garment-document.js';
import {edgeOf} from '@/model/garment/edits.js';
import {divideAtFolds} from '@/model/garment/pleated-edges.js';
import {documentOf, draftedRectangle, draftedSeam} from '../../support/garments/documents.js';

const pleat = (from: number, to: number): DraftedFold => ({
  kind: 'inverted',
  line: [
    [from, 40],
    [from, 0],
  ],
  to: [
    [to, 40],
    [to, 0],
  ],
});

/** A skirt of 50 cm with two pleats of 10 cm, whose waist is sewn to a band of 30 cm. */
const skirt = documentOf(
  [
    draftedRectangle('skirt', 50, 40, {folds: [pleat(5, 15), pleat(30, 40)]}),
    draftedRectangle('band', 30, 40),
  ],
  {
    seams: [
      draftedSeam({
        a: {piece: 0, edge: 2},
        b: {piece: 1, edge: 0},
        name: 'Waist',
        lengthRatio: 1.67,
      }),
    ],
  },
);

it('sews the parts between pleats, each to an edge of its length', () => {
  const {document, seamsOf, edgesOf} = divideAtFolds(skirt);
  const lengths = document.seams.map(({a, b}) =>
    [a, b].map((edge) => {
      const drafted = edgeOf(document, edge);
      return drafted && edgeLength(drafted);
    }),
  );
  expect(lengths.map(([a, b]) => [a?.toFixed(6), b?.toFixed(6)])).toEqual([
    ['10.000000', '10.000000'],
    ['15.000000', '15.000000'],
    ['5.000000', '5.000000'],
  ]);
  expect(document.seams.map(({name, lengthRatio}) => [name, lengthRatio])).toEqual(
    Array.from({length: 3}, () => ['Waist', undefined]),
  );
  expect(seamsOf(0)).toEqual([0, 1, 2]);
  expect(edgesOf({piece: 0, edge: 2})).toHaveLength(5);
  expect(edgesOf({piece: 0, edge: 0})).toHaveLength(5);
});

it('changes nothing in edges that are divided already', () => {
  const once = divideAtFolds(skirt).document;
  const twice = divideAtFolds(once);
  expect(twice.document).toEqual(once);
  expect(twice.seamsOf(1)).toEqual([1]);
});

it('ignores creases', () => {
  const crease = {...pleat(5, 15), kind: 'press'} as const;
  const pressed = documentOf([draftedRectangle('skirt', 50, 40, {folds: [crease]})]);
  expect(divideAtFolds(pressed).document).toEqual(pressed);
});
