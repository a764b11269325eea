/** The picture of a print's cell, from wherever a design has it. */
import {loadTile, svgTile, type Tile} from './tile.js';

/** `data:` URLs are read here: a strict policy does not let a page fetch them. */
export async function tileOf(image: string, signal?: AbortSignal): Promise<Tile> {
  if (!image.startsWith('data:')) return loadTile(new URL(image, document.baseURI), signal);
  const blob = blobOf(image);
  if (blob.type.startsWith('image/svg')) return svgTile(await blob.text());
  return createImageBitmap(blob, {colorSpaceConversion: 'none'});
}

/** @throws {Error} for what is not well-formed */
export function blobOf(url: string): Blob {
  const comma = url.indexOf(',');
  const head = url.slice('data:'.length, comma);
  const body = url.slice(comma + 1);
  const [type = ''] = head.split(';');
  if (!head.endsWith(';base64')) return new Blob([decodeURIComponent(body)], {type});
  return new Blob([Uint8Array.from(atob(body), (letter) => letter.charCodeAt(0))], {type});
}
