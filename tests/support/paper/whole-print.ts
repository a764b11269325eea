/**
 * Compares rendered pages with the print drawn as one picture, near the borders of its cells and
 * elsewhere.
 */
import {createCanvas} from '@napi-rs/canvas';

import type {LaidPiece} from '@/cutting/cut-sheet.js';
import type {Pixels} from '@/image/tile-fabric.js';
import {apply} from '@/model/geometry/plane-map.js';
import {cross, norm, onPiece, type Alignment, type Point} from '@/model/geometry/vectors.js';
import {imageCoordinates} from '@/model/print/image-coordinates.js';
import type {Print} from '@/model/print/repeating-print.js';
import {imageCell} from '@/model/print/wallpaper.js';

/** Width of the compared band along borders of cells. [cm] */
const nearCm = 0.1;
/** The number of other pixels of which one is compared. */
const others = 16;
/** Difference from all colours around a pixel that counts as wrong, from 0 to 255. */
const tolerance = 12;
/** Distance of compared pixels from outlines and other content. [pixels] */
const clear = 4;
/** Radius of the colours around a pixel, which renderers place differently. [pixels] */
const reachPixels = 1.5;
/** Steps in each direction around a pixel. */
const steps = 3;

interface Tally {
  pixels: number;
  wrong: number;
  /** Sum of differences, from 0 to 255. */
  off: number;
}

export interface Comparison {
  readonly near: Tally;
  readonly elsewhere: Tally;
  /** Positions on the page of wrong pixels near borders. [pixels] */
  readonly places: readonly Point[];
}

interface Compared {
  /** The rendered page with the print and without marks. */
  readonly page: Pixels;
  /** The same in plain green, which shows what else is drawn. */
  readonly plain: Pixels;
  readonly dpi: number;
  /** Lower left corner of the page on the sheet. [cm] */
  readonly low: Point;
  /** The part of the sheet that is drawn: lower left and upper right corner. [cm] */
  readonly window: readonly [Point, Point];
  readonly pieces: readonly LaidPiece[];
  readonly print: Print;
  /** The print's cell. */
  readonly tile: Pixels;
  /** The size of its pixels, at least that of the page's. [cm] */
  readonly grainCm: number;
}

/** For each pixel, the number of its piece, from 1; 0 near outlines. */
function pieceMask({page, low, dpi, pieces}: Compared): Uint8ClampedArray {
  const {width, height} = page;
  const context = createCanvas(width, height).getContext('2d');
  const scale = dpi / 2.54;
  pieces.forEach(({cut}, k) => {
    context.beginPath();
    for (const loop of cut) {
      for (const [x, y] of loop) {
        context.lineTo((x - low[0]) * scale, height - (y - low[1]) * scale);
      }
      context.closePath();
    }
    context.fillStyle = `rgb(${k + 1}, 0, 0)`;
    context.fill('evenodd');
    context.lineWidth = 2 * clear;
    context.strokeStyle = '#ff0000';
    context.stroke();
  });
  const {data} = context.getImageData(0, 0, width, height);
  return data.filter((_, k) => k % 4 === 0).map((value) => (value <= pieces.length ? value : 0));
}

/** Returns whether a pixel is as green as plain fabric. */
const isPlain = ([red = 0, green = 0, blue = 0]: Uint8ClampedArray): boolean =>
  red < 8 && green > 247 && blue < 8;

/** Pixels of pieces with other content near them. */
function covered({width, height, data}: Pixels, mask: Uint8ClampedArray): Uint8Array {
  const found = new Uint8Array(width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const at = y * width + x;
      if (!mask[at] || isPlain(data.subarray(4 * at, 4 * at + 3))) continue;
      for (let j = -clear; j <= clear; j++) {
        const row = Math.min(height - 1, Math.max(0, y + j)) * width;
        found.fill(1, row + Math.max(0, x - clear), row + Math.min(width, x + clear + 1));
      }
    }
  }
  return found;
}

const onSheet = ({place, alignment}: LaidPiece): Alignment => ({
  angle: place.angle + (alignment?.angle ?? 0),
  translation: onPiece(place, alignment?.translation ?? [0, 0]),
});

const share = (value: number): number => value - Math.floor(value);

/** Compares one page. */
export function comparedPage(compared: Compared): Comparison {
  const {page, plain, dpi, low, window, pieces, print, tile, grainCm} = compared;
  const {width, height, data} = page;
  const mask = pieceMask(compared);
  const taken = covered(plain, mask);
  const [a, b] = imageCell(print);
  const area = Math.abs(cross(a, b));
  const maps = pieces.map((piece) => imageCoordinates(print, onSheet(piece), low));
  const near: Tally = {pixels: 0, wrong: 0, off: 0};
  const elsewhere: Tally = {pixels: 0, wrong: 0, off: 0};
  const places: Point[] = [];
  const pixelCm = 2.54 / dpi;
  const [from, to] = window;
  const edge = clear * pixelCm;
  const isShown = ([x, y]: Point): boolean =>
    x > from[0] + edge && y > from[1] + edge && x < to[0] - edge && y < to[1] - edge;
  const reach = Math.max(reachPixels * pixelCm, grainCm) / steps;
  const offsets = Array.from({length: 2 * steps + 1}, (_, k) => (k - steps) * reach);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const at = y * width + x;
      const map = maps[(mask[at] ?? 0) - 1];
      if (!map || taken[at]) continue;
      const p: Point = [low[0] + (x + 0.5) * pixelCm, low[1] + (height - y - 0.5) * pixelCm];
      if (!isShown(p)) continue;
      const [u, v] = apply(map, p);
      const border = Math.min(
        (Math.min(share(u), 1 - share(u)) * area) / norm(b),
        (Math.min(share(v), 1 - share(v)) * area) / norm(a),
      );
      const isNear = border < nearCm;
      if (!isNear && (7 * x + 13 * y) % others !== 0) continue;
      const least = [255, 255, 255];
      const most = [0, 0, 0];
      for (const dx of offsets) {
        for (const dy of offsets) {
          const [s, t] = apply(map, [p[0] + dx, p[1] + dy]);
          const column = Math.min(tile.width - 1, Math.floor(share(s) * tile.width));
          const row = Math.min(tile.height - 1, Math.floor((1 - share(t)) * tile.height));
          for (let c = 0; c < 3; c++) {
            const value = tile.data[4 * (row * tile.width + column) + c] ?? 0;
            if (value < (least[c] ?? 0)) least[c] = value;
            if (value > (most[c] ?? 0)) most[c] = value;
          }
        }
      }
      let off = 0;
      for (let c = 0; c < 3; c++) {
        const value = data[4 * at + c] ?? 0;
        off = Math.max(off, (least[c] ?? 0) - value, value - (most[c] ?? 0));
      }
      const tally = isNear ? near : elsewhere;
      tally.pixels++;
      tally.off += off;
      if (off <= tolerance) continue;
      tally.wrong++;
      if (isNear) places.push([x, y]);
    }
  }
  return {near, elsewhere, places};
}
