/**
 * The image of a print's cell as a texture: bitmaps unchanged, an SVG drawn at the density of the
 * screen.
 */
import {
  CanvasTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  RepeatWrapping,
  type WebGLRenderer,
} from 'three';

import type {Tile} from '../image/tile.js';
import {norm, type Point} from '../model/geometry/vectors.js';

/** Longest side of a texture. [px] */
const greatestSide = 4096;
/** Least density of an SVG; greater ones differ by powers of 2. [px per cm] */
const coarsest = 32;

/**
 * Draws a tile at a size in px on white, the colour of the fabric under transparent parts.
 * @returns undefined if the browser cannot draw
 */
export function onWhite(
  image: CanvasImageSource,
  width: number,
  height: number,
): HTMLCanvasElement | undefined {
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, Math.round(width));
  canvas.height = Math.max(1, Math.round(height));
  const context = canvas.getContext('2d', {alpha: false});
  if (!context) return undefined;
  context.fillStyle = '#fff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  return canvas;
}

export class TileTexture {
  readonly #anisotropy: number;
  readonly #limit: number;
  readonly #changed: (texture: CanvasTexture) => void;
  #texture: CanvasTexture | undefined;
  /** Source image of an SVG, and the sides of the cell. [cm] */
  #vector: {readonly image: HTMLImageElement; readonly sides: Point} | undefined;
  #density = coarsest;
  /** Last density of the screen, used for a new tile. [px per cm] */
  #asked = coarsest;

  /** @param changed receives each new texture; the previous one is disposed of by then */
  constructor(
    {capabilities}: Pick<WebGLRenderer, 'capabilities'>,
    changed: (texture: CanvasTexture) => void,
  ) {
    this.#anisotropy = capabilities.getMaxAnisotropy();
    this.#limit = Math.min(capabilities.maxTextureSize, greatestSide);
    this.#changed = changed;
  }

  /** @param cell sides of the cell that the tile shows [cm] */
  set(tile: Tile | undefined, cell: readonly [Point, Point]): void {
    const sides: Point = [norm(cell[0]), norm(cell[1])];
    this.#vector = tile && 'vector' in tile ? {image: tile.vector, sides} : undefined;
    this.#density = this.#asked;
    if (!tile) this.#drawBlank(sides);
    else if ('vector' in tile) this.#drawVector();
    else this.#draw(tile, tile.width, tile.height);
  }

  /**
   * Draws an SVG again when the screen shows more detail than the texture has. [device px per cm]
   */
  sharpen(density: number): void {
    this.#asked = Math.max(coarsest, 2 ** Math.ceil(Math.log2(density)));
    if (this.#asked <= this.#density) return;
    this.#density = this.#asked;
    if (this.#vector && this.#texture && this.#size(this.#vector.sides)[0] > this.#texture.width) {
      this.#drawVector();
    }
  }

  dispose(): void {
    this.#texture?.dispose();
  }

  #drawVector(): void {
    if (this.#vector) this.#draw(this.#vector.image, ...this.#size(this.#vector.sides));
  }

  /**
   * Returns the width and height for an SVG: divisible by 16, so that the first mipmap levels do
   * not shift the print.
   */
  #size(sides: Point): Point {
    const density = Math.min(this.#density, this.#limit / Math.max(...sides));
    const size = (side: number): number => Math.max(16, Math.floor((side * density) / 16) * 16);
    return [size(sides[0]), size(sides[1])];
  }

  /** Draws unprinted fabric with the edges of the cell, until there is an image. */
  #drawBlank([width, height]: Point): void {
    const canvas = document.createElement('canvas');
    canvas.width = Math.max(4, Math.round(width * coarsest));
    canvas.height = Math.max(4, Math.round(height * coarsest));
    const context = canvas.getContext('2d');
    if (context) {
      context.fillStyle = '#c9c1ae';
      context.fillRect(0, 0, canvas.width, canvas.height);
      context.fillStyle = '#f1ede3';
      context.fillRect(1, 1, canvas.width - 2, canvas.height - 2);
    }
    this.#draw(canvas, canvas.width, canvas.height);
  }

  #draw(image: CanvasImageSource, width: number, height: number): void {
    const shrink = Math.min(1, this.#limit / Math.max(width, height));
    const canvas = onWhite(image, width * shrink, height * shrink);
    if (!canvas) return;
    const texture = new CanvasTexture(canvas);
    texture.wrapS = RepeatWrapping;
    texture.wrapT = RepeatWrapping;
    texture.magFilter = LinearFilter;
    texture.minFilter = LinearMipmapLinearFilter;
    texture.anisotropy = this.#anisotropy;
    this.#texture?.dispose();
    this.#texture = texture;
    this.#changed(texture);
  }
}
