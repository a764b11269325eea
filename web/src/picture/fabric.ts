/** A print as SVG patterns: its tile once, and one pattern per piece. */
import {norm, rotated, type Alignment, type Point} from '../model/geometry/vectors.js';
import type {Print} from '../model/print/repeating-print.js';
import {imageCell} from '../model/print/wallpaper.js';
import {escaped, short} from '../files/svg/written.js';
import {imageHref} from '../image/svg-picture.js';

/**
 * A print with the image of its cell: SVG text, or a URL. Without an image, only the cell is
 * outlined.
 */
export type PrintWithTile = Print & {readonly tile?: string};

/**
 * The tile as a pattern, which the patterns of all pieces refer to.
 * @param scale [px per cm]
 */
export function fabricTile(id: string, print: PrintWithTile, scale: number): string {
  const [w, h] = imageCell(print).map((side) => short(scale * norm(side)));
  const content = print.tile
    ? `<image href="${escaped(imageHref(print.tile))}" width="${w}" height="${h}" preserveAspectRatio="none"/>`
    : `<rect width="${w}" height="${h}" fill="#f1ede3" stroke="#c9c1ae" stroke-width="1"/>`;
  return `<pattern id="${id}" patternUnits="userSpaceOnUse" width="${w}" height="${h}">${content}</pattern>`;
}

/**
 * The print beneath one piece: p = R w + t, followed by the page transform. The image's y runs
 * down, opposite to the cell's second side.
 * @param tile id of the tile's pattern
 * @param page map from piece coordinates to the page, upright or upside down
 */
export function fabricUnder(
  id: string,
  tile: string,
  print: Print,
  {angle, translation}: Alignment,
  page: (p: Point) => Point,
): string {
  const [a, b] = imageCell(print);
  const upright = page([0, 1])[1] < page([0, 0])[1] ? 1 : -1;
  const along = (side: Point, sign: 1 | -1): Point => {
    const n = (upright * sign) / norm(side);
    const [x, y] = rotated([side[0] * n, side[1] * n], angle);
    return [x, -y];
  };
  const matrix = [...along(a, 1), ...along(b, -1)].map((v) => v.toFixed(6));
  return `<pattern id="${id}" href="#${tile}" patternTransform="matrix(${matrix.join(' ')} ${page(translation).map(short).join(' ')})"/>`;
}
