/** Print files: JSON with the group and lattice of a print, and optionally images of its cell. */
import {groupNames} from '../base/core-tables.js';
import {scaleLimits} from './print-scale.js';
import {mostTurn} from './print-variant.js';
import {printCells, type Print} from './repeating-print.js';
import {
  flag,
  listOf,
  Malformed,
  number,
  oneOf,
  pairOf,
  shape,
  text,
  type Read,
} from '../base/read.js';
import {FileError} from '../base/versioned-file.js';

/** [cm] */
const length = number(-10_000, 10_000);

const percent = number(-1000, 1000);
const deliveredFields = {
  shrinkage: shape({warp: percent, weft: percent}),
  measured: shape({}, {across: length, up: length}),
};
const fabric: Read<NonNullable<Print['fabric']>> = (value, at) => ({
  ...(value as object), // other fields of the file
  ...shape({}, {...deliveredFields, usableWidthCm: length})(value, at),
});

const fields: Read<Print> = shape(
  {group: oneOf(groupNames), w1: pairOf(length), w2: pairOf(length)},
  {
    image: text(),
    colourways: listOf(shape({name: text(), image: text()}, {raster: text()})),
    oneWay: flag,
    unscaled: flag,
    scale: number(...scaleLimits),
    turnDeg: number(-mostTurn, mostTurn),
    cell: oneOf(printCells),
    ...{fabric, delivered: shape({}, deliveredFields)},
  },
);

/**
 * Reads a print file; unknown fields are kept unchanged.
 * @throws {FileError} naming the field that is wrong
 */
export function readPrintFile(content: string, called: string): Print {
  try {
    const file: unknown = JSON.parse(content);
    return {...(file as object), ...fields(file, '')};
  } catch (cause) {
    if (!(cause instanceof Malformed || cause instanceof SyntaxError)) throw cause;
    const what = cause instanceof Malformed ? cause.message : 'it is not JSON';
    throw new FileError(called, `is no print file: ${what}; correct it.`, {cause});
  }
}
