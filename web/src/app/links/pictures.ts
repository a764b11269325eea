/** Images of prints in links. */

/** Longest side of an image; no print needs more, and larger ones are rejected. [px] */
const mostPixels = 8192;

/** @throws {Error} if the URL is no image, or the image is too large */
export async function loaded(url: string): Promise<HTMLImageElement> {
  const image = new Image();
  image.src = url;
  await image.decode();
  const {naturalWidth, naturalHeight} = image;
  if (Math.max(naturalWidth, naturalHeight) > mostPixels) throw new Error('too large a picture');
  return image;
}

/**
 * Returns the same image with fewer pixels, if it has any.
 * @returns a `data:` URL; undefined if it would not be smaller
 */
export async function smaller(url: string, side: number): Promise<string | undefined> {
  if (url.startsWith('data:image/svg')) return undefined;
  const image = await loaded(url);
  const {naturalWidth, naturalHeight} = image;
  const scale = Math.min(1, side / Math.max(naturalWidth, naturalHeight));
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, Math.round(naturalWidth * scale));
  canvas.height = Math.max(1, Math.round(naturalHeight * scale));
  const context = canvas.getContext('2d');
  if (!context) return undefined;
  // a JPEG has no transparency: transparent parts become white like the fabric
  context.fillStyle = '#fff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  const small = canvas.toDataURL('image/jpeg', 0.85);
  return small.length < url.length ? small : undefined;
}
