/** Texts about a cutting sheet on its first page. */
import {expect, it} from 'vitest';

import {draftedSheet} from '@/cutting/drafted-sheet.js';
import type {DraftedEdge} from '@/model/garment/garment-document.js';
import type {Point} from '@/model/geometry/vectors.js';

import {documentOf, draftedSquare} from '../../support/garments/documents.js';

/**
 * A single square; the allowance of its first edge is the hem, the other edges have `others` in
 * turn. [cm]
 */
function sheetOf(hem: number | undefined, others: readonly (number | undefined)[]) {
  const {outline} = draftedSquare('front');
  const edges = outline.map((edge, k): DraftedEdge => {
    const width = k === 0 ? hem : others[(k - 1) % others.length];
    return {...edge, ...(width !== undefined && {allowance: {width}})};
  });
  const garment = documentOf([draftedSquare('front', {outline: edges})]);
  return draftedSheet(garment, {allowanceCm: 1, hemCm: 3, units: 'cm'});
}

it.each([
  ['by the rule', undefined, [undefined], '1 cm inside, 3 cm at hems.', 'none'],
  ['by the pattern', 1, [1], '1 cm inside.', 'all'],
  ['with another hem', 2, [1.5], '1.5 cm inside, 2 cm at hems.', 'all'],
  ['of the hem alone', 2, [undefined], '1 cm inside, 2 cm at hems.', 'some'],
  [
    ...['of some edges', undefined, [undefined, 0.5]],
    ...['1 cm inside, 3 cm at hems, elsewhere as in the pattern.', 'some'],
  ],
  [
    'of all in different ways',
    0.5,
    [0.6, 0.5],
    '0.5 cm at hems, elsewhere as in the pattern.',
    'all',
  ],
] as const)('tells allowances %s', (_, hem, others, said, own) => {
  const {facts, ownAllowances} = sheetOf(hem, others);
  expect(facts).toContain(`Solid: cut. Dashed: sew, ${said}`);
  expect(ownAllowances).toBe(own);
});

it('tells that there is no allowance', () => {
  expect(sheetOf(0, [0]).facts).toContain('Without allowance: sew along the solid line.');
});

it('tells how lines inside are drawn, thinner than those to cut and to sew, and dash-dot', () => {
  const line: Point[] = [
    [1, 2],
    [3, 2],
  ];
  const garment = documentOf([draftedSquare('front', {internalLines: [line]})]);
  const {facts, pieces} = draftedSheet(garment, {allowanceCm: 1, units: 'cm'});
  const said = 'Dash-dot: lines that the pattern draws inside.';
  expect(facts).toContain(said);
  expect(sheetOf(1, [1]).facts).not.toContain(said);
  const drawn = pieces.flatMap(({marks}) =>
    marks.flatMap((one) => (one.kind === 'line' ? one : [])),
  );
  const widths = (layer: string): number[] =>
    drawn.filter((one) => one.layer === layer).map(({widthMm}) => widthMm);
  const dotted = drawn.filter(({dashMm}) => dashMm?.length === 4);
  expect(dotted).toHaveLength(1);
  expect(dotted[0]?.widthMm).toBeLessThan(Math.min(...widths('cut'), ...widths('sew')));
});

it('names the grain line in use, where the maker draws several', () => {
  const bias: readonly [Point, Point] = [
    [1, 1],
    [3, 3],
  ];
  const garment = documentOf([
    draftedSquare('front', {
      grain: {line: bias},
      grains: [{angleDeg: 90}, {name: 'On the bias', line: bias}],
    }),
  ]);
  const {pieces} = draftedSheet(garment, {allowanceCm: 1, units: 'cm'});
  expect(JSON.stringify(pieces[0])).toContain('On the bias');
});

it('writes the sheet in the language of its locale', () => {
  const garment = documentOf([draftedSquare('front')]);
  const {facts, pieces, locale} = draftedSheet(garment, {
    ...{allowanceCm: 1, hemCm: 3, units: 'cm', locale: 'de-CH'},
  });
  expect(facts).toContain('Kanten mit demselben Buchstaben werden aneinandergenäht.');
  expect(facts[0]).toMatch(/^Durchgezogen: schneiden\. Gestrichelt: nähen, 1 cm weiter innen/);
  expect(pieces[0]?.words[1]).toBe('1 × aus Unistoff zuschneiden');
  expect(locale).toBe('de-CH');
});
