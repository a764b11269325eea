/** The contact sheet: every print over three cells and more, with its cell and its symmetry elements. */
import type {Point} from '../src/model/geometry.js';
import {polyline, short, text} from '../src/picture/svg.js';
import type {Design} from './design.js';
import {drawElements, elementsWithin} from './elements.js';
import {palettes} from './palette.js';
import {indexedPng} from './png.js';
import {tilesOf} from './print-files.js';
import {rendered, type Pixels} from './raster.js';
import {imageSize, pixelGrid, type Cell} from './tile.js';

/** A square window onto a print. */
export interface Window {
  /** Upper left corner and side. [px] */
  readonly corner: Point;
  readonly side: number;
  /** The point of the print in its middle [cm], and the scale. [px/cm] */
  readonly middle: Point;
  readonly scale: number;
}

export const toPage =
  ({corner, side, middle, scale}: Window) =>
  ([x, y]: Point): Point => [
    corner[0] + side / 2 + scale * (x - middle[0]),
    corner[1] + side / 2 - scale * (y - middle[1]),
  ];

/** The corners of the cell of w1 and w2, counter-clockwise. */
export const cornersOf = ({w1, w2}: Cell): Point[] => [
  [0, 0],
  w1,
  [w1[0] + w2[0], w1[1] + w2[1]],
  w2,
];

const paper = '#fbf9f5';
export const inkColour = '#2b2d31';
const quiet = '#7c7a75';

/** A page with its title; everything on it is in pixels. */
export function page(
  size: Point,
  title: string,
  about: string,
  content: readonly string[],
): string {
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${size[0]}" height="${short(size[1])}" viewBox="0 0 ${size[0]} ${short(size[1])}" role="img" font-family="'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', sans-serif">`,
    `<title>${title}</title>`,
    `<rect width="100%" height="100%" fill="${paper}"/>`,
    text([margin, 62], title, {size: 28, weight: 300, fill: inkColour}),
    text([margin, 88], about, {size: 13, fill: quiet}),
    ...content,
    '</svg>\n',
  ].join('\n');
}

const margin = 40;
const headHeight = 116;
const pageWidth = 1240;

/** The corner of every place on a page of `columns`, whose places are as wide as they can be with `gap` between them. */
export function places(count: number, columns: number, gap: number, captionHeight: number) {
  const side = (pageWidth - 2 * margin - (columns - 1) * gap) / columns;
  const corners = Array.from({length: count}, (_, k): Point => [
    margin + (k % columns) * (side + gap),
    headHeight + Math.floor(k / columns) * (side + captionHeight),
  ]);
  const rows = Math.ceil(count / columns);
  const size: Point = [pageWidth, headHeight + rows * (side + captionHeight) + margin / 2];
  return {side, corners, size};
}

/** A window's pixels, from those of the tile: the mean of 2 x 2 points in every pixel. */
function seen(tile: Pixels, cell: Cell, {side, middle, scale}: Window, density: number): Pixels {
  const {pixel} = pixelGrid(cell, tile.width, tile.height);
  const size = Math.round(side * density);
  const data = new Uint8ClampedArray(4 * size * size).fill(255);
  const wrap = (value: number, length: number): number => ((value % length) + length) % length;
  const points = [1 / 4, 3 / 4].flatMap((s) => [1 / 4, 3 / 4].map((t): Point => [s, t]));
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const sum = [0, 0, 0];
      for (const [s, t] of points) {
        const [px, py] = pixel([
          middle[0] + ((x + s) / density - side / 2) / scale,
          middle[1] - ((y + t) / density - side / 2) / scale,
        ]);
        const row = wrap(Math.round(py), tile.height) * tile.width;
        const from = 4 * (row + wrap(Math.round(px), tile.width));
        for (let c = 0; c < 3; c++) sum[c] = (sum[c] ?? 0) + (tile.data[from + c] ?? 0) / 4;
      }
      data.set(sum, 4 * (y * size + x));
    }
  }
  return {width: size, height: size, data};
}

/** Pixels of the pictures on the sheet for each of its own. */
const pictureDensity = 2;

async function panel(design: Design, corner: Point, side: number): Promise<string> {
  const [l1, l2] = [Math.hypot(...design.cell.w1), Math.hypot(...design.cell.w2)];
  // a stripe is the same all along: on the sheet its cell is as long as it is wide
  const cell: Cell = l2 < 1 ? {...design.cell, w2: [0, l1]} : design.cell;
  const {w1, w2} = cell;
  const window: Window = {
    corner,
    side,
    middle: [(w1[0] + w2[0]) / 2, (w1[1] + w2[1]) / 2],
    scale: side / (3 * Math.max(l1, l2)),
  };
  const [tile] = tilesOf(design);
  if (!tile) return '';
  const [width, height] = imageSize(design.cell);
  const fine = 2 * pictureDensity * window.scale;
  const pixels = await rendered(tile.svg, Math.ceil(width * fine), Math.ceil(height * fine));
  const picture = indexedPng(
    seen(pixels, design.cell, window, pictureDensity),
    Object.values(palettes[tile.palette]),
  );
  const at = toPage(window);
  const outline = `${polyline(cornersOf(cell).map(at))}Z`;
  const repeat = l2 < 1 ? `${short(l1)} cm` : `${short(l1)} × ${short(l2)} cm`;
  const [x, y] = [corner[0], corner[1] + side];
  const dots = design.colourways.flatMap((name, k) =>
    [palettes[name].ground, palettes[name].leaf, palettes[name].bloom].map(
      (colour, n) =>
        `<circle cx="${short(x + 5.5 + k * 37 + n * 9)}" cy="${short(y + 51)}" r="5" fill="${colour}" stroke="${quiet}" stroke-width=".4"/>`,
    ),
  );
  return [
    `<g aria-label="${design.title}, ${cell.group}">`,
    `<image x="${short(x)}" y="${short(corner[1])}" width="${short(side)}" height="${short(side)}" href="data:image/png;base64,${picture.toString('base64')}"/>`,
    `<path d="${outline}" fill="#fff" fill-opacity=".12" stroke="#fff" stroke-opacity=".8" stroke-width="2.4"/>`,
    `<path d="${outline}" fill="none" stroke="${inkColour}" stroke-width=".6"/>`,
    drawElements(elementsWithin(cell, cornersOf(cell)), at, {
      line: inkColour,
      casing: '#fff',
      size: 3.6,
    }),
    text([x, y + 20], design.title, {size: 13, weight: 600, fill: inkColour}),
    text([x + side, y + 20], cell.group, {size: 13, fill: inkColour, anchor: 'end'}),
    text([x, y + 36], `${design.family}, ${repeat}`, {size: 11, fill: quiet}),
    ...dots,
    '</g>',
  ].join('');
}

export async function contactSheet(collection: readonly Design[]): Promise<string> {
  const {side, corners, size} = places(collection.length, 6, 20, 78);
  const panels = await Promise.all(
    collection.map((design, k) => panel(design, corners[k] ?? [0, 0], side)),
  );
  const about = `${collection.length} prints in three colourways each. Mirrors are solid lines, glides dashed; lens, triangle, square and hexagon: centres of turns by 180, 120, 90 and 60 degrees.`;
  return page(size, 'The prints', about, panels);
}
