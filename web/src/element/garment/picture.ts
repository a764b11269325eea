/** A picture of the pattern, as somebody wants it. */
import {SolverError} from '../../model/failure.js';
import type {Texts} from '../../texts/texts.js';
import type {SheetWindow} from '../../workbench/state.js';

const types = ['image/png', 'image/jpeg', 'image/webp'];

/** A type that cannot be written gives a PNG. @throws {Error} where the browser makes no picture of this size */
async function pictureAs(png: Blob, type = 'image/png'): Promise<Blob> {
  if (type === png.type || !types.includes(type)) return png;
  const picture = await createImageBitmap(png);
  const canvas = document.createElement('canvas');
  canvas.width = picture.width;
  canvas.height = picture.height;
  canvas.getContext('2d')?.drawImage(picture, 0, 0);
  picture.close();
  return new Promise((resolve, reject) => {
    const written = (blob: Blob | null): void => {
      if (blob) resolve(blob);
      else reject(new Error(`There is no ${type} of ${canvas.width} x ${canvas.height} pixels.`));
    };
    canvas.toBlob(written, type, 0.92);
  });
}

/** @throws {SolverError} with one sentence where nothing is drawn, for a wrong width, and where it cannot be written */
export async function pictureOf(
  view: SheetWindow | undefined,
  isDrawn: boolean,
  {type, width}: {readonly type: string | undefined; readonly width: number | undefined},
  {garment, pattern}: Texts,
): Promise<Blob> {
  if (view?.isLost) throw new SolverError({code: 'no-webgl', message: pattern.lost});
  if (!view || !isDrawn) throw new SolverError({code: 'no-webgl', message: garment.noDrawing});
  // also for what is no number
  if (width !== undefined && !(width >= 1 && width <= view.widest)) {
    throw new SolverError({code: 'options', message: garment.pictureWidth(String(view.widest))});
  }
  try {
    return await pictureAs(await view.picture(width), type);
  } catch {
    throw new SolverError({code: 'internal', message: garment.noPicture});
  }
}
