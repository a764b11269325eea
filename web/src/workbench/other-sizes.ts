/** Other sizes of a design's print. */
import type {Design} from '../model/design/design.js';

/** Returns whether the print can be enlarged: its size is known, and the fabric is not printed. */
export const canResize = ({method, print}: Pick<Design, 'method' | 'print'>): boolean =>
  method === 'best' && !print.unscaled && !print.isPrinted && !print.delivered?.measured;

/**
 * Returns whether there are other sizes or turns of the print.
 * @param offered sizes that a shop offers, as multiples of the print's own; undefined without a shop
 */
export const hasOtherSizes = (
  design: Pick<Design, 'method' | 'print'>,
  offered: readonly number[] | undefined,
): boolean => canResize(design) && (offered === undefined || offered.some((scale) => scale !== 1));
