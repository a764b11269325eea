/** Decodes an image to upright pixels, on the thread that answers the request. */
import {SolverError} from '../../model/result/failure.js';
import type {PhotoPixels} from '../../model/print/photo-reading.js';

/** Larger images are reduced: finer detail does not help, and phones lack the memory. [px] */
const longestSide = 4096;

/** Pixels of an image. @throws {SolverError} for an image that cannot be decoded */
export async function decoded(picture: PhotoPixels | Blob): Promise<PhotoPixels> {
  if (!(picture instanceof Blob)) return picture;
  const bitmap = await bitmapOf(picture);
  try {
    const {width, height} = bitmap;
    const scale = Math.min(1, longestSide / Math.max(width, height));
    const [across, down] = [Math.round(scale * width), Math.round(scale * height)];
    const context = new OffscreenCanvas(across, down).getContext('2d', {willReadFrequently: true});
    if (!context) throw new Error('There is no canvas to decode pictures on.');
    context.imageSmoothingQuality = 'high';
    context.fillStyle = 'white';
    context.fillRect(0, 0, across, down);
    context.drawImage(bitmap, 0, 0, across, down);
    return context.getImageData(0, 0, across, down);
  } finally {
    bitmap.close();
  }
}

async function bitmapOf(picture: Blob): Promise<ImageBitmap> {
  try {
    return await createImageBitmap(picture, {
      imageOrientation: 'from-image',
      colorSpaceConversion: 'default',
    });
  } catch {
    throw new SolverError({
      code: 'not-an-image',
      message: 'The picture cannot be read; save it as JPEG or PNG.',
    });
  }
}
