import {dirname, extname, isAbsolute, join} from 'node:path';

import {colourwayOf, type Print} from '../model/print.js';
import {UsageError} from './arguments.js';
import {readBytes, readText} from './files.js';

/** Kinds of image that every browser shows, by the file's extension. */
export const imageTypes: Readonly<Record<string, string>> = {
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.jpeg': 'image/jpeg',
  '.webp': 'image/webp',
  '.gif': 'image/gif',
  '.avif': 'image/avif',
};

/** The text of a print file. Its picture, which often lies beside it, is named by mistake. @throws {UsageError} */
export async function readPrint(path: string): Promise<string> {
  if (extname(path).toLowerCase() in imageTypes) {
    throw new UsageError(`${path} is a picture; name the print file, JSON with group, w1 and w2.`);
  }
  return readText(path);
}

/** The print in one of its colourways. @throws {UsageError} naming those there are */
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

/** The print's image as a picture takes it: SVG text, or a URL that holds all of its bytes. @throws {UsageError} */
export async function readTile({image}: Print, printFile: string): Promise<string | undefined> {
  if (image === undefined || /^(data|https?):/.test(image)) return image;
  const path = isAbsolute(image) ? image : join(dirname(printFile), image);
  const extension = extname(path).toLowerCase();
  if (extension === '.svg') return readText(path);
  const type = imageTypes[extension];
  if (type === undefined) {
    throw new UsageError(
      `${path}, the print's image, is none of svg, png, jpg, webp, gif, avif; convert it.`,
    );
  }
  return `data:${type};base64,${(await readBytes(path)).toString('base64')}`;
}

/** The print's picture as a design holds it: with all of its bytes; none where there is no such file. */
export async function readPicture(print: Print, printFile: string): Promise<string | undefined> {
  try {
    const tile = await readTile(print, printFile);
    if (tile === undefined || tile.startsWith('http')) return undefined;
    return tile.startsWith('data:') ? tile : `data:image/svg+xml,${encodeURIComponent(tile)}`;
  } catch (error) {
    if (error instanceof UsageError) return undefined; // a solve needs no picture
    throw error;
  }
}
