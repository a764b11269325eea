import {readFileSync} from 'node:fs';

import type {GarmentCodeSpecification, Point, Print} from 'seamwise/node';

/** A checked print on which any piece may be mirrored. */
export const checks: Print = {group: 'p4m', w1: [4, 0], w2: [0, 4]};

const fourEdges = [
  {endpoints: [0, 1]},
  {endpoints: [1, 2]},
  {endpoints: [2, 3]},
  {endpoints: [3, 0]},
] as const;

/** Two rectangles side by side, sewn along one vertical seam; 5 cm wide, `height` cm high. */
export function twoStrips(height = 10): GarmentCodeSpecification {
  const vertices: readonly Point[] = [
    [0, 0],
    [5, 0],
    [5, height],
    [0, height],
  ];
  const strip = {
    vertices,
    edges: fourEdges,
  };
  return {
    pattern: {
      panels: {left: strip, right: strip},
      stitches: [
        [
          {panel: 'left', edge: 1},
          {panel: 'right', edge: 3},
        ],
      ],
    },
    properties: {curvature_coords: 'relative', units_in_meter: 100},
  };
}

/**
 * A skirt of two rectangles around the waist, 12 cm high, which takes a sixth of a tee's time to
 * drape.
 * @param width  of each, in cm
 */
export function shortSkirt(width = 40.5): string {
  const panel = (z: number, turn: number) => ({
    ...{translation: [0, 94, z], rotation: [0, turn, 0]},
    vertices: [
      [-width / 2, 0],
      [width / 2, 0],
      [width / 2, 12],
      [-width / 2, 12],
    ],
    edges: fourEdges,
  });
  const side = (panel: string, edge: number) => ({panel, edge});
  return JSON.stringify({
    pattern: {
      panels: {front: panel(20, 0), back: panel(-20, 180)},
      stitches: [
        [side('front', 1), side('back', 3)],
        [side('front', 3), side('back', 1)],
      ],
    },
    properties: {curvature_coords: 'relative', units_in_meter: 100},
  });
}

/** A sample garment of the project, which takes many slices. */
export function sample(
  name:
    | 'tee'
    | 'apron'
    | 'box-pleated-skirt'
    | 'asymmetric-dress'
    | 'gathered-skirt'
    | 'hoodie'
    | 'princess-dress'
    | 'patchwork-jacket'
    | 'raglan'
    | 'shift-dress'
    | 'shirt'
    | 'six-gore-skirt'
    | 'trousers',
): string {
  return readFileSync(new URL(`../../../public/garments/${name}-m.json`, import.meta.url), 'utf8');
}
