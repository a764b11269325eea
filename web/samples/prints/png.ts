/**
 * Writes flat artwork as small PNG files: a palette of its colours and of their blends along edges.
 */
import {crc32, deflateSync} from 'node:zlib';

import type {Pixels} from './raster.js';

type Colour = readonly [red: number, green: number, blue: number];

/**
 * Steps of blends between two colours, at an edge through a pixel or a crossing of warp and weft.
 */
const blends = [1 / 4, 1 / 2, 3 / 4];

function colour(hex: string): Colour {
  const value = Number.parseInt(hex.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

/** The colours, and the blends of every two. */
function palette(hexes: readonly string[]): Colour[] {
  const flat = hexes.map(colour);
  const between = flat.flatMap((a, k) =>
    flat
      .slice(k + 1)
      .flatMap((b) =>
        blends.map((t): Colour => [
          Math.round(a[0] + (b[0] - a[0]) * t),
          Math.round(a[1] + (b[1] - a[1]) * t),
          Math.round(a[2] + (b[2] - a[2]) * t),
        ]),
      ),
  );
  return [...flat, ...between];
}

function chunk(type: string, data: Uint8Array): Buffer {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)];
  length.writeUInt32BE(data.length);
  sum.writeUInt32BE(crc32(body));
  return Buffer.concat([length, body, sum]);
}

/**
 * @param hexes  the colours of the artwork, as `#rrggbb`; 10 at most, so that with their blends
 * they fit a byte
 */
export function indexedPng({width, height, data}: Pixels, hexes: readonly string[]): Buffer {
  const colours = palette(hexes);
  const known = new Map<number, number>();
  const nearest = (r: number, g: number, b: number): number => {
    const key = (r << 16) | (g << 8) | b;
    const found = known.get(key);
    if (found !== undefined) return found;
    const distances = colours.map((c) => (c[0] - r) ** 2 + (c[1] - g) ** 2 + (c[2] - b) ** 2);
    const index = distances.indexOf(Math.min(...distances));
    known.set(key, index);
    return index;
  };
  // every row starts with its filter: none, since neighbouring indices are unrelated
  const rows = new Uint8Array(height * (width + 1));
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const p = 4 * (y * width + x);
      rows[y * (width + 1) + 1 + x] = nearest(data[p] ?? 0, data[p + 1] ?? 0, data[p + 2] ?? 0);
    }
  }
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 3, 0, 0, 0], 8); // 8 bits, indexed, deflate, filtered by row, not interlaced
  return Buffer.concat([
    Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'),
    chunk('IHDR', header),
    chunk('PLTE', Uint8Array.from(colours.flat())),
    chunk('IDAT', deflateSync(rows, {level: 9})),
    chunk('IEND', new Uint8Array()),
  ]);
}
