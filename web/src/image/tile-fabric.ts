/** A print given by the pixels of one cell, and its images under maps of the plane. */
import {apply, type PlaneMap} from '../model/geometry/plane-map.js';
import {combined, coordinates, type Point} from '../model/geometry/vectors.js';
import {imageCell, type CellOf as Cell} from '../model/print/wallpaper.js';

export type {Cell};

export interface Pixels {
  readonly width: number;
  readonly height: number;
  /** Red, green, blue, alpha, row by row from the top. */
  readonly data: Uint8ClampedArray;
}

/** A periodic print, given by one cell. */
export interface TiledFabric {
  readonly cell: Cell;
  readonly width: number;
  readonly height: number;
  /** Red, green and blue in [0, 255], row by row from the top. */
  readonly colours: Float32Array;
}

/**
 * Maps between pixels and the print: the centres of pixels on the print [cm], and the pixel of a
 * point, also beyond the cell.
 */
export function pixelGrid(cell: Cell, width: number, height: number) {
  const [a, b] = imageCell(cell);
  const centre = (x: number, y: number): Point => {
    const [s, t] = [(x + 0.5) / width, 1 - (y + 0.5) / height];
    return combined([a, b], s, t);
  };
  const pixel = (p: Point): Point => {
    const [s, t] = coordinates([a, b], p);
    return [s * width - 0.5, (1 - t) * height - 0.5];
  };
  return {centre, pixel};
}

/**
 * For each of `from` cells, the index among `to` larger ones where it begins, and the share of it
 * there.
 */
function split(
  from: number,
  to: number,
): {readonly first: Int32Array; readonly part: Float32Array} {
  const first = Int32Array.from({length: from}, (_, k) => Math.floor((k * to) / from));
  const part = Float32Array.from(first, (place, k) => Math.min(1, ((place + 1) * from) / to - k));
  return {first, part};
}

/**
 * The cell resampled to `width` by `height` pixels, at most those of the image. Each pixel is the
 * mean of the covered area on white. The result is blurred `times` times by the kernel 1 2 1 in
 * both directions, periodically.
 */
export function tiledFabric(
  cell: Cell,
  image: Pixels,
  [width, height]: readonly [number, number],
  times: number,
): TiledFabric {
  let colours = new Float32Array(3 * width * height);
  const [columns, rows] = [split(image.width, width), split(image.height, height)];
  const mean = (width * height) / (image.width * image.height);
  const add = (at: number, weight: number, from: number): void => {
    const opaque = (weight * mean * (image.data[from + 3] ?? 0)) / 255;
    const white = 255 * (weight * mean - opaque);
    for (let ink = 0; ink < 3; ink++) {
      colours[at + ink] = (colours[at + ink] ?? 0) + opaque * (image.data[from + ink] ?? 0) + white;
    }
  };
  for (let y = 0; y < image.height; y++) {
    const [row, above] = [rows.first[y] ?? 0, rows.part[y] ?? 1];
    for (let x = 0; x < image.width; x++) {
      const [column, left] = [columns.first[x] ?? 0, columns.part[x] ?? 1];
      const [from, at] = [4 * (y * image.width + x), 3 * (row * width + column)];
      add(at, above * left, from);
      if (left < 1 && column + 1 < width) add(at + 3, above * (1 - left), from);
      if (above < 1 && row + 1 < height) {
        add(at + 3 * width, (1 - above) * left, from);
        if (left < 1 && column + 1 < width) add(at + 3 * width + 3, (1 - above) * (1 - left), from);
      }
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

/** The print through a map: the colour at x is that at the image of x. */
export function seenThrough(fabric: TiledFabric, map: PlaneMap): TiledFabric {
  const {width, height, colours} = fabric;
  const {centre, pixel} = pixelGrid(fabric.cell, width, height);
  const seen = new Float32Array(colours.length);
  const wrap = (value: number, size: number): number => ((value % size) + size) % size;
  // the map between pixels is affine, too
  const image = (x: number, y: number): Point => pixel(apply(map, centre(x, y)));
  const [[ox, oy], [ax, ay], [bx, by]] = [image(0, 0), image(1, 0), image(0, 1)];
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const px = ox + x * (ax - ox) + y * (bx - ox);
      const py = oy + x * (ay - oy) + y * (by - oy);
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
  return {...fabric, colours: seen};
}
