/** Builds a print's cell for a PDF from any supported image. Drawing code is loaded on demand. */
import {blobOf} from '../image/data-url.js';
import {norm, plus, unit, type Point} from '../model/geometry/vectors.js';
import {FileError} from '../model/base/versioned-file.js';
import {imageCell} from '../model/print/wallpaper.js';
import type {PrintWithTile} from '../picture/fabric.js';
import {rasterCell, vectorCell, type Cell} from './cell.js';
import type {PdfResources} from '../files/pdf/resources.js';

/**
 * Returns the cell as PNG or JPEG, for an image that is neither and no simple SVG. Sizes in pixels.
 */
export type CellPixels = (
  width: number,
  height: number,
) => Promise<Uint8Array<ArrayBuffer> | undefined>;

/** Resolution for rendering the cell. [dots per inch] */
const drawnDpi = 300;
/** Least resolution without visible pixels. [dots per inch] */
const leastDpi = 150;
const inch = 2.54;

/** Outline of a cell, for prints without an image. */
const blank = (width: number, height: number): string =>
  `<svg viewBox="0 0 ${width} ${height}"><rect width="100%" height="100%" fill="#f1ede3" stroke="#c9c1ae" stroke-width="0.03"/></svg>`;

const svgType = /^data:image\/svg\+xml\b/i;

/** The text of an SVG, or the bytes of another embedded image; undefined for an external one. */
async function contentOf(tile: string): Promise<string | Uint8Array<ArrayBuffer> | undefined> {
  if (tile.trimStart().startsWith('<')) return tile;
  if (!tile.startsWith('data:')) return undefined;
  const blob = blobOf(tile);
  return svgType.test(tile) ? blob.text() : new Uint8Array(await blob.arrayBuffer());
}

/**
 * The cell of a print for a PDF.
 * @throws {FileError} if the image cannot be drawn
 */
export async function fabricCell(
  resources: PdfResources,
  print: PrintWithTile,
  pixels: CellPixels | undefined,
  note: (sentence: string) => void,
): Promise<Cell> {
  const [width = 0, height = 0] = imageCell(print).map(norm);
  const {tile = blank(width, height), image = ''} = print;
  const called = image === '' || image.startsWith('data:') ? 'The picture of the print' : image;
  const content = await contentOf(tile);
  if (typeof content === 'string') {
    const {vectorTile} = await import('./vector-tile.js');
    const groups = vectorTile(content, width, height);
    if (groups) {
      const {drawnLevels, lengthened} = await import('./vector-cell.js');
      const all = groups.map(({leaves}) => leaves);
      const {size, groups: longer} = lengthened(all, [width, height]);
      const [a, b] = imageCell(print).map(unit) as [Point, Point];
      const cell = vectorCell(
        resources,
        [plus([0, 0], a, size[0]), plus([0, 0], b, size[1])],
        longer.map((leaves, k) => ({
          ...drawnLevels(leaves, size),
          opacity: groups[k]?.opacity ?? 1,
        })),
      );
      return {...cell, leaves: all.flat()};
    }
  }
  const {pdfImage} = await import('../files/pdf/image.js');
  const own = content instanceof Uint8Array ? await pdfImage(content, called) : undefined;
  const dots = (cm: number): number => Math.ceil((cm / inch) * drawnDpi);
  const drawn = own ? undefined : await pixels?.(dots(width), dots(height));
  const found = own ?? (drawn && (await pdfImage(drawn, called)));
  if (!found) {
    throw new FileError(
      called,
      'is none of the pictures that PDF files hold, a PNG, a JPEG or an SVG of simple shapes in plain colours; save it as PNG.',
    );
  }
  const dpi = Math.min(found.width / width, found.height / height) * inch;
  if (dpi < leastDpi) {
    note(
      `${called} has ${Math.round(dpi)} dots per inch at this size, so its pixels will show; ${leastDpi} and more look sharp.`,
    );
  }
  return rasterCell(resources, print, found);
}
