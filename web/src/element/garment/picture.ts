/** A picture in the format that somebody wants. */
import {SolverError} from '../../model/failure.js';

const types = ['image/png', 'image/jpeg', 'image/webp'];

/** A type that cannot be written gives a PNG. */
export async function pictureAs(png: Blob, type = 'image/png'): Promise<Blob> {
  if (type === png.type || !types.includes(type)) return png;
  const picture = await createImageBitmap(png);
  const canvas = document.createElement('canvas');
  canvas.width = picture.width;
  canvas.height = picture.height;
  canvas.getContext('2d')?.drawImage(picture, 0, 0);
  picture.close();
  const blob = await new Promise<Blob | null>((resolve) => {
    canvas.toBlob(resolve, type, 0.92);
  });
  if (!blob) throw new SolverError({code: 'internal', message: 'The picture cannot be written.'});
  return blob;
}
