/** A picture in the format that somebody wants. */
const types = ['image/png', 'image/jpeg', 'image/webp'];

/** A type that cannot be written gives a PNG. @throws {Error} where the browser makes no picture of this size */
export async function pictureAs(png: Blob, type = 'image/png'): Promise<Blob> {
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
