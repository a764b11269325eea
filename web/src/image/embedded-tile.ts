/** Image of a print's cell for cutting sheets. */
import {dataUrlOf} from './data-url.js';
import {imageHref} from './svg-picture.js';
import {fetchPicture} from './tile.js';

/**
 * Returns an image as SVG text or a `data:` URL, to embed in a file.
 * @throws {Error} if it cannot be read
 */
export async function embeddedTile(image: string): Promise<string> {
  if (image.startsWith('data:')) return image;
  const blob = await fetchPicture(new URL(image, document.baseURI));
  return blob.type.startsWith('image/svg') ? blob.text() : dataUrlOf(blob);
}

/** Longest side of such a picture. [px] */
const mostPixels = 8192;

/**
 * Draws a tile as PNG of this width and height in pixels; undefined if the browser makes no image.
 */
export async function pixelsOfTile(
  tile: string,
  width: number,
  height: number,
): Promise<Uint8Array<ArrayBuffer> | undefined> {
  const image = new Image();
  image.src = imageHref(tile);
  await image.decode();
  const scale = Math.min(1, mostPixels / Math.max(width, height));
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [Math.ceil(width * scale), Math.ceil(height * scale)];
  canvas.getContext('2d')?.drawImage(image, 0, 0, canvas.width, canvas.height);
  const blob = await new Promise<Blob | null>((resolve) => {
    canvas.toBlob(resolve);
  });
  return blob ? new Uint8Array(await blob.arrayBuffer()) : undefined;
}
