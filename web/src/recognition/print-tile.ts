/** The picture of a print's cell, from wherever a design has it. */
import {blobOf} from './data-url.js';
import {loadTile, svgTile, type Tile} from './tile.js';

/** `data:` URLs are read here: a strict policy does not let a page fetch them. */
export async function tileOf(image: string, signal?: AbortSignal): Promise<Tile> {
  if (!image.startsWith('data:')) return loadTile(new URL(image, document.baseURI), signal);
  const blob = blobOf(image);
  if (blob.type.startsWith('image/svg')) return svgTile(await blob.text());
  return createImageBitmap(blob, {colorSpaceConversion: 'none'});
}
