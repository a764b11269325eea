/** Loads the image of a print's cell from a design. */
import {blobOf} from './data-url.js';
import {loadTile, svgTile, type Tile} from './tile.js';

/**
 * Loads a tile. Decodes `data:` URLs here, since a strict content security policy forbids fetching
 * them.
 */
export async function tileOf(image: string, signal?: AbortSignal): Promise<Tile> {
  if (!image.startsWith('data:')) return loadTile(new URL(image, document.baseURI), signal);
  const blob = blobOf(image);
  if (blob.type.startsWith('image/svg')) return svgTile(await blob.text());
  return createImageBitmap(blob, {colorSpaceConversion: 'none'});
}
