/** Several grain lines of a panel in garment files. */
import {readGarment, solve} from 'seamwise/node';
import {expect, it} from 'vitest';

import {grainDeg} from '@/model/garment/grain.js';
import {panelMarks} from '@/model/garment/panel-marks.js';
import {garmentFile} from '@/model/garment/write-garment.js';

const straight = [
  [4, 2],
  [4, 8],
];

/** A square panel; clockwise edges show its back. */
function garment(changes: object, isBack = false): string {
  const corners = [
    [0, 0],
    [20, 0],
    [20, 10],
    [0, 10],
  ];
  const vertices = isBack ? corners.toReversed() : corners;
  const edges = vertices.map((_, k) => ({endpoints: [k, (k + 1) % 4]}));
  return JSON.stringify({
    pattern: {panels: {front: {vertices, edges, ...changes}}, stitches: []},
    properties: {units_in_meter: 1000},
  });
}

const directions = async (text: string) => {
  const document = await readGarment(text, 'front.json');
  const [front] = document.pieces;
  const {grain, grainName} = panelMarks(document).get('front') ?? {};
  return {
    used: grainName ?? Math.round(grainDeg(grain ? {line: grain} : {})),
    all: front?.grains?.map((one) => [one.name, Math.round(grainDeg(one))]),
  };
};

const grains = [
  {name: 'On grain', line: straight},
  {name: 'Bias', angleDeg: 30},
];

it('uses the first line unless the panel states another one', async () => {
  const all = [
    ['On grain', 90],
    ['Bias', 30],
  ];
  expect(await directions(garment({grains}))).toEqual({used: 'On grain', all});
  const grain = {
    line: [
      [0, 0],
      [5, 0],
    ],
  };
  expect(await directions(garment({grains, grain}))).toEqual({used: 0, all});
});

it('keeps lines, names and unknown members through a written file', async () => {
  const text = garment({grains: [{...grains[0], maker: 7}, grains[1]]}, true);
  const once = await readGarment(text);
  const twice = await readGarment(garmentFile(once));
  expect(twice.pieces[0]?.grains).toEqual(once.pieces[0]?.grains);
  expect(once.pieces[0]?.grains?.[0]?.more).toEqual({maker: 7});
  expect(once.pieces[0]?.mirroredFromInput).toBe(true);
});

it.each([
  ['no direction', {name: 'Bias'}, "'angleDeg'"],
  ['a point for a line', {line: [[4, 2], [4, 2]]}, "needs a 'line' of two distinct points"], // prettier-ignore
  ['a name that is no text', {name: 3, angleDeg: 45}, "'name'"],
])('refuses a grain line with %s', async (_, grain, said) => {
  const read = readGarment(garment({grains: [grains[0], grain]}), 'front.json');
  await expect(read).rejects.toThrow(said);
  await expect(read).rejects.toThrow(/^front\.json: panel 'front', grain line 1 /);
});

it('lays the piece by the chosen line', async () => {
  const print = {group: 'p2', w1: [7, 0], w2: [0, 9]};
  const angleOf = async (angleDeg?: number) => {
    const chosen = angleDeg === undefined ? {} : {pieces: {front: {angleDeg}}};
    const options = JSON.stringify({grain: {default: 'on', ...chosen}});
    const result = await solve({garment: garment({grains}), print: JSON.stringify(print), options});
    return ((result.pieces[0]?.alignment.angle ?? NaN) * 180) / Math.PI;
  };
  const turn = (degrees: number) => Math.abs(((degrees % 180) + 180) % 180);
  expect(turn(await angleOf())).toBeCloseTo(0);
  expect(turn(await angleOf(30))).toBeCloseTo(120);
});
