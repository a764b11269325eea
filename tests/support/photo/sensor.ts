/** Effects of a camera: blur, noise, sharpening. In linear light unless noted. */
import type {Chance} from './chance.js';
import type {LightPicture} from './pixels.js';

/** One pass of a symmetric kernel along rows or columns; edges are repeated. */
function filtered(
  plane: Float32Array,
  width: number,
  height: number,
  kernel: readonly number[],
  down: boolean,
): Float32Array {
  const out = new Float32Array(plane.length);
  const reach = kernel.length - 1;
  const step = down ? width : 1;
  const last = (down ? height : width) - 1;
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const k = y * width + x;
      const place = down ? y : x;
      const inside = place >= reach && place + reach <= last;
      let sum = (kernel[0] ?? 0) * (plane[k] ?? 0);
      for (let r = 1; r <= reach; r++) {
        const before = inside ? r : Math.min(r, place);
        const after = inside ? r : Math.min(r, last - place);
        sum +=
          (kernel[r] ?? 0) * ((plane[k - before * step] ?? 0) + (plane[k + after * step] ?? 0));
      }
      out[k] = sum;
    }
  }
  return out;
}

/** Half a Gaussian, from its middle outwards; the whole sums to one. */
function gaussian(sigma: number): readonly number[] {
  const half = Array.from({length: Math.ceil(2.5 * sigma) + 1}, (_, r) =>
    Math.exp((-r * r) / (2 * sigma * sigma)),
  );
  const total = half.reduce((sum, w, r) => sum + (r === 0 ? w : 2 * w), 0);
  return half.map((w) => w / total);
}

const mapped = (
  picture: LightPicture,
  of: (plane: Float32Array) => Float32Array,
): LightPicture => ({
  ...picture,
  planes: [of(picture.planes[0]), of(picture.planes[1]), of(picture.planes[2])],
});

/** @param sigma px */
export function defocused(picture: LightPicture, sigma: number): LightPicture {
  if (sigma < 0.2) return picture;
  const {width, height} = picture;
  const kernel = gaussian(sigma);
  return mapped(picture, (plane) =>
    filtered(filtered(plane, width, height, kernel, false), width, height, kernel, true),
  );
}

/** The mean along a short line. @param length  px @param angle  from +x towards +y, radians */
export function shaken(picture: LightPicture, length: number, angle: number): LightPicture {
  if (length < 0.5) return picture;
  const {width, height} = picture;
  const taps = 5;
  const moves = Array.from({length: taps}, (_, k) => {
    const s = length * ((k + 0.5) / taps - 0.5);
    return [s * Math.cos(angle), s * Math.sin(angle)] as const;
  });
  return mapped(picture, (plane) => {
    const out = new Float32Array(plane.length);
    for (const [dx, dy] of moves) {
      const i = Math.floor(dx);
      const j = Math.floor(dy);
      const s = dx - i;
      const t = dy - j;
      for (let y = 0; y < height; y++) {
        const y0 = Math.min(height - 1, Math.max(0, y + j)) * width;
        const y1 = Math.min(height - 1, Math.max(0, y + j + 1)) * width;
        for (let x = 0; x < width; x++) {
          const x0 = Math.min(width - 1, Math.max(0, x + i));
          const x1 = Math.min(width - 1, Math.max(0, x + i + 1));
          const k = y * width + x;
          out[k] =
            (out[k] ?? 0) +
            ((1 - t) * ((1 - s) * (plane[y0 + x0] ?? 0) + s * (plane[y0 + x1] ?? 0)) +
              t * ((1 - s) * (plane[y1 + x0] ?? 0) + s * (plane[y1 + x1] ?? 0))) /
              taps;
        }
      }
    }
    return out;
  });
}

/**
 * Number of precomputed normal variates; drawing each one separately takes longer than all else.
 */
const normals = 1 << 16;

/**
 * Shot noise: variance 1.4e-6 ISO x light, chosen so that ISO 3200 gives 3 % in the middle greys,
 * and read noise.
 */
export function noisy(picture: LightPicture, iso: number, chance: Chance): LightPicture {
  const table = Float32Array.from({length: normals}, () => chance.normal());
  const shot = 1.4e-6 * iso;
  const read = (2e-5 * iso) ** 2 * 0.1 + 1e-7;
  return mapped(picture, (plane) => {
    let state = Math.floor(chance.next() * 4294967296);
    return plane.map((value) => {
      state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
      return value + Math.sqrt(shot * Math.max(0, value) + read) * (table[state >>> 16] ?? 0);
    });
  });
}

/**
 * Unsharp mask. @param picture  gamma-coded @param amount  factor of the difference from its blur
 */
export function sharpened(picture: LightPicture, amount: number): LightPicture {
  if (amount <= 0) return picture;
  const soft = defocused(picture, 1.3);
  const of = (sharp: Float32Array, blurred: Float32Array): Float32Array =>
    sharp.map((value, k) => value + amount * (value - (blurred[k] ?? 0)));
  return {
    ...picture,
    planes: [
      of(picture.planes[0], soft.planes[0]),
      of(picture.planes[1], soft.planes[1]),
      of(picture.planes[2], soft.planes[2]),
    ],
  };
}
