/** Draws the rectangular repeat of a print in the browser. */
import {norm} from '../model/geometry/vectors.js';
import type {Rectangle} from '../model/print/rectangular-repeat.js';
import {imageCell, type CellOf} from '../model/print/wallpaper.js';
import {withPrintedSize} from './png-size.js';
import {mostPixels, pixelsAt} from './repeat-pixels.js';
import {imageHref} from './svg-picture.js';

function contextOf(width: number, height: number): CanvasRenderingContext2D | undefined {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [width, height];
  return canvas.getContext('2d') ?? undefined;
}

/**
 * The repeat as PNG with its printed size.
 * @param tile image of the print's cell: SVG text, or a `data:` URL
 * @param rectangle as of `rectangularRepeat`
 * @returns undefined if the picture is too large for the browser
 */
export async function repeatPicture(
  cell: CellOf,
  tile: string,
  rectangle: Rectangle,
  dpi: number,
): Promise<Blob | undefined> {
  const [width, height] = pixelsAt(rectangle, dpi);
  if (width * height > mostPixels) return undefined;
  const image = new Image();
  image.src = imageHref(tile);
  await image.decode();
  const context = contextOf(width, height);
  if (!context) return undefined;
  context.fillStyle = 'white';
  context.fillRect(0, 0, width, height);
  // pixels per cm; not quite equal, since sides are whole pixels
  const [across, up] = [width / rectangle.width, height / rectangle.height];
  const [a, b] = imageCell(cell);
  const isUpright = Math.max(Math.abs(a[1] * up), Math.abs(b[0] * across)) < 0.01;
  const isCell = isUpright && a[0] > 0 && b[1] > 0;
  const sides = [Math.round(norm(a) * across), Math.round(norm(b) * up)] as const;
  const one = isCell ? undefined : contextOf(Math.max(1, sides[0]), Math.max(1, sides[1]));
  if (one) {
    const {canvas} = one;
    one.drawImage(image, 0, 0, canvas.width, canvas.height);
    const pattern = context.createPattern(canvas, 'repeat');
    if (!pattern) return undefined;
    // the image's y runs down, from the end of the second side
    pattern.setTransform(
      new DOMMatrix([
        ...[(a[0] * across) / canvas.width, (-a[1] * up) / canvas.width],
        ...[(-b[0] * across) / canvas.height, (b[1] * up) / canvas.height],
        ...[b[0] * across, height - b[1] * up],
      ]),
    );
    context.fillStyle = pattern;
    context.fillRect(0, 0, width, height);
  } else {
    for (let x = 0; x < width - 0.5; x += a[0] * across) {
      for (let y = height; y > 0.5; y -= b[1] * up) {
        context.drawImage(image, x, y - b[1] * up, a[0] * across, b[1] * up);
      }
    }
  }
  const png = await new Promise<Blob | null>((resolve) => {
    context.canvas.toBlob(resolve);
  });
  if (!png) return undefined;
  const bytes = new Uint8Array(await png.arrayBuffer());
  return new Blob([withPrintedSize(bytes, rectangle)], {type: 'image/png'});
}
