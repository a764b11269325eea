/** Several grain lines of a piece: on grain, across and on the bias. */
import {expect, it} from 'vitest';

import {grainChoices, withGrainChoices} from '@/cli/base/grain-choice.js';
import {grainIn} from '@/cli/result-file.js';
import {grainsAmong} from '@/files/base/grain-lines.js';
import {readDrawing} from '@/files/read-drawing.js';
import {defaultChoices, garmentOf} from '@/files/to-garment.js';
import type {GarmentPiece} from '@/model/garment/garment-document.js';
import {panelMarks} from '@/model/garment/panel-marks.js';
import type {Point} from '@/model/geometry/vectors.js';
import {dxfOf, habits} from '../../support/files/dxf-habits.js';
import {draftedSquare} from '../../support/garments/documents.js';

const straight: readonly [Point, Point] = [
  [5, 2],
  [5, 18],
];
const bias: readonly [Point, Point] = [
  [2, 2],
  [14, 14],
];
const named = [
  {at: [5.5, 10] as Point, text: 'Straight grain'},
  {at: [8.5, 8] as Point, text: 'Bias'},
];

it('names each line by the text beside it', () => {
  const found = grainsAmong([straight, bias], named, {cmPerUnit: 1, isSure: false});
  expect(found).toEqual([
    {name: 'Straight grain', line: straight},
    {name: 'Bias', line: bias},
  ]);
});

it('takes lines without text only where the file marks them as grain lines', () => {
  const read = (isSure: boolean) => grainsAmong([straight, bias], [], {cmPerUnit: 1, isSure});
  expect(read(true)).toHaveLength(2);
  expect(read(false)).toEqual([]);
});

it('ignores arrowheads, and a second line in the same direction', () => {
  const head: readonly [Point, Point] = [
    [5, 18],
    [4.4, 17],
  ];
  const beside: readonly [Point, Point] = [
    [9, 2],
    [9, 18],
  ];
  expect(grainsAmong([straight, head, beside], [], {cmPerUnit: 1, isSure: true})).toEqual([]);
});

it('reads two lines on the layer of the grain from DXF', () => {
  const corners: readonly Point[] = [
    [0, 0],
    [30, 0],
    [30, 40],
    [0, 40],
  ];
  const edges = corners.map((from, k) => [from, corners[(k + 1) % 4] ?? from]);
  const text = dxfOf(
    [
      {
        name: 'front',
        edges,
        grain: straight,
        labelled: [{line: bias, text: 'Bias', layer: '7'}],
      },
    ],
    habits.gerber,
  );
  const drawing = readDrawing(new TextEncoder().encode(text), 'pattern.dxf');
  const [front] = garmentOf(drawing, defaultChoices(drawing)).pieces;
  expect(front?.grains?.map(({name}) => name)).toEqual([undefined, 'Bias']);
  expect(front?.grain?.line?.[0][0]).toBeCloseTo(front?.grain?.line?.[1][0] ?? NaN);
});

const front: GarmentPiece = draftedSquare('front', {
  grain: {line: straight},
  grains: [
    {name: 'On grain', line: straight},
    {name: 'Bias', line: bias},
  ],
});

it('marks the line in use, at its place and by its name', () => {
  const marksOf = (angleDeg?: number) =>
    panelMarks({pieces: [front]}, angleDeg === undefined ? {} : {grain: {front: {angleDeg}}}).get(
      'front',
    );
  expect(marksOf()).toMatchObject({grain: straight, grainName: 'On grain'});
  expect(marksOf(45)).toMatchObject({grain: bias, grainName: 'Bias', grainDeg: 45});
  expect(marksOf(30)?.grainName).toBeUndefined();
});

it('chooses a line on the command line, by name or number', () => {
  const garment = {pieces: [front]};
  expect(grainChoices(garment, ['front=bias'])).toEqual({front: {angleDeg: 45}});
  expect(grainChoices(garment, ['front=1']).front?.angleDeg).toBeCloseTo(90);
  expect(() => grainChoices(garment, ['front=warp'])).toThrow(
    "piece 'front' has no line 'warp'; there are On grain, Bias.",
  );
  expect(() => grainChoices(garment, ['back=1'])).toThrow("no piece 'back'; there are front.");
  const options = withGrainChoices('{"grain":{"pieces":{"front":"on"}}}', {front: {angleDeg: 45}});
  expect(JSON.parse(options)).toEqual({grain: {pieces: {front: {lock: 'on', angleDeg: 45}}}});
});

it('takes the chosen lines from the design in a result', () => {
  const pieces = {front: {lock: 'on', angleDeg: 45}, back: 'on', sleeve: {angleDeg: 'up'}};
  const result = {design: {options: {grain: {pieces}}}} as Parameters<typeof grainIn>[0];
  expect(grainIn(result)).toEqual({front: {angleDeg: 45}});
});
