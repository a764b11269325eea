/** Checks arguments of the element's methods: types and names. `toBlob` itself checks the ranges. */
import {printInks} from '../../cutting/print-ink.js';
import {
  checkArguments,
  checkedLater,
  either,
  fields,
  having,
  signal,
} from '../../model/base/arguments.js';
import {fail, flag, oneOf, text, type Read} from '../../model/base/read.js';
import type {BlobRequest} from './picture.js';

const word = text();
/** A number in a range that the window or the print decides. */
const anyNumber: Read<number> = (value, at) =>
  typeof value === 'number' ? value : fail(at, 'a number');

const waiting = fields<{readonly signal?: AbortSignal}>({signal});
const design = either('a stored design or its JSON text', word, having({}));
const request = fields<BlobRequest>({
  ...{type: word, width: anyNumber, paper: word, allowance: anyNumber, hem: anyNumber},
  ...{ink: oneOf(printInks), guide: flag, dxfStyle: checkedLater, dxfUnit: checkedLater},
  ...{repeat: flag, dpi: anyNumber},
});

/** @throws {SolverError} `options` for options of `solve` or `layPlan` */
export const checkWaiting = (call: 'solve' | 'layPlan', options: unknown): void => {
  checkArguments(call, ['options', options, waiting]);
};

/**
 * Returns the design.
 * @throws {SolverError} `options` for a design of `setDesign` that is neither object nor text
 */
export function checkedDesign(value: unknown): unknown {
  checkArguments('setDesign', ['design', value, design]);
  return value;
}

/** @throws {SolverError} `options` for a request of `toBlob` */
export const checkRequest = (value: unknown): void => {
  checkArguments('toBlob', ['request', value, request]);
};
