/** A conspicuous watermark across a whole sheet, as a warning before cutting. */
import {escaped, short} from '../files/svg/written.js';
import {textWidth} from '../layout/name-lines.js';

/** Watermark of a result that differs from the sold one, byte for byte. */
export const notAsSold = 'NOT AS IT WAS SOLD';

/** Translucent text across the diagonal, as large as fits. Lengths in the image's units. */
export function markAcross(words: string, width: number, height: number): string {
  const size = (0.8 * Math.hypot(width, height)) / textWidth(words, 1);
  const angle = (-180 / Math.PI) * Math.atan2(height, width);
  return `<text class="mark" transform="translate(${short(width / 2)} ${short(height / 2)}) rotate(${short(angle)})" y="${short(size / 3)}" font-size="${short(size)}" font-weight="700" text-anchor="middle" fill="#c3271b" fill-opacity="0.55" stroke="#fff" stroke-opacity="0.8" stroke-width="${short(size / 40)}" paint-order="stroke">${escaped(words)}</text>`;
}
