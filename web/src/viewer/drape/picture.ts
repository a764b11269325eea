/** Saves a drape as a picture. */
import type {WebGLRenderer} from 'three';

import {pngOf, readBack, readNow} from '../read-back.js';
import type {Raster} from '../stage.js';

/** Greatest side of a picture; four samples per pixel take 32 bytes. [px] */
const greatestSide = 4096;

export interface Paper {
  readonly renderer: WebGLRenderer;
  readonly raster: Raster;
  /** Background in sRGB, from 0 to 255. */
  readonly ground: readonly [number, number, number];
  readonly draw: () => void;
  /** Called afterwards: the page has to be drawn again. */
  readonly done: () => void;
  readonly isReady: boolean;
}

export const garmentPicture = {
  /** Greatest width of a picture. [px] */
  widest({capabilities}: WebGLRenderer, aspect: number): number {
    const most = Math.min(greatestSide, capabilities.maxTextureSize);
    return Math.floor(most * Math.min(1, aspect));
  },

  /**
   * Returns a PNG.
   * @throws {Error} if there is no garment, or the browser cannot make the picture
   */
  async blob(paper: Paper): Promise<Blob> {
    return pngOf(await garmentPicture.canvas(paper));
  },

  /** @throws {Error} if there is no garment, or no drawing context */
  async canvas(paper: Paper): Promise<HTMLCanvasElement> {
    if (!paper.isReady) throw new Error('There is no garment to draw yet.');
    const {renderer, raster, done} = paper;
    const pixels = await readBack(renderer, raster, paper.draw);
    done();
    const canvas = pixels && onCanvas(pixels, paper.ground);
    if (!canvas) throw new Error('The browser has taken the graphics context away.');
    return canvas;
  },

  /** Draws synchronously. @returns undefined if the browser cannot make the picture */
  now(paper: Paper): HTMLCanvasElement | undefined {
    const pixels = readNow(paper.renderer, paper.raster, paper.draw);
    paper.done();
    return pixels && onCanvas(pixels, paper.ground);
  },
};

/** Puts the picture on its background. */
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
