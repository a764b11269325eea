/** White balance from a white spot of a photo. */
import type {Point} from '../model/geometry/vectors.js';
import type {ColourGains} from '../model/print/photo-reading.js';
import {linearOf} from '../model/print/srgb.js';
import type {PhotoSize} from './lattice-lines.js';

/** Width of the spot, as a share of the image's longer side. */
const spot = 0.008;
/** Pixels of the spot per side. */
const grid = 8;
/** Shares of red, green and blue light in brightness (ITU-R BT.709). */
const brightness = [0.2126, 0.7152, 0.0722] as const;
/** Greatest gain: no lamp is more coloured than that. */
const mostGain = 3;

/** Returns gains that make the light of these pixels grey without a change in brightness. */
export function gainsFor(pixels: ArrayLike<number>): ColourGains {
  const light = brightness.map((_, channel) => {
    let sum = 0;
    for (let k = channel; k < pixels.length; k += 4) sum += linearOf((pixels[k] ?? 0) / 255);
    return Math.max(1e-4, sum / (pixels.length / 4));
  });
  const grey = light.reduce((sum, one, k) => sum + one * (brightness[k] ?? 0), 0);
  const gain = (k: number): number =>
    Math.min(mostGain, Math.max(1 / mostGain, grey / (light[k] ?? grey)));
  return [gain(0), gain(1), gain(2)];
}

/** @param size size of the image in the pixels that the place is given in */
export async function gainsAt(
  picture: Blob,
  {width, height}: PhotoSize,
  [x, y]: Point,
): Promise<ColourGains> {
  const bitmap = await createImageBitmap(picture, {imageOrientation: 'from-image'});
  try {
    const context = new OffscreenCanvas(grid, grid).getContext('2d');
    if (!context) throw new Error('This browser draws no pictures.');
    const side = spot * Math.max(bitmap.width, bitmap.height);
    const [left, top] = [
      (x * bitmap.width) / width - side / 2,
      (y * bitmap.height) / height - side / 2,
    ];
    context.drawImage(bitmap, left, top, side, side, 0, 0, grid, grid);
    return gainsFor(context.getImageData(0, 0, grid, grid).data);
  } finally {
    bitmap.close();
  }
}
