/** The picture of a print's cell as pixels, wherever a design has it. */
import type {Pixels} from '../../picture/tile-cloth.js';

/** Longest side of what is compared, and of a picture that is drawn anew. [px] */
const compared = 320;
const drawnAnew = 4096;
/** A picture without pixels of its own is drawn this large. */
const vectorDrawn = 1536;

export async function loadPicture(url: string): Promise<HTMLImageElement> {
  const image = new Image();
  image.src = url;
  await image.decode();
  return image;
}

function canvasOf(width: number, height: number): CanvasRenderingContext2D {
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, Math.round(width));
  canvas.height = Math.max(1, Math.round(height));
  const context = canvas.getContext('2d');
  if (!context) throw new Error('This browser draws no pictures.');
  return context;
}

/** A few pixels of a picture, in its own proportions. */
export function pixelsOf(image: HTMLImageElement): Pixels {
  const {naturalWidth, naturalHeight} = image;
  const scale = Math.min(1, compared / Math.max(naturalWidth, naturalHeight));
  const context = canvasOf(naturalWidth * scale, naturalHeight * scale);
  const {width, height} = context.canvas;
  context.drawImage(image, 0, 0, width, height);
  return context.getImageData(0, 0, width, height);
}

/** The same picture, turned clockwise by 90 degrees. @returns a `data:` URL */
export async function quarterTurned(url: string): Promise<string> {
  const image = await loadPicture(url);
  const longest = Math.max(image.naturalWidth, image.naturalHeight);
  const isVector = /^data:image\/svg|\.svg$/.test(url);
  const scale = isVector ? vectorDrawn / longest : Math.min(1, drawnAnew / longest);
  const [width, height] = [image.naturalWidth * scale, image.naturalHeight * scale];
  const context = canvasOf(height, width);
  context.translate(context.canvas.width, 0);
  context.rotate(Math.PI / 2);
  context.drawImage(image, 0, 0, width, height);
  return context.canvas.toDataURL(url.startsWith('data:image/jpeg') ? 'image/jpeg' : 'image/png');
}
