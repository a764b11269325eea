/** Reads files of other programs as drawings. */
import type {Drawing, DrawingOptions} from '../model/garment/imported-drawing.js';
import {FileError} from '../model/base/versioned-file.js';
import {readDxf} from './dxf/read-dxf.js';
import {readObj} from './obj/read-obj.js';
import {decoded} from './base/decoded.js';
import {recognised, type DrawingKind} from './recognise.js';
import {readSvg} from './svg/read-svg.js';

/** Greatest size of a pattern file. [bytes] */
export const drawingLimit = 64_000_000;

type Read = (bytes: Uint8Array, name: string, options: DrawingOptions) => Drawing;

const readers: Readonly<Record<DrawingKind, Read>> = {
  dxf: readDxf,
  svg: (bytes, name, options) => readSvg(decoded(bytes), name, options),
  obj: (bytes, name, {units}) => readObj(bytes, name, units),
};

/** Returns whether a byte is white space or zero. */
const isBlank = (byte: number): boolean => byte === 0 || byte === 32 || (byte > 8 && byte < 14);

/**
 * Reads a drawing.
 * @param name file name for messages
 * @throws {FileError} with the file, the error and a remedy
 */
export function readDrawing(
  bytes: Uint8Array,
  name: string,
  options: DrawingOptions = {},
): Drawing {
  if (bytes.length > drawingLimit) {
    throw new FileError(
      name,
      `is larger than ${drawingLimit / 1e6} MB, which no pattern is; export the pieces of one garment alone.`,
    );
  }
  if (bytes.every(isBlank)) throw new FileError(name, 'is empty; export it again.');
  const kind = recognised(bytes);
  if (kind === undefined) {
    throw new FileError(
      name,
      'is no pattern that can be read, or damaged; export it again, as DXF (AAMA or ASTM), SVG or OBJ.',
    );
  }
  if (typeof kind !== 'string') throw new FileError(name, kind.refusal);
  if (options.pixelsPerInch !== undefined && kind !== 'svg') {
    throw new FileError(name, 'is no SVG and has no pixels; give its unit as mm, cm or in.');
  }
  return readers[kind](bytes, name, options);
}
