/** An image with known ground truth, in the format of cases.json. */
import type {Point} from '@/model/geometry/vectors.js';
import type {GroupName} from '@/model/print/repeating-print.js';

import type {LatticeView} from './camera.js';
import type {Cell} from './drawn-print.js';
import {toGamma} from './inks.js';
import type {PhotoLevel} from './conditions.js';
import type {Rgba} from './pixels.js';

type Level = PhotoLevel | 'covered' | 'decoy' | 'tile';

/** Fields of a case's entry in cases.json about its print; lengths in cm. */
export interface PrintTruth extends LatticeView {
  readonly group: GroupName;
  readonly w1: Point;
  readonly w2: Point;
  /** Origin of the group, in lattice coordinates: always [0, 0]. */
  readonly origin: Point;
  /** The origin nearest to the image's middle. [px] */
  readonly originPx: Point;
  /** Least share of its energy by which the print breaks a symmetry that it lacks. */
  readonly broken: number;
  /** True where `broken` is below 6 %: then an almost valid symmetry is no mistake. */
  readonly near: boolean;
  /** Edges of a tile's image on the fabric, to the right and up. [cm] */
  readonly right?: Point;
  readonly up?: Point;
}

/** Fields of every case. */
export interface CaseHead {
  readonly name: string;
  readonly level: Level;
  /** Kind of subject: floral, plaid, bricks, ... */
  readonly kind: string;
  readonly seed: number;
  readonly width: number;
  readonly height: number;
  /** Null if unknown. */
  readonly f35: number | null;
}

export type CaseTruth = CaseHead & (PrintTruth | {readonly group: null; readonly homography: null});

export interface PhotoCase {
  readonly truth: CaseTruth;
  readonly pixels: Rgba;
  /** The print's cell, where there is one. */
  readonly cell: Cell | undefined;
}

/** Sample j * n + i at (i / n, j / n), as the file's pixel (i, j). */
export function cellPixels({n, planes}: Cell): Rgba {
  const data = new Uint8ClampedArray(4 * n * n).fill(255);
  planes.forEach((plane, c) => {
    for (let k = 0; k < plane.length; k++) data[4 * k + c] = 255 * toGamma(plane[k] ?? 0);
  });
  return {width: n, height: n, data};
}
