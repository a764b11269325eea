/** The rectangular repeat of a print in pixels. */
import {norm} from '../model/geometry/vectors.js';
import type {Rectangle} from '../model/print/rectangular-repeat.js';
import {imageCell, type CellOf} from '../model/print/wallpaper.js';
import {dpiOf} from './printed-size.js';
import {pixelGrid, type Pixels} from './tile-fabric.js';

/** Greatest number of pixels, which a page and Node can hold. */
export const mostPixels = 100e6;
/** Greatest number of samples per pixel in each direction. */
const mostSamples = 4;

const cmPerInch = dpiOf(1);

/** Sides of a rectangle in pixels. */
export const pixelsAt = ({width, height}: Rectangle, dpi: number): readonly [number, number] => [
  Math.max(1, Math.round((width / cmPerInch) * dpi)),
  Math.max(1, Math.round((height / cmPerInch) * dpi)),
];

/** Resolution of the image of a cell at the size of its print, the lesser of both directions. */
export function resolutionOf(cell: CellOf, image: Pick<Pixels, 'width' | 'height'>): number {
  const [across, up] = imageCell(cell);
  return dpiOf(Math.min(image.width / norm(across), image.height / norm(up)));
}

/**
 * Samples the print on an upright rectangle that tiles it, composited on white.
 * @param image the print's cell, as wide and high as `imageCell`
 * @param rectangle as of `rectangularRepeat`
 * @param sides of the picture [px]
 */
export function repeatPixels(
  cell: CellOf,
  image: Pixels,
  rectangle: Rectangle,
  [width, height]: readonly [number, number],
): Pixels {
  const {pixel} = pixelGrid(cell, image.width, image.height);
  // the map from picture to image is affine
  const at = (x: number, y: number) =>
    pixel([(x / width) * rectangle.width, (1 - y / height) * rectangle.height]);
  const [[ox, oy], [ax, ay], [bx, by]] = [at(0, 0), at(1, 0), at(0, 1)];
  const [acrossX, acrossY, downX, downY] = [ax - ox, ay - oy, bx - ox, by - oy];
  const density = Math.max(Math.hypot(acrossX, acrossY), Math.hypot(downX, downY));
  const samples = Math.min(mostSamples, Math.max(1, Math.ceil(density - 1e-6)));
  const sampled = sampler(image);
  const data = new Uint8ClampedArray(4 * width * height);
  const sum = new Float64Array(3);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      sum.fill(0);
      for (let k = 0; k < samples * samples; k++) {
        const across = x + ((k % samples) + 0.5) / samples;
        const down = y + (Math.floor(k / samples) + 0.5) / samples;
        sampled(ox + across * acrossX + down * downX, oy + across * acrossY + down * downY, sum);
      }
      const to = 4 * (y * width + x);
      for (let ink = 0; ink < 3; ink++) data[to + ink] = (sum[ink] ?? 0) / (samples * samples);
      data[to + 3] = 255;
    }
  }
  return {width, height, data};
}

/** Adds the colour of a periodic image on white between its pixels. */
function sampler({
  width,
  height,
  data,
}: Pixels): (px: number, py: number, sum: Float64Array) => void {
  const wrap = (value: number, size: number): number => ((value % size) + size) % size;
  return (px, py, sum) => {
    const [fx, fy] = [Math.floor(px + 1e-6), Math.floor(py + 1e-6)];
    const [s, t] = [Math.max(0, px - fx), Math.max(0, py - fy)];
    const [left, right] = [wrap(fx, width), wrap(fx + 1, width)];
    const [above, below] = [wrap(fy, height) * width, wrap(fy + 1, height) * width];
    const add = (weight: number, from: number): void => {
      if (weight === 0) return;
      const opaque = (weight * (data[4 * from + 3] ?? 0)) / 255;
      for (let ink = 0; ink < 3; ink++) {
        sum[ink] = (sum[ink] ?? 0) + opaque * (data[4 * from + ink] ?? 0) + 255 * (weight - opaque);
      }
    };
    add((1 - s) * (1 - t), above + left);
    add(s * (1 - t), above + right);
    add((1 - s) * t, below + left);
    add(s * t, below + right);
  };
}
