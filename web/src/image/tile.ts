/** Loads the image of a print's cell, independently of drawing. */
import {trustedMarkup} from '../model/base/trusted.js';
import {imageHref} from './svg-picture.js';
import {blobOf} from './data-url.js';

/** One cell of a print: pixels, or an SVG image, which can be drawn at any size. */
export type Tile =
  ImageBitmap | HTMLCanvasElement | HTMLImageElement | {readonly vector: HTMLImageElement};

async function vectorTile(url: string): Promise<Tile> {
  const image = new Image();
  image.src = url;
  await image.decode();
  return {vector: image};
}

/**
 * The image file of a print.
 * @throws {Error} with one sentence; `TypeError` without network
 */
export async function fetchPicture(url: string | URL, signal?: AbortSignal): Promise<Blob> {
  const response = await fetch(url, signal ? {signal} : {});
  if (!response.ok) throw new Error(`The print's image ${String(url)} cannot be read; try again.`);
  return response.blob();
}

/** Loads a tile from a file. An SVG requires a width and a height. */
export async function loadTile(url: string | URL, signal?: AbortSignal): Promise<Tile> {
  const blob = await fetchPicture(url, signal);
  if (blob.type.startsWith('image/svg')) return vectorTile(String(url));
  return createImageBitmap(blob, {colorSpaceConversion: 'none'});
}

/**
 * A tile from SVG text of any size. The page's content security policy has to allow `data:` images.
 */
export async function svgTile(svg: string): Promise<Tile> {
  const document = new DOMParser().parseFromString(trustedMarkup(svg), 'image/svg+xml');
  const root = document.documentElement;
  const side = (name: string): number => Number.parseFloat(root.getAttribute(name) ?? '') || 100;
  if (!root.hasAttribute('viewBox')) {
    root.setAttribute('viewBox', `0 0 ${side('width')} ${side('height')}`);
  }
  root.setAttribute('width', '512');
  root.setAttribute('height', '512');
  root.setAttribute('preserveAspectRatio', 'none');
  return vectorTile(imageHref(new XMLSerializer().serializeToString(document)));
}

// Loads the image of a print's cell from a design.

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
