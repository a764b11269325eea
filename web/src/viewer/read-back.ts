/**
 * Draws pictures off screen and reads them back without waiting for a busy graphics card; encodes
 * PNG files.
 */
import {WebGLRenderTarget, type WebGLRenderer} from 'three';

interface Size {
  readonly width: number;
  readonly height: number;
}

/**
 * Returns the pixels that `draw` draws; blocks until they are there.
 * @returns undefined if the context is lost
 */
export function readNow(
  renderer: WebGLRenderer,
  {width, height}: Size,
  draw: () => void,
): ImageData | undefined {
  const context = renderer.getContext();
  if (context.isContextLost()) return undefined;
  const pixels = new Uint8Array(4 * width * height);
  onto({renderer, width, height}, (target) => {
    draw();
    renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
  });
  return context.isContextLost() ? undefined : upright(pixels, width, height);
}

/**
 * Returns the pixels that `draw` draws.
 * @returns undefined if the context is lost or is lost meanwhile
 */
export async function readBack(
  renderer: WebGLRenderer,
  {width, height}: Size,
  draw: () => void,
): Promise<ImageData | undefined> {
  const context = renderer.getContext();
  if (context.isContextLost()) return undefined;
  const pixels = new Uint8Array(4 * width * height);
  const reading = onto({renderer, width, height}, (target) => {
    draw();
    return renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height, pixels);
  });
  try {
    await reading;
  } catch (error) {
    // three.js gives no reason when a context is lost before the pixels are there
    if (error !== undefined) throw error;
    return undefined;
  }
  return context.isContextLost() ? undefined : upright(pixels, width, height);
}

/** @throws {Error} if the browser cannot encode the picture */
export async function pngOf(canvas: HTMLCanvasElement): Promise<Blob> {
  const blob = await new Promise<Blob | null>((resolve) => {
    canvas.toBlob(resolve, 'image/png');
  });
  if (!blob) throw new Error('The picture cannot be written.');
  return blob;
}

/** Calls `act` with a temporary render target. */
function onto<T>(
  {renderer, width, height}: Size & {readonly renderer: WebGLRenderer},
  act: (target: WebGLRenderTarget) => T,
): T {
  const target = new WebGLRenderTarget(width, height, {depthBuffer: false});
  target.scissorTest = true;
  try {
    renderer.setRenderTarget(target);
    return act(target);
  } finally {
    renderer.setRenderTarget(null);
    target.dispose();
  }
}

/** Converts rows from the bottom up with premultiplied colours to an image for a 2D canvas. */
function upright(pixels: Uint8Array, width: number, height: number): ImageData {
  const image = new ImageData(width, height);
  for (let row = 0; row < height; row++) {
    const from = 4 * width * (height - 1 - row);
    image.data.set(pixels.subarray(from, from + 4 * width), 4 * width * row);
  }
  const {data} = image;
  for (let at = 0; at < data.length; at += 4) {
    const alpha = data[at + 3] ?? 0;
    if (alpha === 0 || alpha === 255) continue;
    for (let k = at; k < at + 3; k++) data[k] = ((data[k] ?? 0) * 255) / alpha;
  }
  return image;
}
