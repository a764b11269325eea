/** Names of a repeat's arrows on its photo. */
import type {Point} from '../model/geometry/vectors.js';
import {vectorsAtMiddle} from '../model/print/photo-map.js';
import type {PhotoMap} from '../model/print/photo-reading.js';
import type {PhotoSize} from './lattice-lines.js';

/** One name for each vector; stripes have no second arrow. */
export type ArrowNames = Readonly<{w1: string; w2?: string}>;

/** Share of a vector that runs up or down the photo. */
const rise = ([x, y]: Point): number => Math.abs(y) / Math.hypot(x, y);

/** Returns the names by the directions on the photo: the flatter arrow is `across`. */
export function arrowNames(
  map: PhotoMap,
  size: PhotoSize,
  {across, up}: {readonly across: string; readonly up: string},
): Required<ArrowNames> {
  const {w1Px, w2Px} = vectorsAtMiddle(map, size);
  return rise(w1Px) > rise(w2Px) ? {w1: up, w2: across} : {w1: across, w2: up};
}
