/** White balance: factors of light for gamma-coded pixels. */
import type {ColourGains} from '../../model/print/photo-reading.js';
import {codedOf, linearOf} from '../../model/print/srgb.js';

/** Changes the pixels in place: red, green, blue, opacity. */
export function balance(pixels: Uint8Array | Uint8ClampedArray, gains: ColourGains): void {
  const tables = gains.map((gain) =>
    Uint8ClampedArray.from({length: 256}, (_, code) => 255 * codedOf(gain * linearOf(code / 255))),
  );
  tables.forEach((table, channel) => {
    for (let k = channel; k < pixels.length; k += 4) pixels[k] = table[pixels[k] ?? 0] ?? 0;
  });
}
