import {cellPicture, type CellPicture} from '../../files/glb/glb.js';
import type {Print} from '../../model/print/repeating-print.js';
import {FileError} from '../../model/base/versioned-file.js';
import {addressFrom, calledAs, readAddress} from '../../node/addresses.js';

/**
 * The image of the print's cell for a GLB file: the raster of its colourway, otherwise the image.
 * @throws {FileError} if it is neither PNG nor JPEG, since Node does not render SVG
 */
export async function readCell(print: Print, file: URL): Promise<CellPicture | undefined> {
  const {image, colourways = []} = print;
  if (image === undefined) return undefined;
  const raster = colourways.find((one) => one.image === image)?.raster ?? image;
  const picture = cellPicture(await imageBytes(raster, file));
  if (picture) return picture;
  const called = raster.startsWith('data:') ? 'the image' : raster;
  throw new FileError(
    calledAs(file),
    `has no PNG or JPEG of its cell, which is all that GLB files hold: ${called} is neither; name one as 'raster' of a colourway, beside its 'image'.`,
  );
}

async function imageBytes(image: string, file: URL): Promise<Uint8Array> {
  if (!image.startsWith('data:')) return readAddress(addressFrom(file, image));
  try {
    return new Uint8Array(await (await fetch(image)).arrayBuffer());
  } catch (cause) {
    throw new FileError(calledAs(file), 'has an image that is no whole data: URL; correct it.', {
      cause,
    });
  }
}
