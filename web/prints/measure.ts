/** Compares a print with itself moved, on its pixels: what is a symmetry, and what is none. */
import type {Point} from '../src/model/geometry.js';
import {apply, imageCell, printElements, type PlaneMap} from '../src/model/wallpaper.js';
import type {Pixels} from './raster.js';
import {imageSize, pixelGrid, type Cell} from './tile.js';

/** A print, known everywhere by one cell of it. */
export interface Cloth {
  readonly cell: Cell;
  readonly width: number;
  readonly height: number;
  /** Red, green and blue in [0, 255], row by row from the top. */
  readonly colours: Float32Array;
}

/**
 * The cell, each of its pixels the mean of 2 x 2 of the image's, and softened by the kernel 1 2 1 in both
 * directions across its borders, `times` times.
 */
export function clothOf(cell: Cell, image: Pixels, times: number): Cloth {
  const [width, height] = [image.width / 2, image.height / 2];
  let colours = new Float32Array(3 * width * height);
  for (let y = 0; y < image.height; y++) {
    for (let x = 0; x < image.width; x++) {
      const [from, to] = [4 * (y * image.width + x), 3 * ((y >> 1) * width + (x >> 1))];
      for (let c = 0; c < 3; c++)
        colours[to + c] = (colours[to + c] ?? 0) + (image.data[from + c] ?? 0) / 4;
    }
  }
  for (let time = 0; time < times; time++) {
    colours = softened(colours, width, height, 1, 0);
    colours = softened(colours, width, height, 0, 1);
  }
  return {cell, width, height, colours};
}

function softened(from: Float32Array, width: number, height: number, dx: 0 | 1, dy: 0 | 1) {
  const to = new Float32Array(from.length);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const index = (s: number): number =>
        3 * (((y + s * dy + height) % height) * width + ((x + s * dx + width) % width));
      const [before, here, after] = [index(-1), index(0), index(1)];
      for (let c = 0; c < 3; c++) {
        to[here + c] =
          ((from[before + c] ?? 0) + 2 * (from[here + c] ?? 0) + (from[after + c] ?? 0)) / 4;
      }
    }
  }
  return to;
}

/** The cloth as it is seen through a map: at x it has the colour that was at the image of x. */
export function seenThrough(cloth: Cloth, map: PlaneMap): Cloth {
  const {width, height, colours} = cloth;
  const {centre, pixel} = pixelGrid(cloth.cell, width, height);
  const seen = new Float32Array(colours.length);
  const wrap = (value: number, size: number): number => ((value % size) + size) % size;
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const [px, py] = pixel(apply(map, centre(x, y)));
      const [fx, fy] = [Math.floor(px + 1e-9), Math.floor(py + 1e-9)];
      const [s, t] = [px - fx, py - fy];
      const [left, right] = [wrap(fx, width), wrap(fx + 1, width)];
      const [above, below] = [wrap(fy, height) * width, wrap(fy + 1, height) * width];
      const [a, b] = [3 * (above + left), 3 * (above + right)];
      const [c, d] = [3 * (below + left), 3 * (below + right)];
      for (let ink = 0; ink < 3; ink++) {
        seen[3 * (y * width + x) + ink] =
          (1 - t) * ((1 - s) * (colours[a + ink] ?? 0) + s * (colours[b + ink] ?? 0)) +
          t * ((1 - s) * (colours[c + ink] ?? 0) + s * (colours[d + ink] ?? 0));
      }
    }
  }
  return {...cloth, colours: seen};
}

/**
 * Mean absolute difference of two cloths, the second moved right and up by whole pixels. [0, 255]
 * @param enough from here on the exact value does not matter
 */
export function difference(
  one: Cloth,
  other: Cloth,
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
  one: Cloth,
  other: Cloth,
  counts: (shift: Point) => boolean = () => true,
): number {
  const [a, b] = imageCell(one.cell);
  const {width, height} = one;
  let least = Infinity;
  for (let up = 0; up < height; up++) {
    for (let right = 0; right < width; right++) {
      const [s, t] = [right / width, up / height];
      if (!counts([s * a[0] + t * b[0], s * a[1] + t * b[1]])) continue;
      least = Math.min(least, difference(one, other, [right, up], least));
    }
  }
  return least;
}

/** Same linear part. */
const alike = (one: PlaneMap, other: PlaneMap): boolean =>
  Math.hypot(one.xx - other.xx, one.xy - other.xy, one.yx - other.yx, one.yy - other.yy) < 1e-6;

const times = (one: PlaneMap, other: PlaneMap): PlaneMap => ({
  xx: one.xx * other.xx + one.xy * other.yx,
  xy: one.xx * other.xy + one.xy * other.yy,
  yx: one.yx * other.xx + one.yy * other.yx,
  yy: one.yx * other.xy + one.yy * other.yy,
  shift: [0, 0],
});

/** All turns and reflections that keep the lattice, as its lengths and angles are. The basis must be of shortest vectors. */
function holohedry({w1, w2}: Cell): PlaneMap[] {
  const area = w1[0] * w2[1] - w1[1] * w2[0];
  const short = [-1, 0, 1].flatMap((i) =>
    [-1, 0, 1].map((j): Point => [i * w1[0] + j * w2[0], i * w1[1] + j * w2[1]]),
  );
  const same = (x: number, y: number): boolean => Math.abs(x - y) < 1e-6;
  const dot = (u: Point, v: Point): number => u[0] * v[0] + u[1] * v[1];
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
 * The linear parts that keep the lattice but are not in the group: one for each coset of the group's, since
 * the others differ from it by a symmetry of the print only.
 */
export function cosets(cell: Cell): PlaneMap[] {
  const own = printElements(cell);
  const found: PlaneMap[] = [];
  const covered = [...own];
  for (const map of holohedry(cell)) {
    if (covered.some((known) => alike(known, map))) continue;
    found.push(map);
    covered.push(...own.map((element) => times(map, element)));
  }
  return found;
}

/** The size of an image that makes a cloth of about this density, twice as fine as it. [px per cm] */
export function imageFor(cell: Cell, density: number): readonly [width: number, height: number] {
  const [width, height] = imageSize(cell);
  const even = (length: number): number => 2 * Math.max(4, Math.round(length * density));
  return [even(width), even(height)];
}
