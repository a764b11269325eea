/** The rectangular repeat of a print as a picture in its true size, for print shops. */
import {callback, checkArguments} from '../model/base/arguments.js';
import {number} from '../model/base/read.js';
import {withPrintedSize} from '../image/png-size.js';
import {mostPixels, pixelsAt, repeatPixels, resolutionOf} from '../image/repeat-pixels.js';
import type {PhotoPixels} from '../model/print/photo-reading.js';
import {dpiLimits} from '../model/print/print-scale.js';
import {rectangularRepeat, type Rectangle} from '../model/print/rectangular-repeat.js';
import {SolverError} from '../model/base/failure.js';
import {checkScaled} from '../model/result/unscaled-print.js';
import {pixels} from '../solver/requests/later-checks.js';
import type {PrintWithTile} from '../picture/fabric.js';
import {repeatSvg} from '../picture/repeat-svg.js';

export interface RepeatForPrinting {
  /** The smallest upright rectangle that tiles the print; undefined if there is none. [cm] */
  readonly rectangle: Rectangle | undefined;
  /** The rectangle as SVG; without one, the cell as SVG pattern. */
  readonly svg: () => string;
  /**
   * The rectangle as PNG with its printed size.
   * @param cell returns the image of the print's cell
   * @throws {SolverError} `options` without a rectangle, or for too many pixels
   */
  readonly png: (cell: () => Promise<PhotoPixels>, dpi: number) => Promise<RepeatPng>;
}

interface RepeatPng {
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly width: number;
  readonly height: number;
  /** Resolution of the image of the cell in this size. */
  readonly imageDpi: number;
}

const wrong = (message: string): SolverError => new SolverError({code: 'options', message});

/**
 * @param print in the size and turn to be printed
 * @throws {SolverError} `unscaled` for a print of unknown size
 */
export function printRepeat(print: PrintWithTile): RepeatForPrinting {
  checkScaled(print);
  const rectangle = rectangularRepeat(print);
  return {
    rectangle,
    svg: () => repeatSvg(print, rectangle),
    png: async (read, dpi) => {
      checkArguments('png', ['cell', read, callback], ['dpi', dpi, number(...dpiLimits)]);
      if (!rectangle) {
        throw wrong(
          'No upright rectangle of at most twelve repeats tiles this print; write SVG, which has its cell as a pattern.',
        );
      }
      const sides = pixelsAt(rectangle, dpi);
      const [width, height] = sides;
      if (width * height > mostPixels) {
        throw wrong(
          `The repeat would have ${String(width)} x ${String(height)} pixels; take fewer dots per inch, or write SVG.`,
        );
      }
      const cell = await read();
      checkArguments('png', ['cell()', cell, pixels]);
      const image = {...cell, data: new Uint8ClampedArray(cell.data)};
      const {pngOf} = await import('./picture-files.js');
      const png = await pngOf(repeatPixels(print, image, rectangle, sides));
      const imageDpi = resolutionOf(print, cell);
      return {bytes: withPrintedSize(png, rectangle), width, height, imageDpi};
    },
  };
}
