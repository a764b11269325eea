/** Helpers for writing SVG text. */
import type {Point} from '../../model/geometry/vectors.js';
import {textWidth} from '../../layout/name-lines.js';

/**
 * Characters that XML cannot contain even as references: most control characters, surrogates,
 * U+FFFE and U+FFFF.
 */
const unwritable = /[^\t\n\r\u{20}-\u{d7ff}\u{e000}-\u{fffd}\u{10000}-\u{10ffff}]/gu;

export const escaped = (text: string): string =>
  text.replace(unwritable, '\u{fffd}').replace(/[&<>"']/g, (c) => `&#${c.codePointAt(0) ?? 0};`);

export const short = (value: number): string => String(Number(value.toFixed(2)) + 0);

/** Path data "M x y L x y ...". */
export const polyline = (points: readonly Point[]): string =>
  points.map(([x, y], k) => `${k === 0 ? 'M' : 'L'}${short(x)} ${short(y)}`).join('');

interface TextStyle {
  readonly size: number;
  readonly fill?: string;
  readonly weight?: number;
  readonly anchor?: 'start' | 'middle' | 'end';
}

export function text([x, y]: Point, content: string, style: TextStyle): string {
  const {size, fill = '#33363b', weight = 400, anchor = 'start'} = style;
  return `<text x="${short(x)}" y="${short(y)}" font-size="${size}" font-weight="${weight}" fill="${fill}" text-anchor="${anchor}">${escaped(content)}</text>`;
}

// A conspicuous watermark across a whole sheet, as a warning before cutting.

/** Watermark of a result that differs from the sold one, byte for byte. */
export const notAsSold = 'NOT AS IT WAS SOLD';

/** Translucent text across the diagonal, as large as fits. Lengths in the image's units. */
export function markAcross(words: string, width: number, height: number): string {
  const size = (0.8 * Math.hypot(width, height)) / textWidth(words, 1);
  const angle = (-180 / Math.PI) * Math.atan2(height, width);
  return `<text class="mark" transform="translate(${short(width / 2)} ${short(height / 2)}) rotate(${short(angle)})" y="${short(size / 3)}" font-size="${short(size)}" font-weight="700" text-anchor="middle" fill="#c3271b" fill-opacity="0.55" stroke="#fff" stroke-opacity="0.8" stroke-width="${short(size / 40)}" paint-order="stroke">${escaped(words)}</text>`;
}
