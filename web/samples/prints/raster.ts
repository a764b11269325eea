/** Turns SVG files into pixels. */
import {createCanvas, loadImage} from '@napi-rs/canvas';

import type {Pixels} from '../../src/image/tile-fabric.js';

export type {Pixels};

/**
 * @param svg  a file whose first width and height are those of its root
 * @param ground  colour of transparent parts
 */
export async function rendered(
  svg: string,
  width: number,
  height: number,
  ground?: string,
): Promise<Pixels> {
  const sized = svg.replace(
    /width="[\d.]+" height="[\d.]+"/,
    `width="${width}" height="${height}"`,
  );
  return decoded(Buffer.from(sized), ground);
}

/** The pixels of an image file. */
export async function decoded(file: Buffer, ground?: string): Promise<Pixels> {
  const image = await loadImage(file);
  const context = createCanvas(image.width, image.height).getContext('2d');
  if (ground !== undefined) {
    context.fillStyle = ground;
    context.fillRect(0, 0, image.width, image.height);
  }
  context.drawImage(image, 0, 0);
  const {width, height, data} = context.getImageData(0, 0, image.width, image.height);
  return {width, height, data};
}
