/** The image of a print's cell as pixels, from any source in a design. */
import {copiesIn} from '../model/design/tile-repeat.js';
import type {TileRepeat} from '../model/print/opened-image.js';
import type {Pixels} from '../image/tile-fabric.js';

/** Longest side of a compared image, and of a redrawn one. [px] */
const compared = 320;
const drawnAnew = 4096;
/** Longest side of a redrawn vector image. [px] */
const vectorDrawn = 1536;
/** Greatest size of a lossless image; larger ones keep their lossy compression. [px] */
const mostLossless = 6e6;

export async function loadPicture(url: string): Promise<HTMLImageElement> {
  const image = new Image();
  image.src = url;
  await image.decode();
  return image;
}

function canvasOf(width: number, height: number): CanvasRenderingContext2D {
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, Math.round(width));
  canvas.height = Math.max(1, Math.round(height));
  const context = canvas.getContext('2d');
  if (!context) throw new Error('This browser draws no pictures.');
  return context;
}

/** Returns a small copy of an image as pixels, in its own proportions. */
export function pixelsOf(image: HTMLImageElement, longest = compared): Pixels {
  const {naturalWidth, naturalHeight} = image;
  const scale = Math.min(1, longest / Math.max(naturalWidth, naturalHeight));
  const context = canvasOf(naturalWidth * scale, naturalHeight * scale);
  const {width, height} = context.canvas;
  context.drawImage(image, 0, 0, width, height);
  return context.getImageData(0, 0, width, height);
}

export const isVector = (url: string): boolean => /^data:image\/svg|\.svg$/.test(url);

/** Turns an image clockwise by 90 degrees. @returns a `data:` URL */
export async function quarterTurned(url: string): Promise<string> {
  const image = await loadPicture(url);
  const longest = Math.max(image.naturalWidth, image.naturalHeight);
  const scale = isVector(url) ? vectorDrawn / longest : Math.min(1, drawnAnew / longest);
  const [width, height] = [image.naturalWidth * scale, image.naturalHeight * scale];
  const context = canvasOf(height, width);
  context.translate(context.canvas.width, 0);
  context.rotate(Math.PI / 2);
  context.drawImage(image, 0, 0, width, height);
  return context.canvas.toDataURL(url.startsWith('data:image/jpeg') ? 'image/jpeg' : 'image/png');
}

/**
 * Returns even sides, so that half an image has whole pixels. They are the image's own wherever
 * those fit.
 */
function sidesFor(url: string, image: HTMLImageElement, repeat: TileRepeat): [number, number] {
  const [across, up] = copiesIn[repeat];
  const {naturalWidth: width, naturalHeight: height} = image;
  const room = drawnAnew / Math.max(across * width, up * height);
  const isOdd = width % 2 === 1 || height % 2 === 1;
  const scale = isVector(url) ? room : room < 1 ? room : isOdd && room >= 2 ? 2 : 1;
  const even = (side: number): number => Math.max(2, 2 * Math.floor((side * scale) / 2));
  return [even(width), even(height)];
}

/**
 * Returns one cell of an image with this repeat. Half-drop and brick have the middle of the image
 * at the corner of the cell, where the group's origin is; mirrored images have their own corner
 * there.
 * @returns a `data:` URL
 */
export async function arranged(url: string, repeat: TileRepeat): Promise<string> {
  if (repeat === 'straight') return url;
  const image = await loadPicture(url);
  const [width, height] = sidesFor(url, image, repeat);
  const [across, up] = copiesIn[repeat];
  const context = canvasOf(across * width, up * height);
  // keeps pixels as they are: only an image that is too large is reduced
  context.imageSmoothingEnabled = width < image.naturalWidth || isVector(url);
  const draw = (x: number, y: number, flipX: boolean, flipY: boolean): void => {
    context.setTransform(flipX ? -1 : 1, 0, 0, flipY ? -1 : 1, x + width / 2, y + height / 2);
    context.drawImage(image, -width / 2, -height / 2, width, height);
  };
  if (repeat === 'halfDrop' || repeat === 'brick') {
    for (let i = 0; i <= across; i++) {
      for (let j = 0; j <= up; j++) {
        const [asideX, asideY] = repeat === 'brick' ? [j % 2, 0] : [0, i % 2];
        draw((i + asideX / 2 - 0.5) * width, (j + asideY / 2 - 0.5) * height, false, false);
      }
    }
  } else {
    for (let i = 0; i < across; i++) {
      for (let j = 0; j < up; j++) {
        draw(i * width, (up - 1 - j) * height, i % 2 === 1, j % 2 === 1);
      }
    }
  }
  const {canvas} = context;
  const isLossy = url.startsWith('data:image/jpeg') && canvas.width * canvas.height > mostLossless;
  return isLossy ? canvas.toDataURL('image/jpeg', 0.95) : canvas.toDataURL('image/png');
}
