/** Turns SVG files into pixels. */
import {createCanvas, loadImage} from '@napi-rs/canvas';

export interface Pixels {
  readonly width: number;
  readonly height: number;
  /** Red, green, blue, alpha, row by row from the top. */
  readonly data: Uint8ClampedArray;
}

/** @param svg a file whose first width and height are those of its root */
export async function rendered(svg: string, width: number, height: number): Promise<Pixels> {
  const sized = svg.replace(
    /width="[\d.]+" height="[\d.]+"/,
    `width="${width}" height="${height}"`,
  );
  return decoded(Buffer.from(sized));
}

/** The pixels of an image file. */
export async function decoded(file: Buffer): Promise<Pixels> {
  const image = await loadImage(file);
  const context = createCanvas(image.width, image.height).getContext('2d');
  context.drawImage(image, 0, 0);
  return context.getImageData(0, 0, image.width, image.height);
}
