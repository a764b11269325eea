/** Deviations of DXF programs from the standard. */
import type {FileUnit} from '../../model/garment/garment-document.js';
import type {SplineRule} from '../base/splines.js';

export interface Vendor {
  /** Program name in the file. */
  readonly program?: string;
  /**
   * The spline through key points, compared with the dense curves of the same files. A Catmull-Rom
   * spline fits Gerber's to 0.27-0.43 mm in nine of ten places. A natural spline fits Richpeace's
   * and CLO's to 0.57 and 0.00 mm. Undefined for our own files, whose points are dense.
   */
  readonly rule?: SplineRule;
  /** Units that METRIC means, the most likely first. CLO writes centimetres. */
  readonly metric: readonly FileUnit[];
}

/**
 * The program of a file.
 * @param author author in the file's system text
 */
export function vendorOf(author: string | undefined): Vendor {
  const isOwn = /^seamwise/i.test(author ?? '');
  const rule = /gerber|accumark/i.test(author ?? '') ? 'catmull-rom' : 'natural';
  const metric: readonly FileUnit[] = isOwn ? ['mm'] : ['mm', 'cm'];
  return {
    ...(author !== undefined && {program: author.split(';')[0]?.trim() ?? author}),
    ...(!isOwn && {rule}),
    metric,
  };
}
