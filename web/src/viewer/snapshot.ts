/** Saves the whole sheet as a picture. */
import {
  Color,
  LinearSRGBColorSpace,
  type OrthographicCamera,
  type Scene,
  type WebGLRenderer,
} from 'three';

import type {Point} from '../model/geometry/vectors.js';
import {boxOf} from '../model/geometry/polyline.js';
import type {LineMaterial} from './line-layer.js';
import {pngOf, readBack, readNow} from './read-back.js';
import {labelLines, labelSize, type PatternScene} from '../scene/scene.js';
import {look} from './screen.js';
import {fitted, toScreen, type SheetView} from '../scene/sheet-view.js';
import {inks, placed, type Appearance} from './strokes.js';
import type {TileTexture} from './tile-texture.js';

const leading = 1.25;
const greatestPictureSide = 8192;
/**
 * Least width of a view assumed for a picture; some views are narrower or have no size yet. [CSS
 * px]
 */
const leastRoom = 320;

/** A scene object, and what draws it. */
export interface Drawing {
  readonly renderer: WebGLRenderer;
  readonly object: Scene;
  readonly camera: OrthographicCamera;
  readonly line: LineMaterial;
  readonly tile: TileTexture;
}

interface Shot {
  readonly width: number;
  readonly height: number;
  readonly view: SheetView;
  /** Pixels of the picture per CSS px of the view. */
  readonly ratio: number;
}

/** Look of a sheet outside the page. */
interface Look {
  readonly appearance: Appearance;
  /** Background. Default: that of the page. */
  readonly paper?: readonly [number, number, number];
}

const white = [255, 255, 255] as const;

/** Returns the greatest width of a picture of a whole sheet. [px] */
export function widestPicture(renderer: WebGLRenderer, [width, height]: Point): number {
  const most = Math.min(greatestPictureSide, renderer.capabilities.maxTextureSize);
  return Math.floor(most * Math.min(1, width / height));
}

/**
 * Frames the whole sheet in a picture of `width` px; lines and names are as large as on a screen of
 * width `room`. [CSS px]
 */
export function framed(
  {renderer, tile, camera, line}: Drawing,
  {size}: PatternScene,
  width: number,
  room: number,
): Shot {
  const across = Math.max(room, leastRoom);
  const whole = {width: across, height: (across * size[1]) / size[0]};
  const view = fitted(size, whole);
  const ratio = Math.min(width, widestPicture(renderer, size)) / whole.width;
  const shot = {
    ...{view, ratio},
    width: Math.round(whole.width * ratio),
    height: Math.round(whole.height * ratio),
  };
  tile.sharpen(view.scale * ratio);
  look(camera, line, view, shot);
  return shot;
}

/** Returns a PNG. @throws {Error} if the browser cannot make the picture */
export async function snapshot(
  drawing: Drawing,
  scene: PatternScene,
  shot: Shot,
  appearance: Appearance,
): Promise<Blob> {
  const pixels = await readBack(drawing.renderer, shot, drawn(drawing, {appearance}));
  if (!pixels) throw new Error('The browser has taken the graphics context away.');
  const canvas = named(pixels, scene, shot, appearance);
  if (!canvas) throw new Error('The picture cannot be drawn.');
  return pngOf(canvas);
}

/** Returns a picture on white, synchronously; undefined if the browser cannot make it. */
export function sheetOnPaper(
  drawing: Drawing,
  scene: PatternScene,
  shot: Shot,
): HTMLCanvasElement | undefined {
  const appearance = 'light';
  const pixels = readNow(drawing.renderer, shot, drawn(drawing, {appearance, paper: white}));
  return pixels && named(pixels, scene, shot, appearance);
}

/** Draws the names over the picture. */
function named(
  pixels: ImageData,
  scene: PatternScene,
  shot: Shot,
  appearance: Appearance,
): HTMLCanvasElement | undefined {
  const canvas = document.createElement('canvas');
  canvas.width = shot.width;
  canvas.height = shot.height;
  // its pixels are read for a file, which would block until a graphics card returns them
  const context = canvas.getContext('2d', {willReadFrequently: true});
  if (!context) return undefined;
  context.putImageData(pixels, 0, 0);
  drawNames(context, scene, shot, appearance);
  return canvas;
}

function drawn(
  {renderer, object, camera}: Drawing,
  {appearance, paper = inks[appearance].paper}: Look,
): () => void {
  return () => {
    const [r, g, b] = paper;
    const [colour, alpha] = [renderer.getClearColor(new Color()), renderer.getClearAlpha()];
    renderer.setClearColor(new Color().setRGB(r / 255, g / 255, b / 255, LinearSRGBColorSpace), 1);
    renderer.clear();
    renderer.setClearColor(colour, alpha);
    renderer.render(object, camera);
  };
}

function drawNames(
  context: CanvasRenderingContext2D,
  {pieces}: PatternScene,
  {width, height, view, ratio}: Shot,
  appearance: Appearance,
): void {
  const size = {width: width / ratio, height: height / ratio};
  context.scale(ratio, ratio);
  context.font = `500 ${labelSize}px system-ui, sans-serif`;
  context.textAlign = 'center';
  context.textBaseline = 'top';
  context.fillStyle = `rgb(${inks[appearance].outline.join(' ')})`;
  for (const piece of pieces) {
    const {low, high} = boxOf(placed(piece, piece.outline));
    const [x, y] = toScreen(view, size, [(low[0] + high[0]) / 2, low[1]]);
    labelLines(piece.label).forEach((line, k) => {
      context.fillText(line, x, y + 7 + k * leading * labelSize);
    });
  }
}
