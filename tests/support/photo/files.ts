/** Images as files: raw, PNG, JPEG with a camera's metadata. */
import {createCanvas, loadImage} from '@napi-rs/canvas';

import type {Rgba} from './pixels.js';

function canvasOf({width, height, data}: Rgba) {
  const canvas = createCanvas(width, height);
  const context = canvas.getContext('2d');
  const image = context.createImageData(width, height);
  image.data.set(data);
  context.putImageData(image, 0, 0);
  return canvas;
}

/** @param quality 0 to 100 */
export const jpegOf = (pixels: Rgba, quality: number): Promise<Buffer> =>
  canvasOf(pixels).encode('jpeg', quality);

export const pngOf = (pixels: Rgba): Promise<Buffer> => canvasOf(pixels).encode('png');

export async function decoded(file: Buffer): Promise<Rgba> {
  const image = await loadImage(file);
  const canvas = createCanvas(image.width, image.height);
  const context = canvas.getContext('2d');
  context.drawImage(image, 0, 0);
  const {data} = context.getImageData(0, 0, image.width, image.height);
  return {width: image.width, height: image.height, data: new Uint8ClampedArray(data)};
}

/** The pixels after storage as a JPEG file. */
export const throughJpeg = async (pixels: Rgba, quality: number): Promise<Rgba> =>
  decoded(await jpegOf(pixels, quality));

/** int32 width, int32 height, little-endian, then the pixels. */
export function rawOf({width, height, data}: Rgba): Buffer {
  const head = Buffer.alloc(8);
  head.writeInt32LE(width, 0);
  head.writeInt32LE(height, 4);
  return Buffer.concat([head, Buffer.from(data.buffer, data.byteOffset, data.byteLength)]);
}

/** Reads the format of `rawOf`. */
export function fromRaw(bytes: Buffer): Rgba {
  const data = new Uint8ClampedArray(bytes.subarray(8));
  return {width: bytes.readInt32LE(0), height: bytes.readInt32LE(4), data};
}

export type Orientation = 1 | 2 | 3 | 4 | 5 | 6 | 7 | 8;

/**
 * The pixels in a camera's storage order for `orientation`: turned or mirrored, so that its tag
 * undoes it.
 */
export function stored({width, height, data}: Rgba, orientation: Orientation): Rgba {
  const swaps = orientation >= 5;
  const w = swaps ? height : width;
  const h = swaps ? width : height;
  const out = new Uint8ClampedArray(data.length);
  const from = new Uint32Array(data.buffer, data.byteOffset, width * height);
  const to = new Uint32Array(out.buffer);
  for (let y = 0; y < h; y++) {
    for (let x = 0; x < w; x++) {
      const [ux, uy] = upright(x, y, w, h, orientation);
      to[y * w + x] = from[uy * width + ux] ?? 0;
    }
  }
  return {width: w, height: h, data: out};
}

/** Upright position of a stored pixel (EXIF 2.3, tag 274: meaning of row 0 and column 0). */
function upright(x: number, y: number, w: number, h: number, o: Orientation): [number, number] {
  switch (o) {
    case 1:
      return [x, y];
    case 2:
      return [w - 1 - x, y];
    case 3:
      return [w - 1 - x, h - 1 - y];
    case 4:
      return [x, h - 1 - y];
    case 5:
      return [y, x];
    case 6:
      return [h - 1 - y, x];
    case 7:
      return [h - 1 - y, w - 1 - x];
    case 8:
      return [y, w - 1 - x];
  }
}

/**
 * A JPEG file with an APP1 segment of the orientation and, if given, the focal length for 35 mm
 * film.
 */
export function withExif(jpeg: Buffer, orientation: Orientation, f35?: number): Buffer {
  const entry = (tag: number, type: number, value: number): Buffer => {
    const bytes = Buffer.alloc(12);
    bytes.writeUInt16LE(tag, 0);
    bytes.writeUInt16LE(type, 2);
    bytes.writeUInt32LE(1, 4);
    if (type === 3) bytes.writeUInt16LE(value, 8);
    else bytes.writeUInt32LE(value, 8);
    return bytes;
  };
  const directory = (entries: readonly Buffer[]): Buffer => {
    const count = Buffer.alloc(2);
    count.writeUInt16LE(entries.length);
    return Buffer.concat([count, ...entries, Buffer.alloc(4)]);
  };
  const short = 3;
  const long = 4;
  // header of 8 bytes, a directory of two entries: 2 + 24 + 4
  const tiff = Buffer.concat([
    Buffer.from([0x49, 0x49, 42, 0, 8, 0, 0, 0]),
    directory([entry(0x0112, short, orientation), entry(0x8769, long, 38)]),
    directory(f35 === undefined ? [] : [entry(0xa405, short, f35)]),
  ]);
  const body = Buffer.concat([Buffer.from('Exif\0\0', 'latin1'), tiff]);
  const head = Buffer.from([0xff, 0xd8, 0xff, 0xe1, 0, 0]);
  head.writeUInt16BE(body.length + 2, 4);
  return Buffer.concat([head, body, jpeg.subarray(2)]);
}
