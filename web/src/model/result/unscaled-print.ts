/** Prints of unmeasured size: they can be placed, but not cut. */
import {SolverError} from '../base/failure.js';
import type {Print} from '../print/repeating-print.js';

export type PrintScale = Pick<Print, 'title' | 'unscaled'>;

/**
 * Rejects a print whose lengths are in proportion only.
 * @throws {SolverError} with the code `unscaled`
 */
export function checkScaled({title, unscaled}: PrintScale): void {
  if (!unscaled) return;
  const which = title === undefined ? 'this print' : `the print '${title}'`;
  throw new SolverError({
    code: 'unscaled',
    message: `The size of ${which} is unknown, so that nothing can be cut by it; measure a repeat, and give its w1 and w2 in cm, without 'unscaled'.`,
  });
}
