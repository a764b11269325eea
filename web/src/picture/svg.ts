/** Small helpers for writing SVG text. */
import type {Point} from '../model/geometry.js';

export const escaped = (text: string): string =>
  text.replace(/[&<>"']/g, (c) => `&#${c.codePointAt(0) ?? 0};`);

export const short = (value: number): string => String(Number(value.toFixed(2)) + 0);

/** "M x y L x y ..." */
export const polyline = (points: readonly Point[]): string =>
  points.map(([x, y], k) => `${k === 0 ? 'M' : 'L'}${short(x)} ${short(y)}`).join('');

export interface TextStyle {
  readonly size: number;
  readonly fill?: string;
  readonly weight?: number;
  readonly anchor?: 'start' | 'middle' | 'end';
}

export function text([x, y]: Point, content: string, style: TextStyle): string {
  const {size, fill = '#33363b', weight = 400, anchor = 'start'} = style;
  return `<text x="${short(x)}" y="${short(y)}" font-size="${size}" font-weight="${weight}" fill="${fill}" text-anchor="${anchor}">${escaped(content)}</text>`;
}

/** A picture as something `href` can name: SVG text becomes a data URL, anything else stays. */
export const imageHref = (image: string): string =>
  image.trimStart().startsWith('<') ? `data:image/svg+xml,${encodeURIComponent(image)}` : image;
