/** Pictures of prints that come and go in links. */

/** No print needs more; what unfolds to more is none. [px] */
const mostPixels = 8192;

/** @throws {Error} for what is no picture, or too large a one */
export async function loaded(url: string): Promise<HTMLImageElement> {
  const image = new Image();
  image.src = url;
  await image.decode();
  const {naturalWidth, naturalHeight} = image;
  if (Math.max(naturalWidth, naturalHeight) > mostPixels) throw new Error('too large a picture');
  return image;
}

/** The same picture in fewer pixels, if it has any. @returns a `data:` URL, undefined when it is as small already */
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
  // a JPEG has no holes: what was bare is the white of the cloth
  context.fillStyle = '#fff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  const small = canvas.toDataURL('image/jpeg', 0.85);
  return small.length < url.length ? small : undefined;
}
