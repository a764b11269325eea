/** Compares a print with its moved copies by their pixels, to find its symmetries. */
import {after, type PlaneMap} from '../../src/model/geometry/plane-map.js';
import {
  tiledFabric,
  type Cell,
  type TiledFabric,
  type Pixels,
} from '../../src/image/tile-fabric.js';
import {combined, cross, dot, type Point} from '../../src/model/geometry/vectors.js';
import {imageCell, latticeAround, printElements} from '../../src/model/print/wallpaper.js';
import {imageSize} from './tile.js';

/** The cell, each of its pixels the mean of 2 x 2 of the image's, softened `times` times. */
export const finerFabric = (cell: Cell, image: Pixels, times: number): TiledFabric =>
  tiledFabric(cell, image, [image.width / 2, image.height / 2], times);

/**
 * Mean absolute difference of two fabrics, the second moved right and up by whole pixels. [0, 255]
 * @param enough  a difference above it need not be exact
 */
export function difference(
  one: TiledFabric,
  other: TiledFabric,
  [right, up]: Point = [0, 0],
  enough = Infinity,
): number {
  const {width, height} = one;
  const most = enough * 3 * width * height;
  let sum = 0;
  for (let y = 0; y < height && sum < most; y++) {
    const row = ((y + up) % height) * width;
    for (let x = 0; x < width; x++) {
      const [k, l] = [3 * (y * width + x), 3 * (row + ((x - right + width) % width))];
      sum +=
        Math.abs((one.colours[k] ?? 0) - (other.colours[l] ?? 0)) +
        Math.abs((one.colours[k + 1] ?? 0) - (other.colours[l + 1] ?? 0)) +
        Math.abs((one.colours[k + 2] ?? 0) - (other.colours[l + 2] ?? 0));
    }
  }
  return sum / (3 * width * height);
}

/** The least difference over all shifts by whole pixels for which `counts` holds; shifts in cm. */
export function leastDifference(
  one: TiledFabric,
  other: TiledFabric,
  counts: (shift: Point) => boolean = () => true,
): number {
  const [a, b] = imageCell(one.cell);
  const {width, height} = one;
  let least = Infinity;
  for (let up = 0; up < height; up++) {
    for (let right = 0; right < width; right++) {
      const [s, t] = [right / width, up / height];
      if (!counts(combined([a, b], s, t))) continue;
      least = Math.min(least, difference(one, other, [right, up], least));
    }
  }
  return least;
}

/** Returns whether the linear parts are equal. */
const alike = (one: PlaneMap, other: PlaneMap): boolean =>
  Math.hypot(one.xx - other.xx, one.xy - other.xy, one.yx - other.yx, one.yy - other.yy) < 1e-6;

/**
 * All rotations and reflections that keep the lattice, by its lengths and angles. The basis must
 * consist of shortest vectors.
 */
function holohedry({w1, w2}: Cell): PlaneMap[] {
  const area = cross(w1, w2);
  const short = latticeAround([w1, w2], 1);
  const same = (x: number, y: number): boolean => Math.abs(x - y) < 1e-6;
  return short.flatMap((u) =>
    short
      .filter((v) => same(dot(u, u), dot(w1, w1)) && same(dot(v, v), dot(w2, w2)))
      .filter((v) => same(dot(u, v), dot(w1, w2)))
      .map((v) => ({
        xx: (u[0] * w2[1] - v[0] * w1[1]) / area,
        xy: (v[0] * w1[0] - u[0] * w2[0]) / area,
        yx: (u[1] * w2[1] - v[1] * w1[1]) / area,
        yy: (v[1] * w1[0] - u[1] * w2[0]) / area,
        shift: [0, 0],
      })),
  );
}

/**
 * The linear parts that keep the lattice but are not in the group, one for each coset of the
 * group's; the others differ from it only by a symmetry of the print.
 */
export function cosets(cell: Cell): PlaneMap[] {
  const own = printElements(cell);
  const found: PlaneMap[] = [];
  const covered = [...own];
  for (const map of holohedry(cell)) {
    if (covered.some((known) => alike(known, map))) continue;
    found.push(map);
    covered.push(...own.map((element) => after(map, element)));
  }
  return found;
}

/** The size of an image for a fabric of about this density, at twice its resolution. [px per cm] */
export function imageFor(cell: Cell, density: number): readonly [width: number, height: number] {
  const [width, height] = imageSize(cell);
  const even = (length: number): number => 2 * Math.max(4, Math.round(length * density));
  return [even(width), even(height)];
}
