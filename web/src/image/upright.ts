/** Rotates stored pixels upright. */
import type {PhotoPixels} from '../model/print/photo-reading.js';

/**
 * For each EXIF orientation: whether rows and columns are swapped, and which of them are reversed.
 */
const orders: Readonly<Record<number, readonly [boolean, boolean, boolean]>> = {
  2: [false, true, false],
  3: [false, true, true],
  4: [false, false, true],
  5: [true, false, false],
  6: [true, true, false],
  7: [true, true, true],
  8: [true, false, true],
};

/**
 * Rotates an image.
 * @param orientation EXIF orientation, 1 to 8; other values count as 1
 */
export function upright(pixels: PhotoPixels, orientation: number): PhotoPixels {
  const order = orders[orientation];
  if (!order) return pixels;
  const [isTransposed, isBackward, isUpsideDown] = order;
  const {width, height, data} = pixels;
  const [across, down] = isTransposed ? [height, width] : [width, height];
  const from = new Uint32Array(data.slice().buffer);
  const to = new Uint32Array(across * down);
  for (let y = 0; y < down; y++) {
    for (let x = 0; x < across; x++) {
      const [right, below] = [isBackward ? across - 1 - x : x, isUpsideDown ? down - 1 - y : y];
      to[y * across + x] = from[isTransposed ? right * width + below : below * width + right] ?? 0;
    }
  }
  return {width: across, height: down, data: new Uint8Array(to.buffer)};
}
