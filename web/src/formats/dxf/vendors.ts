/** What programs that write DXF are known to do beyond the standard. */
import type {SplineRule} from '../base/splines.js';

export interface Vendor {
  /** As files name it. */
  readonly program?: string;
  /**
   * The curve through key points. Measured against the dense curves that files hold as well: Gerber's is met by a
   * Catmull-Rom spline to 0.27-0.43 mm in nine of ten places, Richpeace's and CLO's by a natural one to 0.57 and 0.00.
   */
  readonly rule: SplineRule;
}

/** @param author as the file's system text says */
export function vendorOf(author: string | undefined): Vendor {
  const rule = /gerber|accumark/i.test(author ?? '') ? 'catmull-rom' : 'natural';
  return {...(author !== undefined && {program: author.split(';')[0]?.trim() ?? author}), rule};
}
