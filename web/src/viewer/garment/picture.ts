/** A worn garment as a picture to keep. */
import type {WebGLRenderer} from 'three';

import {pngOf, readBack, readNow} from '../read-back.js';
import type {Raster} from '../stage.js';

/** A picture with four samples a pixel takes 32 bytes for each. [px] */
const greatestSide = 4096;

export interface Paper {
  readonly renderer: WebGLRenderer;
  readonly raster: Raster;
  /** sRGB, from 0 to 255. */
  readonly ground: readonly [number, number, number];
  readonly draw: () => void;
  /** The page has to be drawn again. */
  readonly done: () => void;
  readonly isReady: boolean;
}

export const garmentPicture = {
  /** [px] */
  widest({capabilities}: WebGLRenderer, aspect: number): number {
    const most = Math.min(greatestSide, capabilities.maxTextureSize);
    return Math.floor(most * Math.min(1, aspect));
  },

  /** As a PNG. @throws {Error} where there is nothing to draw or the browser makes no picture */
  async blob(paper: Paper): Promise<Blob> {
    return pngOf(await garmentPicture.canvas(paper));
  },

  /** @throws {Error} where there is nothing to draw, or no context to draw with */
  async canvas(paper: Paper): Promise<HTMLCanvasElement> {
    if (!paper.isReady) throw new Error('There is no garment to draw yet.');
    const {renderer, raster, done} = paper;
    const pixels = await readBack(renderer, raster, paper.draw);
    done();
    const canvas = pixels && onCanvas(pixels, paper.ground);
    if (!canvas) throw new Error('The browser has taken the graphics context away.');
    return canvas;
  },

  /** At once. @returns nothing where the browser makes no picture */
  now(paper: Paper): HTMLCanvasElement | undefined {
    const pixels = readNow(paper.renderer, paper.raster, paper.draw);
    paper.done();
    return pixels && onCanvas(pixels, paper.ground);
  },
};

/** Laid on its ground. */
function onCanvas(pixels: ImageData, [r, g, b]: Paper['ground']): HTMLCanvasElement | undefined {
  const canvas = document.createElement('canvas');
  canvas.width = pixels.width;
  canvas.height = pixels.height;
  const context = canvas.getContext('2d');
  if (!context) return undefined;
  context.putImageData(pixels, 0, 0);
  context.globalCompositeOperation = 'destination-over';
  context.fillStyle = `rgb(${r} ${g} ${b})`;
  context.fillRect(0, 0, canvas.width, canvas.height);
  return canvas;
}
