/** The graphics state of a page while its operators are read. Lengths of dashes and widths in mm. */
import type {Box} from '../../../model/geometry/polyline.js';
import {
  after,
  determinant,
  identity,
  planeMap,
  type PlaneMap,
} from '../../../model/geometry/plane-map.js';

export interface Graphics {
  /** From units of the content to mm. */
  readonly map: PlaneMap;
  readonly clip: Box;
  readonly stroke: string;
  readonly fill: string;
  /** In units of the content. */
  readonly width: number;
  readonly dash: readonly number[];
  readonly strokeOpacity: number;
  readonly fillOpacity: number;
  readonly text: TextState;
}

export interface TextState {
  readonly matrix: PlaneMap;
  readonly lineMatrix: PlaneMap;
  readonly size: number;
  readonly leading: number;
  readonly letterSpace: number;
  readonly wordSpace: number;
  /** Horizontal scale, 1 for 100 %. */
  readonly scale: number;
  readonly rise: number;
}

const initialText: TextState = {
  ...{matrix: identity, lineMatrix: identity, size: 1, leading: 0},
  ...{letterSpace: 0, wordSpace: 0, scale: 1, rise: 0},
};

export const initialGraphics = (map: PlaneMap, clip: Box): Graphics => ({
  ...{map, clip, stroke: '#000000', fill: '#000000', width: 1, dash: []},
  ...{strokeOpacity: 1, fillOpacity: 1, text: initialText},
});

/** The map of six numbers in the order of PDF. */
export function mapOf(numbers: ArrayLike<number>): PlaneMap {
  const [a = 1, b = 0, c = 0, d = 1, e = 0, f = 0] = Array.from(numbers);
  return planeMap(a, c, b, d, e, f);
}

/** The mean factor by which a map enlarges lengths. */
export const growthOf = (map: PlaneMap): number => Math.sqrt(Math.abs(determinant(map)));

/** Applies a map before the current one. */
export const transformed = (state: Graphics, map: PlaneMap): Graphics => ({
  ...state,
  map: after(state.map, map),
});
