/**
 * The contact sheet: every print over three cells and more in its colourways, one cell with its
 * symmetry elements.
 */
import {pixelGrid} from '../../src/image/tile-fabric.js';
import {norm, plus, type Point} from '../../src/model/geometry/vectors.js';
import {boxOf} from '../../src/model/geometry/polyline.js';
import {escaped, polyline, short, text} from '../../src/files/svg/written.js';
import type {Design} from './design.js';
import {drawElements, elementsWithin} from './elements.js';
import {palettes, type PaletteName} from './palette.js';
import {indexedPng} from './png.js';
import {tilesOf} from './print-files.js';
import {rendered, type Pixels} from './raster.js';
import {isStripe, repeatName} from './repeat.js';
import {imageSize, type Cell} from './tile.js';

/** A window onto a print. */
export interface Window {
  /** Upper left corner, width and height. [px] */
  readonly corner: Point;
  readonly size: Point;
  /** The point of the print in the window's middle [cm], and the scale. [px/cm] */
  readonly middle: Point;
  readonly scale: number;
}

export const toPage =
  ({corner, size, middle, scale}: Window) =>
  ([x, y]: Point): Point => [
    corner[0] + size[0] / 2 + scale * (x - middle[0]),
    corner[1] + size[1] / 2 - scale * (y - middle[1]),
  ];

/** The corners of the cell of w1 and w2, counter-clockwise. */
export const cornersOf = ({w1, w2}: Cell): Point[] => [[0, 0], w1, plus(w1, w2), w2];

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

/**
 * The corners of all places on a page of `columns`. Their width is the largest with `gap` between
 * them, and `heightOf` returns their height.
 */
export function places(
  count: number,
  columns: number,
  gap: number,
  heightOf: (width: number) => number,
) {
  const width = (pageWidth - 2 * margin - (columns - 1) * gap) / columns;
  const height = heightOf(width);
  const corners = Array.from({length: count}, (_, k): Point => [
    margin + (k % columns) * (width + gap),
    headHeight + Math.floor(k / columns) * height,
  ]);
  const rows = Math.ceil(count / columns);
  const size: Point = [pageWidth, headHeight + rows * height + margin / 2];
  return {width, corners, size};
}

/** A window's pixels, from those of the tile: the mean of 2 x 2 points in every pixel. */
function seen(tile: Pixels, cell: Cell, window: Window): Pixels {
  const {size, middle, scale} = window;
  const {pixel} = pixelGrid(cell, tile.width, tile.height);
  const width = Math.round(size[0] * pictureDensity);
  const height = Math.round(size[1] * pictureDensity);
  const data = new Uint8ClampedArray(4 * width * height).fill(255);
  const wrap = (value: number, length: number): number => ((value % length) + length) % length;
  const points = [1 / 4, 3 / 4].flatMap((s) => [1 / 4, 3 / 4].map((t): Point => [s, t]));
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const sum = [0, 0, 0];
      for (const [s, t] of points) {
        const [px, py] = pixel([
          middle[0] + ((x + s) / pictureDensity - size[0] / 2) / scale,
          middle[1] - ((y + t) / pictureDensity - size[1] / 2) / scale,
        ]);
        const row = wrap(Math.round(py), tile.height) * tile.width;
        const from = 4 * (row + wrap(Math.round(px), tile.width));
        for (let c = 0; c < 3; c++) sum[c] = (sum[c] ?? 0) + (tile.data[from + c] ?? 0) / 4;
      }
      data.set(sum, 4 * (y * width + x));
    }
  }
  return {width, height, data};
}

/** Pixels of the images for each pixel of the sheet. */
const pictureDensity = 1.8;

/** One colourway of a print as an embedded image. */
async function picture(design: Design, palette: PaletteName, window: Window): Promise<string> {
  const tile = tilesOf(design).find((one) => one.palette === palette);
  if (!tile) throw new Error(`${design.id} does not come in ${palette}`);
  const fine = 2 * pictureDensity * window.scale;
  const [width, height] = imageSize(design.cell).map((cm) => Math.ceil(cm * fine));
  const pixels = await rendered(tile.svg, width ?? 1, height ?? 1);
  const png = indexedPng(seen(pixels, design.cell, window), Object.values(palettes[palette]));
  const {corner, size} = window;
  return `<image x="${short(corner[0])}" y="${short(corner[1])}" width="${short(size[0])}" height="${short(size[1])}" href="data:image/png;base64,${png.toString('base64')}"/>`;
}

