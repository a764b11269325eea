/** Symmetries of a cell, measured from its samples alone. */
import type {Point} from '@/model/geometry/vectors.js';

import type {Cell} from './drawn-print.js';
import {transform, type Spectrum} from './fourier.js';
import {toGamma} from './inks.js';

type Matrix = readonly [number, number, number, number];

/** Frequencies above this many waves a cell are left out: no photo shows them sharply. */
const finest = 24;
const coarse = 128;

/**
 * Integer matrices, except the identity, that keep the lengths and the angle of w1, w2 within
 * `tolerance`.
 */
export function nearSymmetries(w1: Point, w2: Point, tolerance: number): readonly Matrix[] {
  const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1];
  const found: Matrix[] = [];
  const steps = [-1, 0, 1];
  for (const a of steps) {
    for (const b of steps) {
      for (const c of steps) {
        for (const d of steps) {
          if (Math.abs(a * d - b * c) !== 1 || (a === 1 && d === 1 && b === 0 && c === 0)) continue;
          const e1: Point = [a * w1[0] + c * w2[0], a * w1[1] + c * w2[1]];
          const e2: Point = [b * w1[0] + d * w2[0], b * w1[1] + d * w2[1]];
          const off = Math.max(
            Math.abs(dot(e1, e1) / dot(w1, w1) - 1) / 2,
            Math.abs(dot(e2, e2) / dot(w2, w2) - 1) / 2,
            Math.abs(dot(e1, e2) - dot(w1, w2)) / Math.sqrt(dot(w1, w1) * dot(w2, w2)),
          );
          if (off <= tolerance) found.push([a, b, c, d]);
        }
      }
    }
  }
  return found;
}

/**
 * The cell's waves per colour channel: brightness, red against blue, green against both; no mean.
 */
function wavesOf({n, planes}: Cell): readonly Spectrum[] {
  const step = n / coarse;
  const channels = [0, 1, 2].map(() => new Float64Array(coarse * coarse));
  for (let j = 0; j < coarse; j++) {
    for (let i = 0; i < coarse; i++) {
      const [r = 0, g = 0, b = 0] = planes.map((plane) =>
        toGamma(plane[j * step * n + i * step] ?? 0),
      );
      [(r + g + b) / 3, 0.7 * (r - b), 0.7 * (g - (r + b) / 2)].forEach((value, c) => {
        const channel = channels[c];
        if (channel) channel[j * coarse + i] = value;
      });
    }
  }
  return channels.map((re) => {
    const spectrum = {n: coarse, re, im: new Float64Array(coarse * coarse)};
    transform(spectrum, -1);
    return spectrum;
  });
}

const at = (kx: number, ky: number): number => (ky & (coarse - 1)) * coarse + (kx & (coarse - 1));

/** Shares of a cell's energy that break a matrix, at each of 128 x 128 shifts. */
export class SymmetryShares {
  private readonly waves: readonly Spectrum[];
  private readonly used: readonly (readonly [number, number])[];
  /** Variance of the cell, all channels. */
  readonly energy: number;

  constructor(cell: Cell, w1: Point, w2: Point) {
    this.waves = wavesOf(cell);
    const area = w1[0] * w2[1] - w1[1] * w2[0];
    const used: [number, number][] = [];
    // frequencies k1 w1* + k2 w2* in a disc, which every symmetry of the lattice preserves
    for (let ky = -finest; ky <= finest; ky++) {
      for (let kx = -finest; kx <= finest; kx++) {
        const fx = kx * w2[1] - ky * w1[1];
        const fy = ky * w1[0] - kx * w2[0];
        const inside = fx * fx + fy * fy <= finest * finest * area;
        if (inside && (kx !== 0 || ky !== 0)) used.push([kx, ky]);
      }
    }
    this.used = used;
    this.energy = this.waves.reduce(
      (sum, {re, im}) =>
        used.reduce((part, [kx, ky]) => {
          const k = at(kx, ky);
          return part + ((re[k] ?? 0) ** 2 + (im[k] ?? 0) ** 2) / coarse ** 4;
        }, sum),
      0,
    );
  }

  /** rho(s) = 1 - <T(m u), T(u + s)> / <T, T> at s = (i, j) / 128. */
  broken([a, b, c, d]: Matrix): Float64Array {
    const product = {
      n: coarse,
      re: new Float64Array(coarse * coarse),
      im: new Float64Array(coarse * coarse),
    };
    for (const [kx, ky] of this.used) {
      const k = at(kx, ky);
      // the wave of T(m u) at m^T k is that of T at k
      const q = at(a * kx + c * ky, b * kx + d * ky);
      for (const {re, im} of this.waves) {
        const x = re[q] ?? 0;
        const y = im[q] ?? 0;
        product.re[q] = (product.re[q] ?? 0) + x * (re[k] ?? 0) + y * (im[k] ?? 0);
        product.im[q] = (product.im[q] ?? 0) + y * (re[k] ?? 0) - x * (im[k] ?? 0);
      }
    }
    transform(product, 1);
    return product.re.map((value) => 1 - value / coarse ** 4 / this.energy);
  }

  /** The least share that breaks the matrix with any shift. */
  least(m: Matrix): number {
    return this.broken(m).reduce((least, share) => Math.min(least, share), Infinity);
  }

  /** The least share that breaks a translation by a fraction of the cell, down to a sixth. */
  leastFraction(): number {
    const shares = this.broken([1, 0, 0, 1]);
    let least = Infinity;
    for (let parts = 2; parts <= 6; parts++) {
      for (let j = 0; j < parts; j++) {
        for (let i = 0; i < parts; i++) {
          if (i === 0 && j === 0) continue;
          const k = at(Math.round((i * coarse) / parts), Math.round((j * coarse) / parts));
          least = Math.min(least, shares[k] ?? Infinity);
        }
      }
    }
    return least;
  }

  /** The share that breaks an element on the cell's own origin. */
  ofElement(m: Matrix, shift: Point): number {
    // T(m u + a) = T(u) is equivalent to T(m u) = T(u - m^-1 a'); T(u + s) is read at the shift -a
    const shares = this.broken(m);
    const [a, b, c, d] = m;
    const det = a * d - b * c;
    const s = [(d * shift[0] - b * shift[1]) / det, (a * shift[1] - c * shift[0]) / det];
    return shares[at(Math.round(-(s[0] ?? 0) * coarse), Math.round(-(s[1] ?? 0) * coarse))] ?? 1;
  }
}
