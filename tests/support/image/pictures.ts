/** Images as files of any size, for tests. */
import {deflateSync} from 'node:zlib';

import {crc32} from '@/image/file-kind.js';
import type {Pixels} from '@/image/tile-fabric.js';

type Colour = readonly [number, number, number];
/** Colour at a place from the upper left corner. [px] */
export type Painting = (x: number, y: number) => Colour;

export const paper: Colour = [250, 246, 236];
export const ink: Colour = [40, 90, 120];
export const rose: Colour = [190, 70, 60];

export const within = (x: number, y: number, centreX: number, centreY: number, radius: number) =>
  Math.hypot(x - centreX, y - centreY) < radius;

export function painted(width: number, height: number, colour: Painting): Pixels {
  const data = new Uint8ClampedArray(4 * width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) data.set([...colour(x, y), 255], 4 * (y * width + x));
  }
  return {width, height, data};
}

function chunk(type: string, data: Buffer): Buffer {
  const length = Buffer.alloc(4);
  length.writeUInt32BE(data.length);
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  const sum = Buffer.alloc(4);
  sum.writeUInt32BE(crc32(body));
  return Buffer.concat([length, body, sum]);
}

/** @param dpi  resolution stored in the file, if given */
export function pngOf({width, height, data}: Pixels, dpi?: number): Buffer {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 6, 0, 0, 0], 8);
  const rows = Array.from({length: height}, (_, y) =>
    Buffer.from([0, ...data.subarray(4 * y * width, 4 * (y + 1) * width)]),
  );
  const perMetre = Buffer.alloc(9);
  perMetre.writeUInt32BE(Math.round((dpi ?? 0) / 0.0254), 0);
  perMetre.writeUInt32BE(Math.round((dpi ?? 0) / 0.0254), 4);
  perMetre[8] = 1;
  return Buffer.concat([
    Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'),
    chunk('IHDR', header),
    ...(dpi === undefined ? [] : [chunk('pHYs', perMetre)]),
    chunk('IDAT', deflateSync(Buffer.concat(rows))),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

/** A leaf and a berry without any symmetry, clear of all edges. */
export const leaf: Painting = (x, y) =>
  within(x, y, 100, 110, 50) && !within(x, y, 130, 130, 40)
    ? ink
    : within(x, y, 60, 40, 18)
      ? rose
      : paper;

/**
 * 220 x 200 px: a disc on the left edge continues at the right one, half the height further down.
 */
export const halfDrop: Painting = (x, y) =>
  within(x, y, 0, 60, 40) || within(x, y, 220, 160, 40)
    ? rose
    : within(x, y, 110, 100, 30) && x > y
      ? ink
      : paper;

/** 220 x 200 px: discs that the left and the upper edge cut, without a continuation. */
export const cut: Painting = (x, y) =>
  within(x, y, 0, 60, 45) || within(x, y, 90, 0, 35)
    ? rose
    : within(x, y, 130, 130, 40)
      ? ink
      : paper;

/**
 * A cell with a different colour at every place; neighbouring colours differ by at most 4, also
 * across edges.
 */
export const everywhere = {
  width: 420,
  height: 560,
  paint: (x: number, y: number): Colour => {
    const across = (2 * Math.PI * x) / everywhere.width;
    const down = (2 * Math.PI * y) / everywhere.height;
    const level = (value: number): number => Math.round(127.5 + 127 * value);
    return [level(Math.cos(across)), level(Math.sin(across)), level(Math.cos(down + across))];
  },
};
