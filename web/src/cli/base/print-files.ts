import {dirname, extname, isAbsolute, join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

import {colourwayOf, type Print} from '../../model/print/repeating-print.js';
import {FileError} from '../../model/base/versioned-file.js';
import {addressFrom, readAddress, type ReadingLimits} from '../../node/addresses.js';
import {readBytes, textOf} from '../../node/files.js';
import {UsageError} from './arguments.js';

/** Image types that every browser supports, by file extension. */
export const imageTypes: Readonly<Record<string, string>> = {
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.jpeg': 'image/jpeg',
  '.webp': 'image/webp',
  '.gif': 'image/gif',
  '.avif': 'image/avif',
};

const isOnWeb = (image: string): boolean => /^https?:/i.test(image);

/**
 * The bytes of a print file. Detects the common mistake of naming the image beside it.
 * @throws {UsageError} for an image file
 */
export async function readPrint(path: string): Promise<Uint8Array> {
  if (extname(path).toLowerCase() in imageTypes) {
    throw new UsageError(`${path} is a picture; name the print file, JSON with group, w1 and w2.`);
  }
  return readBytes(path);
}

/**
 * The print in one of its colourways.
 * @throws {UsageError} with the known colourways
 */
export function inColourway(print: Print, name: string, path: string): Print {
  const {colourways = []} = print;
  const found = colourwayOf(print, name);
  if (found) return {...print, image: found.image};
  const known = colourways.map((one) => one.name).join(', ');
  throw new UsageError(
    known === ''
      ? `${path} has no colourways; leave out --colourway.`
      : `${path} has no colourway '${name}'; there are ${known}.`,
  );
}

/**
 * The print's image for drawing: SVG text, or a data URL.
 * @throws {UsageError} for an unsupported format
 */
export async function readTile(print: Print, printFile: string): Promise<string | undefined> {
  const {image} = print;
  if (image === undefined || image.startsWith('data:')) return image;
  if (isOnWeb(image)) return fetchTile(print, pathToFileURL(resolve(printFile)));
  const path = isAbsolute(image) ? image : join(dirname(printFile), image);
  return tileIn(path, path, readBytes);
}

/**
 * The image of a print at an address; the image's own address is relative to that.
 * @throws {UsageError} for an unsupported format
 */
export async function fetchTile(
  {image}: Print,
  print: URL,
  limits: ReadingLimits = {},
): Promise<string | undefined> {
  if (image === undefined || image.startsWith('data:')) return image;
  const address = addressFrom(print, image);
  return tileIn(address.pathname, image, () => readAddress(address, limits));
}

async function tileIn(
  path: string,
  called: string,
  read: (path: string) => Promise<Uint8Array>,
): Promise<string> {
  const extension = extname(path).toLowerCase();
  const type = imageTypes[extension];
  if (type === undefined) {
    throw new UsageError(
      `${called}, the print's image, is none of svg, png, jpg, webp, gif, avif; convert it.`,
    );
  }
  const bytes = await read(path);
  if (extension === '.svg') return textOf(bytes);
  return `data:${type};base64,${Buffer.from(bytes).toString('base64')}`;
}

/** The print's image as a data URL, as in a design; undefined if the file is missing. */
export async function readPicture(print: Print, printFile: string): Promise<string | undefined> {
  if (print.image === undefined || isOnWeb(print.image)) return undefined;
  try {
    const tile = await readTile(print, printFile);
    if (tile === undefined) return undefined;
    return tile.startsWith('data:') ? tile : `data:image/svg+xml,${encodeURIComponent(tile)}`;
  } catch (error) {
    // a solve needs no image
    if (error instanceof UsageError || error instanceof FileError) return undefined;
    throw error;
  }
}

/**
 * The raster of the colourway, for images that Node cannot render.
 * @throws {FileError} if it cannot be read
 */
export async function readRaster(
  {image, colourways = []}: Print,
  printFile: string,
): Promise<Uint8Array<ArrayBuffer> | undefined> {
  const raster = colourways.find((one) => one.image === image)?.raster;
  if (raster === undefined) return undefined;
  const bytes = await readAddress(addressFrom(pathToFileURL(resolve(printFile)), raster));
  return new Uint8Array(bytes);
}
