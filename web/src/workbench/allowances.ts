/** Seam and hem allowances, the same for cutting files and for the pieces on their fabric. */
import {ruleOf} from '../cutting/allowance-rule.js';
import type {Units} from '../model/base/length-text.js';
import type {ChosenAllowances, Preferences} from '../texts/preferences.js';

type Chosen = Pick<Preferences, 'units' | 'allowances'>;

/** Allowances of most patterns, in centimetres, or in inches that a ruler shows. */
const usual: Readonly<Record<Units, ChosenAllowances>> = {
  cm: ruleOf({}),
  inch: {allowanceCm: 0.375 * 2.54, hemCm: 1.25 * 2.54},
};

export const allowancesIn = ({units, allowances}: Chosen): ChosenAllowances => ({
  ...usual[units],
  ...allowances,
});

/**
 * Preferences with these allowances. Usual values are not stored, so that they follow the units.
 */
export function withAllowances(
  chosen: ChosenAllowances,
  {units}: Chosen,
): Pick<Preferences, 'allowances'> {
  const {allowanceCm, hemCm} = chosen;
  return {
    allowances: {
      ...(allowanceCm !== usual[units].allowanceCm && {allowanceCm}),
      ...(hemCm !== usual[units].hemCm && {hemCm}),
    },
  };
}
