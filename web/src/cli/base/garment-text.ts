import {recognised} from '../../files/recognise.js';
import {FileError} from '../../model/base/versioned-file.js';
import {readBytes, textOf} from '../../node/files.js';

/**
 * The bytes of a garment file.
 * @throws {FileError} for drawings, which have to be imported first
 */
export async function readGarmentBytes(path: string): Promise<Buffer> {
  const bytes = await readBytes(path);
  const kind = recognised(bytes);
  if (typeof kind !== 'string') return bytes;
  throw new FileError(
    path,
    `is ${kind.toUpperCase()}; make a garment of it first: seamwise import ${path} --out GARMENT.json.`,
  );
}

/**
 * The text of a garment file.
 * @throws {FileError} under the conditions of `readGarmentBytes`
 */
export const readGarmentText = async (path: string): Promise<string> =>
  textOf(await readGarmentBytes(path));
