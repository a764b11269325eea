/** Compares a print's clean tile with the print's true cell. */
import type {Point} from '@/model/geometry/vectors.js';

import type {Rgba} from './pixels.js';
import {toGamma, toLinear} from './inks.js';

/** Resolution of the comparison; no photo of a case shows a repeat with more samples. */
const compared = 96;

const linear = Float64Array.from({length: 256}, (_, x) => toLinear(x / 255));

/**
 * Means over squares of a lattice, linear light, per colour. `place` maps lattice coordinates to
 * pixels, pixel (0, 0) at (0, 0).
 */
function sampled(
  {width, height, data}: Rgba,
  place: (u: number, v: number) => Point,
): readonly Float64Array[] {
  const fine = 4;
  const planes = [0, 1, 2].map(() => new Float64Array(compared * compared));
  const wrap = (x: number, n: number): number => ((x % n) + n) % n;
  for (let j = 0; j < compared * fine; j++) {
    for (let i = 0; i < compared * fine; i++) {
      const [x, y] = place((i + 0.5) / (compared * fine), (j + 0.5) / (compared * fine));
      const left = Math.floor(x);
      const top = Math.floor(y);
      const to = Math.floor(j / fine) * compared + Math.floor(i / fine);
      // bilinear: pixels are larger than the steps, or hardly smaller
      for (let part = 0; part < 4; part++) {
        const right = part & 1;
        const below = part >> 1;
        const share = (right ? x - left : 1 - x + left) * (below ? y - top : 1 - y + top);
        const from = 4 * (wrap(top + below, height) * width + wrap(left + right, width));
        planes.forEach((plane, c) => {
          const light = linear[data[from + c] ?? 0] ?? 0;
          plane[to] = (plane[to] ?? 0) + (share * light) / (fine * fine);
        });
      }
    }
  }
  return planes;
}

interface TileAnswer {
  readonly pixels: Rgba;
  /** Columns: the image's edges to the right and up, in the answer's w1, w2; row by row. */
  readonly sides: readonly [number, number, number, number];
  /** Columns: the answer's w1, w2 in the print's lattice coordinates, row by row. */
  readonly basis: readonly [number, number, number, number];
  /** The image's lower left corner, in the print's lattice coordinates. */
  readonly origin: Point;
}

/**
 * Peak signal over the root mean square difference of gamma-coded colours, after a gain per colour.
 * [dB]
 * @param cell  the case's NAME.cell.rgba: pixel (i, j) at (u, v) = (i / n, j / n)
 */
export function tilePsnr(cell: Rgba, {pixels, sides, basis, origin}: TileAnswer): number {
  const [a, b, c, d] = sides;
  const det = a * d - b * c;
  const [p, q, r, s] = basis;
  const n = cell.width;
  const real = sampled(cell, (u, v) => {
    const x = origin[0] + p * u + q * v;
    const y = origin[1] + r * u + s * v;
    return [x * n, y * n];
  });
  const found = sampled(pixels, (u, v) => [
    ((d * u - b * v) / det) * pixels.width - 0.5,
    (1 - (a * v - c * u) / det) * pixels.height - 0.5,
  ]);
  let sum = 0;
  real.forEach((plane, colour) => {
    const other = found[colour] ?? plane;
    let [both, own] = [0, 0];
    plane.forEach((x, k) => {
      both += x * (other[k] ?? 0);
      own += (other[k] ?? 0) ** 2;
    });
    const gain = own > 0 ? both / own : 1;
    plane.forEach((x, k) => {
      sum += (toGamma(x) - toGamma(Math.min(1, gain * (other[k] ?? 0)))) ** 2;
    });
  });
  return -10 * Math.log10(sum / (3 * compared * compared));
}

/**
 * The sides of a print file's image in its w1, w2 (`cell`), as in the specification of print files.
 */
export function sidesOf(cell: 'primitive' | 'rectangular', shape: string): TileAnswer['sides'] {
  if (cell === 'primitive') return [1, 0, 0, 1];
  if (shape === 'rhombic') return [1, -1, 1, 1];
  if (shape === 'hexagonal') return [1, -1, 0, 2];
  return [1, 0, 0, 1];
}
