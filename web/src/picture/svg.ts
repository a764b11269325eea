/** Small helpers for writing SVG text. */
import type {Point} from '../model/geometry.js';

/** What XML cannot hold, not even escaped: most control characters, halves of surrogate pairs, U+FFFE and U+FFFF. */
const unwritable = /[^\t\n\r\u{20}-\u{d7ff}\u{e000}-\u{fffd}\u{10000}-\u{10ffff}]/gu;

export const escaped = (text: string): string =>
  text.replace(unwritable, '\u{fffd}').replace(/[&<>"']/g, (c) => `&#${c.codePointAt(0) ?? 0};`);

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

/** About how wide a letter of a text is, in parts of its size. */
const letterWidth = 0.56;

export const textWidth = (content: string, size: number): number =>
  letterWidth * size * content.length;

/** A name as it is shown, in lines no wider than `room` where its words allow it. [px] */
export function nameLines(name: string, room: number, size: number): readonly string[] {
  const lines: string[] = [];
  for (const word of name.replaceAll('_', ' ').split(' ')) {
    const longer = [...lines.slice(-1), word].join(' ');
    if (lines.length > 0 && textWidth(longer, size) <= room) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

/** A picture as something `href` can name: SVG text becomes a data URL, anything else stays. */
export const imageHref = (image: string): string =>
  image.trimStart().startsWith('<') ? `data:image/svg+xml,${encodeURIComponent(image)}` : image;

/** Whether an SVG takes in pictures from elsewhere: as an image it may not, and shows the sign of a broken one instead. */
export function hasOutsidePictures(svg: string): boolean {
  // in the place of fonts from elsewhere, others are shown
  const text = svg
    .replaceAll(/<!--[^]*?-->/g, '')
    .replaceAll(/@font-face\s*\{[^}]*\}|@import[^;]*;/gi, '');
  const named =
    /<(?:\w+:)?(?:image|feImage|use)\b[^>]*?\s(?:\w+:)?href\s*=\s*(["'])\s*(?!#|data:|\1)/i;
  const painted = /url\(\s*(?:["']|&quot;)?(?!["'#\s]|&quot;|data:)/i;
  return named.test(text) || painted.test(text);
}
