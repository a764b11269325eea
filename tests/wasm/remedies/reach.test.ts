import {solve, withReach} from 'seamwise/node';
import {expect, it} from 'vitest';

import {checks, twoStrips} from '../../support/garments/samples.js';

const loop = [0, 1, 2].map((k) => ({endpoints: [k, k + 1]}));

/** Two pieces whose sewn edges are equally long, one straight and one an arc 9 cm high. */
const bent = JSON.stringify({
  format: 'seamwise-garment/1',
  properties: {units_in_meter: 100, curvature_coords: 'absolute'},
  pattern: {
    panels: {
      left: {
        ...{
          vertices: [
            [0, 0],
            [20, 0],
            [20, 46.365],
            [0, 46.365],
          ],
        },
        edges: [...loop, {endpoints: [3, 0]}],
      },
      right: {
        ...{
          vertices: [
            [0, 0],
            [20, 0],
            [20, 40],
            [0, 40],
          ],
        },
        edges: [...loop, {endpoints: [3, 0], curvature: {type: 'circle', params: [25, 0, 1]}}],
      },
    },
    stitches: [
      [
        {panel: 'left', edge: 1},
        {panel: 'right', edge: 3},
      ],
    ],
  },
});

it('a seam that is off by itself, too, cannot match', async () => {
  const problem = {garment: bent, print: {group: 'p1', w1: [16, 0], w2: [0, 16]}} as const;
  const result = await solve(problem);
  expect(result.seamGroups).toMatchObject([{state: 'off', reason: 'size'}]);
  const {seamGroups} = await withReach(problem, result);
  expect(seamGroups).toMatchObject([{seams: [0], state: 'cannot', reason: 'reach'}]);
});

it('a result without such a seam stays the same', async () => {
  const problem = {garment: JSON.stringify(twoStrips()), print: checks};
  const result = await solve(problem);
  expect(await withReach(problem, result)).toBe(result);
});
