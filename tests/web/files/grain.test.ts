/** Grain lines of drawings; their direction is independent of the end they start at. */
import {expect, it} from 'vitest';

import {readDrawing} from '@/files/read-drawing.js';
import {defaultChoices, garmentOf} from '@/files/to-garment.js';
import {angleOf, degrees, minus, type Point} from '@/model/geometry/vectors.js';

import {
  bodice,
  freesewing,
  freesewingPart,
  millimetreSheet,
  stroked,
  svg,
  words,
} from '../../support/files/drawn-svg.js';
import {bowedSquare, dxfOf, habits} from '../../support/files/dxf-habits.js';

/** Direction of each piece's grain, from the x axis. [degrees] */
function grains(text: string, name: string): number[] {
  const drawing = readDrawing(new TextEncoder().encode(text), name);
  const {pieces} = garmentOf(drawing, defaultChoices(drawing));
  return pieces.map(({grain}) => {
    const [from, to] = grain?.line ?? [];
    return from && to ? Math.round(degrees(angleOf(minus(to, from)))) : NaN;
  });
}

const both = (line: readonly [Point, Point]): (readonly [Point, Point])[] => [
  line,
  [line[1], line[0]],
];

it('runs up a piece that FreeSewing cuts on the fold, whose mark it draws downwards', () => {
  expect(grains(freesewing(freesewingPart('front')), 'front.svg')).toEqual([90]);
});

it.each(['M 60 150 L 60 380', 'M 60 380 L 60 150'])('runs up a drawing with %s', (line) => {
  const drawn = svg(
    millimetreSheet,
    stroked(bodice(1, [20, 20])),
    stroked(line),
    words(66, 300, 'Grain'),
  );
  expect(grains(drawn, 'front.svg')).toEqual([90]);
});

it.each([
  ['upwards', [30, 5], [30, 55], 90],
  ['to the right', [5, 30], [55, 30], 0],
  ['to the right, nearly', [5, 30], [55, 20], -11],
  ['up to the left', [50, 10], [10, 50], 135],
] as const)('points %s in DXF, either way drawn', (_, from, to, wanted) => {
  const pieces = both([from, to]).map((grain, k) => ({...bowedSquare(`piece ${k}`, 60), grain}));
  expect(grains(dxfOf(pieces, habits.browzwear), 'pieces.dxf')).toEqual([wanted, wanted]);
});
