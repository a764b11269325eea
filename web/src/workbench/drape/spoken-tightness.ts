/** The girth at which a garment is too small to drape, in the user's language. */
import type {Failure} from '../../model/base/failure.js';
import {formSizes, type FormSize} from '../../model/result/draped-garment.js';
import type {DrapeTexts} from '../../texts/drape-texts.js';
import type {Format} from '../../texts/format.js';

/** Girth, measurement and fitting size in the core's message. [cm] */
const girth = / by ([\d.]+) cm at the ([a-z ]+?)(?: \(it fits size ([A-Z]+)\))?:/;

interface Tightness {
  readonly sentence: string;
  /** The largest form that the garment fits; undefined if there is none. */
  readonly fits: FormSize | undefined;
}

/** Returns undefined for another failure, or one without a girth. */
export function tightnessOf(
  {reason, message}: Failure,
  {tooTight, at}: DrapeTexts,
  format: Format,
): Tightness | undefined {
  const [, missing, measure, size] = reason === 'drapeTooSmall' ? (girth.exec(message) ?? []) : [];
  const place = Object.entries(at).find(([name]) => name === measure)?.[1];
  if (missing === undefined || place === undefined) return undefined;
  return {
    sentence: tooTight(format.length(Number(missing)), place),
    fits: formSizes.find((one) => one === size),
  };
}
