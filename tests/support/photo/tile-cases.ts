/** Seamless tiles: a parallelogram of whole cells as a rectangle of pixels. */
import type {Point} from '@/model/geometry/vectors.js';
import type {GroupName} from '@/model/print/repeating-print.js';

import {inverse, scaled, type LatticeView, type Matrix3} from './camera.js';
import type {PhotoCase} from './case.js';
import {Chance} from './chance.js';
import {fabricPicture, printSampler} from './fabric-picture.js';
import type {Print} from './drawn-print.js';
import {throughJpeg} from './files.js';
import {floralPrint} from './floral-prints.js';
import {shapeOf} from './group-elements.js';
import {coded, cropped, rgba, type Rgba} from './pixels.js';
import {printCase, type PrintCase} from './print-cases.js';

/** Columns: the image's edge to the right and its edge up, in w1, w2. */
type Sides = readonly [a: number, b: number, c: number, d: number];

/** Possible edges of the image on a lattice: [right u, up u, right v, up v]. */
function choices(group: GroupName): Readonly<Record<string, Sides>> {
  const primitive: Sides = [1, 0, 0, 1];
  const turned: Sides = [0, -1, 1, 0];
  const several: Sides = [2, 0, 0, 3];
  switch (shapeOf(group)) {
    case 'oblique':
      return {primitive, turned, several};
    case 'rectangular':
      return {primitive, turned, several};
    case 'rhombic':
      // right: w1 + w2, up: w2 - w1
      return {primitive, rectangular: [1, -1, 1, 1], turned: [1, 1, -1, 1]};
    case 'square':
      // right: 2 w1 + w2, up: 2 w2 - w1
      return {primitive, several, 'oblique-lattice': [2, -1, 1, 2], diagonal: [1, -1, 1, 1]};
    case 'hexagonal':
      // up: 2 w2 - w1, or across for the turned one
      return {primitive, rectangular: [1, -1, 0, 2], turned: [-1, -1, 2, 0]};
  }
}

const combined = ({w1, w2}: Print, u: number, v: number): Point => [
  u * w1[0] + v * w2[0],
  u * w1[1] + v * w2[1],
];

/** Inverse of (u, v) = sides (x / width, 1 - y / height) + shift. */
function viewOf([a, b, c, d]: Sides, width: number, height: number, shift: Point): LatticeView {
  // prettier-ignore
  const toLattice: Matrix3 = [
    a / width, -b / height, b + shift[0],
    c / width, -d / height, d + shift[1],
    0, 0, 1,
  ];
  return {
    homography: scaled(inverse(toLattice)),
    lens: 0,
    lensMiddle: [width / 2, height / 2],
    lensRadius: Math.max(width, height) / 2,
  };
}

function painted(print: Print, view: LatticeView, width: number, height: number): Rgba {
  const light = (_x: number, _y: number, out: Float32Array): void => void out.fill(1);
  const look = {creases: undefined, weave: undefined, light};
  return rgba(
    coded(fabricPicture(printSampler(print, view, width, height), view, [width, height], look)),
  );
}

/**
 * A tile of a print in `group`. `number` selects its cell, and the seed its origin. The truth's
 * `right` and `up` are the image's edges on the fabric, in cm.
 */
export async function tileCase(
  name: string,
  group: GroupName,
  number: number,
  seed: number,
): Promise<PrintCase> {
  const chance = new Chance(seed);
  const print = floralPrint(group, chance.branch(), 512);
  const kinds = Object.entries(choices(group));
  const [kind, sides] = kinds[number % kinds.length] ?? ['primitive', [1, 0, 0, 1]];
  const right = combined(print, sides[0], sides[2]);
  const up = combined(print, sides[1], sides[3]);
  const pxPerCm = chance.between(500, 1000) / Math.max(Math.hypot(...right), Math.hypot(...up));
  const width = Math.round(Math.hypot(...right) * pxPerCm);
  const height = Math.round(Math.hypot(...up) * pxPerCm);
  const view = viewOf(sides, width, height, [chance.next(), chance.next()]);
  const exact = painted(print, view, width, height);
  const pixels = chance.happens(0.3) ? await throughJpeg(exact, 92) : exact;
  const made = printCase(
    {name, level: 'tile', kind, seed, f35: null},
    {pixels, view},
    print,
    print.broken,
  );
  return {...made, truth: {...made.truth, right, up}};
}

/** A tile without a strip at its right, so that its edges do not meet. */
export async function cutTileCase(
  name: string,
  group: GroupName,
  seed: number,
): Promise<PhotoCase> {
  const {truth, pixels} = await tileCase(name, group, 0, seed);
  const width = pixels.width - Math.round(pixels.width * new Chance(seed + 1).between(0.03, 0.2));
  return {
    truth: {
      name,
      level: 'tile',
      kind: 'cut',
      seed: truth.seed,
      width,
      height: pixels.height,
      f35: null,
      group: null,
      homography: null,
    },
    pixels: cropped(pixels, 0, 0, width, pixels.height),
    cell: undefined,
  };
}