/**
 * Gap between the images of a print, and distance of the marked cell from the border of the large
 * one. [px]
 */
const pictureGap = 8;
const inset = 11;

/**
 * The windows of the three colourways: a large square, and right of it two small ones above each
 * other, at the same scale.
 */
function windowsOf(cell: Cell, [left, top]: Point, side: number, width: number): Window[] {
  const [west, south] = boxOf(cornersOf(cell)).low;
  const scale = side / (3 * Math.max(norm(cell.w1), norm(cell.w2)));
  const small: Point = [width - side - pictureGap, (side - pictureGap) / 2];
  const frames: (readonly [Point, Point])[] = [
    [
      [left, top],
      [side, side],
    ],
    [[left + side + pictureGap, top], small],
    [[left + side + pictureGap, top + small[1] + pictureGap], small],
  ];
  return frames.map(([corner, size]) => ({
    corner,
    size,
    scale,
    middle: [west + (size[0] / 2 - inset) / scale, south + (size[1] / 2 - inset) / scale],
  }));
}

/** A bar with the length of 5 cm of the print, which ends at a point of the page. */
function scaleBar([x, y]: Point, scale: number): string {
  const [from, to] = [short(x - 5 * scale), short(x)];
  const ends = [from, to].map((end) => `M${end} ${short(y - 3)}v6`).join('');
  return [
    `<path d="M${from} ${short(y)}H${to}${ends}" fill="none" stroke="${inkColour}" stroke-width=".8"/>`,
    text([x - 5 * scale - 6, y + 4], '5 cm', {size: 11, fill: quiet, anchor: 'end'}),
  ].join('');
}

const captionHeight = 66;
const elementStyle = {line: inkColour, casing: '#fff', size: 2.7};
/** Share of the large image in a panel's width. */
const share = 0.735;

async function panel(design: Design, corner: Point, width: number): Promise<string> {
  // a stripe is constant along itself: its cell on the sheet is a square
  const cell: Cell = isStripe(design.cell)
    ? {...design.cell, w2: [0, design.cell.w1[0]]}
    : design.cell;
  const side = Math.round(share * width);
  const windows = windowsOf(cell, corner, side, width);
  const [large] = windows;
  if (!large) return '';
  const pictures = await Promise.all(
    windows.map((window, k) => picture(design, design.colourways[k] ?? 'linen', window)),
  );
  const at = toPage(large);
  const outline = `${polyline(cornersOf(cell).map(at))}Z`;
  const [x, y] = [corner[0], corner[1] + side];
  return [
    `<g aria-label="${design.title}, ${cell.group}">`,
    ...pictures,
    `<path d="${outline}" fill="none" stroke="#fff" stroke-opacity=".75" stroke-width="2"/>`,
    `<path d="${outline}" fill="none" stroke="${inkColour}" stroke-width=".6"/>`,
    drawElements(elementsWithin(cell, cornersOf(cell)), at, elementStyle),
    `<text x="${short(x)}" y="${short(y + 20)}" font-size="14" fill="${inkColour}"><tspan font-weight="600">${escaped(design.title)}</tspan><tspan dx="7" font-size="12" fill="${quiet}">${design.id}</tspan></text>`,
    text([x + width, y + 20], cell.group, {size: 14, fill: inkColour, anchor: 'end'}),
    text([x, y + 37], repeatName(design.cell), {size: 12, fill: quiet}),
    scaleBar([x + width, y + 33], large.scale),
    '</g>',
  ].join('');
}

export async function contactSheet(collection: readonly Design[]): Promise<string> {
  const heightOf = (width: number): number => Math.round(share * width) + captionHeight;
  const {width, corners, size} = places(collection.length, 4, 28, heightOf);
  const panels = await Promise.all(
    collection.map((design, k) => panel(design, corners[k] ?? [0, 0], width)),
  );
  const about = `${collection.length} prints in three colourways each. On one cell, mirrors are solid lines, glides dashed; lens, triangle, square and hexagon: turns by 180, 120, 90 and 60 degrees.`;
  return page(size, 'The prints', about, panels);
}
