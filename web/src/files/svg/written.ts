/** Helpers for writing SVG text. */
import type {Point} from '../../model/geometry/vectors.js';

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

/** Namespaces of files that drawing programs open. */
export const drawingSpaces =
  'xmlns:xlink="http://www.w3.org/1999/xlink" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"';

/** Definitions with references that all drawing programs read; Inkscape 1.2 needs `xlink:href`. */
export const linked = (definitions: string): string =>
  definitions.replaceAll(' href="', ' xlink:href="');

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
