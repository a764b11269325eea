/** The repeat of a print as SVG in its true size. */
import {boxOf} from '../model/geometry/polyline.js';
import {combined, norm, type Point} from '../model/geometry/vectors.js';
import type {Rectangle} from '../model/print/rectangular-repeat.js';
import {imageCell} from '../model/print/wallpaper.js';
import {escaped, short} from '../files/svg/written.js';
import {imageHref} from '../image/svg-picture.js';
import {fabricTile, fabricUnder, type PrintWithTile} from './fabric.js';

/** User units per cm: millimetres. */
const scale = 10;

/** Returns whether the image of the cell is the upright rectangle itself. */
function isCell(print: PrintWithTile, {width, height}: Rectangle): boolean {
  const near = (p: Point, q: Point): boolean => norm([p[0] - q[0], p[1] - q[1]]) < 1e-4;
  const [across, up] = imageCell(print);
  return near(across, [width, 0]) && near(up, [0, height]);
}

/** Box around the cell of a print without a rectangular repeat. */
function boxOfCell(print: PrintWithTile): Rectangle {
  const sides = imageCell(print);
  const corners = [0, 1].flatMap((s) => [0, 1].map((t) => combined(sides, s, t)));
  const {low, high} = boxOf(corners);
  return {width: high[0] - low[0], height: high[1] - low[1]};
}

/**
 * One repeat with its width and height in millimetres.
 * @param rectangle as of `rectangularRepeat`; undefined for an area of the print with its cell as
 * SVG pattern, which does not tile
 */
export function repeatSvg(print: PrintWithTile, rectangle: Rectangle | undefined): string {
  const {width, height} = rectangle ?? boxOfCell(print);
  const [w, h] = [short(scale * width), short(scale * height)];
  const page = ([x, y]: Point): Point => [scale * x, scale * (height - y)];
  const content =
    rectangle && print.tile !== undefined && isCell(print, rectangle)
      ? [
          `<image href="${escaped(imageHref(print.tile))}" width="${w}" height="${h}" preserveAspectRatio="none"/>`,
        ]
      : [
          `<defs>${fabricTile('tile', print, scale)}${fabricUnder('print', 'tile', print, {angle: 0, translation: [0, 0]}, page)}</defs>`,
          `<rect width="${w}" height="${h}" fill="url(#print)"/>`,
        ];
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${w}mm" height="${h}mm" viewBox="0 0 ${w} ${h}">`,
    ...content,
    '</svg>\n',
  ].join('\n');
}
