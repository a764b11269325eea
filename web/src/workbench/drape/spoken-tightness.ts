/** The girth at which a garment is too small to drape, in the user's language. */
import type {Failure} from '../../model/base/failure.js';
import {formSizes, type FormSize} from '../../model/result/draped-garment.js';
import type {DrapeTexts} from '../../texts/drape-texts.js';
import type {Format} from '../../texts/format.js';

interface Tightness {
  readonly sentence: string;
  /** The largest form that the garment fits; undefined if there is none. */
  readonly fits: FormSize | undefined;
}

/** Returns undefined for another failure, or one without a girth. */
export function tightnessOf(
  {reason, lengthCm, measure, fits}: Failure,
  {tooTight, at}: DrapeTexts,
  format: Format,
): Tightness | undefined {
  if (reason !== 'drapeTooSmall' || lengthCm === undefined) return undefined;
  const place = Object.entries(at).find(([name]) => name === measure)?.[1];
  if (place === undefined) return undefined;
  return {
    sentence: tooTight(format.length(lengthCm), place),
    fits: formSizes.find((one) => one === fits),
  };
}
