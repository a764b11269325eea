/** A small problem that takes a solver through all its stages, so that the engine has compiled them. */
import type {Problem} from '../model/problem.js';

const panel = (left: number) => ({
  translation: [left, 0, 0],
  rotation: [0, 0, 0],
  vertices: [
    [0, 0],
    [6, 0],
    [6, 6],
    [0, 6],
  ],
  edges: [
    {endpoints: [0, 1]},
    {endpoints: [1, 2], curvature: [0.5, 0.15]},
    {endpoints: [2, 3]},
    {endpoints: [3, 0]},
  ],
});

/** Two pieces; of their seam, one side is curved and the other is not, so that they have to be reshaped. */
export const warmUpProblem: Problem = {
  garment: JSON.stringify({
    pattern: {
      panels: {one: panel(-8), other: panel(2)},
      stitches: [
        [
          {panel: 'one', edge: 1},
          {panel: 'other', edge: 3},
        ],
        [
          {panel: 'one', edge: 0},
          {panel: 'other', edge: 2},
        ],
      ],
    },
    properties: {units_in_meter: 100, curvature_coords: 'relative'},
  }),
  print: {group: 'pmm', w1: [2, 0], w2: [0, 2.5]},
};
