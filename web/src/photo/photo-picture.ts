/** Image of a print's cell, from the tile made of its photo. */
import {norm} from '../model/geometry/vectors.js';
import type {PhotoPixels} from '../model/print/photo-reading.js';
import type {DesignPrint} from '../model/design/design.js';
import {latticeVectors} from '../model/print/repeat.js';
import {imageCell, latticeType} from '../model/print/wallpaper.js';

/** Longest side of a print's image. [px] */
const longest = 2048;

/**
 * Returns a canvas in main memory, since files are written from there; the graphics card would have
 * to return all of it.
 */
function contextOf(width: number, height: number): OffscreenCanvasRenderingContext2D {
  const context = new OffscreenCanvas(width, height).getContext('2d', {willReadFrequently: true});
  if (!context) throw new Error('This browser draws no pictures.');
  return context;
}

function canvasOf({width, height, data}: PhotoPixels): OffscreenCanvas {
  const context = contextOf(width, height);
  // uses a view of an unshared buffer: a copy of 2048 x 2048 pixels takes 7 ms
  const pixels =
    data.buffer instanceof ArrayBuffer
      ? new Uint8ClampedArray(data.buffer, data.byteOffset, data.byteLength)
      : Uint8ClampedArray.from(data);
  context.putImageData(new ImageData(pixels, width, height), 0, 0);
  return context.canvas;
}

/** Returns the image of the print's own cell, from a tile that shows the cell of w1 and w2. */
export function cellPicture(
  tile: PhotoPixels,
  {group, size, cell}: Pick<DesignPrint, 'group' | 'size' | 'cell'>,
): OffscreenCanvas {
  const [w1, w2] = latticeVectors(group, size);
  const [right, up] = imageCell({group, w1, w2, cell});
  const sides = [
    (norm(right) / norm(w1)) * tile.width,
    (norm(up) / norm(w2)) * tile.height,
  ] as const;
  const scale = Math.min(1, longest / Math.max(...sides));
  const [width, height] = [
    Math.max(1, Math.round(scale * sides[0])),
    Math.max(1, Math.round(scale * sides[1])),
  ];
  const pixels = canvasOf(tile);
  if (cell === 'primitive' && width === tile.width && height === tile.height) return pixels;
  const context = contextOf(width, height);
  context.imageSmoothingQuality = 'high';
  if (cell === 'primitive') {
    context.drawImage(pixels, 0, 0, width, height);
    return context.canvas;
  }
  const pattern = context.createPattern(pixels, 'repeat');
  if (!pattern) throw new Error('This browser draws no pictures.');
  // (u, v) = (s - t, s + t) for rhombic cells, (s - t, 2 t) for hexagonal ones; y points down in
  // images, u and v point up
  const isHexagonal = latticeType(group) === 'hexagonal';
  const [a, b] = isHexagonal ? [width, 0] : [width / 2, height / 2];
  pattern.setTransform(
    new DOMMatrix([
      ...[a / tile.width, b / tile.width],
      ...[-width / 2 / tile.height, height / 2 / tile.height],
      ...[width / 2, height / 2],
    ]),
  );
  context.fillStyle = pattern;
  context.fillRect(0, 0, width, height);
  return context.canvas;
}

export const pngOf = (canvas: OffscreenCanvas): Promise<Blob> =>
  canvas.convertToBlob({type: 'image/png'});
