/** Pleats and creases among lines with text beside them. */
import {expect, it} from 'vitest';

import {foldsAmong} from '@/files/base/fold-lines.js';
import type {Point} from '@/model/geometry/vectors.js';

const upright = (x: number): readonly Point[] => [
  [x, 0],
  [x, 40],
];
const label = (x: number, text: string) => ({at: [x, 20] as Point, text});
const hem: readonly Point[] = [
  [0, 0],
  [60, 0],
];

it.each([
  ['Box pleat', 'box'],
  ['Kellerfalte', 'inverted'],
  ['Pli creux', 'inverted'],
  ['Alforza', 'tuck'],
  ['Piega', 'knife'],
])('reads two lines with "%s" as a pleat', (text, kind) => {
  const lines = [upright(10), upright(14), hem];
  const {folds, lines: others} = foldsAmong(lines, [label(10, text), label(14, text)], 1);
  expect(folds).toEqual([{kind, line: upright(10), to: upright(14)}]);
  expect(others).toEqual([hem]);
});

it('pairs each line with the nearest one', () => {
  const lines = [10, 14, 30, 34].map(upright);
  const labels = [10, 14, 30, 34].map((x) => label(x, 'tuck'));
  const {folds} = foldsAmong(lines, labels, 1);
  expect(folds.map(({line, to}) => [line[0][0], to?.[0][0]])).toEqual([
    [10, 14],
    [30, 34],
  ]);
});

it('reads a press line as a crease', () => {
  const {folds} = foldsAmong([upright(10)], [label(10.5, 'Press line')], 1);
  expect(folds).toEqual([{kind: 'press', line: upright(10)}]);
});

it('leaves lines of half pieces, and pleats of one line, as lines', () => {
  for (const text of ['Couper 2 au pli', 'Cut 2 on fold', 'Pleat']) {
    const {folds, lines} = foldsAmong([upright(10)], [label(10, text)], 1);
    expect(folds, text).toEqual([]);
    expect(lines, text).toEqual([upright(10)]);
  }
});

const across = (from: number, to: number): readonly Point[] => [
  [from, 20],
  [to, 20],
];
const headAt = (x: number, way: 1 | -1): readonly Point[] => [
  [x - way, 20.4],
  [x, 20],
  [x - way, 19.6],
];

it('reads a pleat by one text between its lines', () => {
  const {folds} = foldsAmong([upright(10), upright(14), hem], [label(11.5, 'Pleat')], 1);
  expect(folds).toEqual([{kind: 'knife', line: upright(10), to: upright(14)}]);
});

it('lays a pleat as its arrow points', () => {
  const lines = [upright(10), upright(14), across(10, 14), headAt(10, -1)];
  const {folds, lines: others} = foldsAmong(lines, [label(9, 'Pleat')], 1);
  expect(folds).toEqual([{kind: 'knife', line: upright(14), to: upright(10)}]);
  expect(others).toEqual([]);
});

it.each(['Fold here', 'Hier falten', 'Plier ici', 'Doblar aquí', 'Piegare qui'])(
  'reads "%s" as a crease',
  (text) => {
    const {folds} = foldsAmong([upright(10)], [label(10.5, text)], 1);
    expect(folds).toEqual([{kind: 'press', line: upright(10)}]);
  },
);
