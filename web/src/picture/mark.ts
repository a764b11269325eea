/** Words across a whole sheet, which nobody can miss who is about to cut by it. */
import {escaped, short} from './svg.js';
import {textWidth} from '../layout/name-lines.js';

/** For an answer that is not, byte for byte, the one that was sold. */
export const notAsSold = 'NOT AS IT WAS SOLD';

/** From corner to corner, as large as they go, see-through. Lengths in the picture's units. */
export function markAcross(words: string, width: number, height: number): string {
  const size = (0.8 * Math.hypot(width, height)) / textWidth(words, 1);
  const angle = (-180 / Math.PI) * Math.atan2(height, width);
  return `<text class="mark" transform="translate(${short(width / 2)} ${short(height / 2)}) rotate(${short(angle)})" y="${short(size / 3)}" font-size="${short(size)}" font-weight="700" text-anchor="middle" fill="#c3271b" fill-opacity="0.55" stroke="#fff" stroke-opacity="0.8" stroke-width="${short(size / 40)}" paint-order="stroke">${escaped(words)}</text>`;
}
