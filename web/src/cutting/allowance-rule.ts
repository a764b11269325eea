/** Seam allowances where a garment states none. */

/** Allowances of edges without their own. */
export interface AllowanceRule {
  readonly allowanceCm: number;
  /** Hem allowance; defaults to `allowanceCm`. */
  readonly hemCm?: number;
}

/** Greatest allowance that can be chosen, above any in use. [cm] */
export const greatestAllowance = 10;

/** Allowances of most patterns where nothing else is stated. [cm] */
const usual = {allowanceCm: 1, hemCm: 3} as const;

/** Completes a rule: a stated allowance holds for hems, too. */
export const ruleOf = ({
  allowanceCm,
  hemCm,
}: {
  readonly [name in keyof AllowanceRule]?: number | undefined;
}): Required<AllowanceRule> => ({
  allowanceCm: allowanceCm ?? usual.allowanceCm,
  hemCm: hemCm ?? allowanceCm ?? usual.hemCm,
});
