/** Light reflected by fabric: the print through the view, with folds, weave and lamps. */
import type {Point} from '@/model/geometry/vectors.js';

import {inverse, repeatsAt, unlensedTable, type LatticeView} from './camera.js';
import {halved, type Cell, type Print} from './drawn-print.js';
import type {Creases} from './creases.js';
import {darkPicture, type LightPicture} from './pixels.js';

/** Writes red, green, blue of a point of the fabric to `out`; lattice coordinates. */
export type Sampler = (u: number, v: number, out: Float32Array) => void;

/** The coarsest cell whose samples are no larger than `size`, as a share of the repeat. */
function fitting(cell: Cell, size: number): {cell: Cell; late: number} {
  let level = cell;
  let late = 0;
  while (level.n > 8 && 2 / level.n <= size) {
    late += 0.5 / level.n;
    level = halved(level);
  }
  return {cell: level, late};
}

/** Bilinear interpolation between samples. @param size  of a pixel, as a share of the repeat */
export function samplerOf(full: Cell, size: number): Sampler {
  const {cell, late} = fitting(full, size);
  const {n, planes} = cell;
  const [red, green, blue] = planes;
  const mask = n - 1;
  return (u, v, out) => {
    const x = (u - late) * n;
    const y = (v - late) * n;
    const i = Math.floor(x);
    const j = Math.floor(y);
    const s = x - i;
    const t = y - j;
    const i0 = i & mask;
    const i1 = (i + 1) & mask;
    const j0 = (j & mask) * n;
    const j1 = ((j + 1) & mask) * n;
    const k00 = j0 + i0;
    const k10 = j0 + i1;
    const k01 = j1 + i0;
    const k11 = j1 + i1;
    const w00 = (1 - s) * (1 - t);
    const w10 = s * (1 - t);
    const w01 = (1 - s) * t;
    const w11 = s * t;
    out[0] =
      w00 * (red[k00] ?? 0) + w10 * (red[k10] ?? 0) + w01 * (red[k01] ?? 0) + w11 * (red[k11] ?? 0);
    out[1] =
      w00 * (green[k00] ?? 0) +
      w10 * (green[k10] ?? 0) +
      w01 * (green[k01] ?? 0) +
      w11 * (green[k11] ?? 0);
    out[2] =
      w00 * (blue[k00] ?? 0) +
      w10 * (blue[k10] ?? 0) +
      w01 * (blue[k01] ?? 0) +
      w11 * (blue[k11] ?? 0);
  };
}

/** A pixel's size as a share of the repeat, in the image's middle. */
export function pixelShare(view: LatticeView, width: number, height: number): number {
  const [a, b] = repeatsAt(view.homography, [width / 2, height / 2]);
  return 1 / Math.max(Math.hypot(...a), Math.hypot(...b));
}

/** Twill: threads run along a diagonal of w1 and its normal. */
interface Weave {
  /** Relative variation of the threads' brightness. */
  readonly strength: number;
  /** Waves per repeat, along u and v. */
  readonly waves: Point;
}

interface PictureLook {
  readonly creases: Creases | undefined;
  readonly weave: Weave | undefined;
  /** Light at a pixel, per colour. */
  readonly light: (x: number, y: number, out: Float32Array) => void;
}

/** The weave's contrast after averaging over a pixel. */
function seenWeave({strength, waves}: Weave, pixel: number): number {
  const perPixel = Math.hypot(...waves) * pixel;
  return perPixel < 0.5 ? strength * (1 - perPixel) : 0;
}

/** @param fabric  colour at lattice coordinates */
export function fabricPicture(
  fabric: Sampler,
  view: LatticeView,
  [width, height]: readonly [number, number],
  look: PictureLook,
): LightPicture {
  const picture = darkPicture(width, height);
  const [red, green, blue] = picture.planes;
  const [a, b, c, d, e, f, g, h, i] = inverse(view.homography);
  const factor = unlensedTable(view);
  const [cx, cy] = view.lensMiddle;
  const pixel = pixelShare(view, width, height);
  const weave = look.weave ? seenWeave(look.weave, pixel) : 0;
  const [wu, wv] = look.weave?.waves ?? [0, 0];
  const sample = new Float32Array(3);
  const light = new Float32Array(3);
  const moved = new Float64Array(2);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      let r0 = 0;
      let g0 = 0;
      let b0 = 0;
      look.creases?.at(x + 0.5, y + 0.5, moved);
      const dx = moved[0] ?? 0;
      const dy = moved[1] ?? 0;
      // four samples a pixel
      for (let part = 0; part < 4; part++) {
        const px = x + 0.25 + 0.5 * (part & 1) - cx;
        const py = y + 0.25 + 0.5 * (part >> 1) - cy;
        const scale = factor(px * px + py * py);
        const qx = cx + scale * px;
        const qy = cy + scale * py;
        const w = g * qx + h * qy + i;
        const u = (a * qx + b * qy + c) / w + dx;
        const v = (d * qx + e * qy + f) / w + dy;
        fabric(u, v, sample);
        const thread = weave > 0 ? 1 + weave * Math.sin(2 * Math.PI * (wu * u + wv * v)) : 1;
        r0 += thread * (sample[0] ?? 0);
        g0 += thread * (sample[1] ?? 0);
        b0 += thread * (sample[2] ?? 0);
      }
      look.light(x + 0.5, y + 0.5, light);
      const k = y * width + x;
      red[k] = 0.25 * r0 * (light[0] ?? 0);
      green[k] = 0.25 * g0 * (light[1] ?? 0);
      blue[k] = 0.25 * b0 * (light[2] ?? 0);
    }
  }
  return picture;
}

/** Sampler of a print's fabric. */
export const printSampler = (
  print: Print,
  view: LatticeView,
  width: number,
  height: number,
): Sampler => samplerOf(print.cell, pixelShare(view, width, height));
