/** Types of ratios.mjs, for its tests. */

export interface Numbered {
  readonly name: string;
  readonly value: number;
}

export interface Ratio {
  readonly title: string;
  readonly over: 'median' | 'worst';
  readonly value: number;
  readonly goal: number;
  readonly aim: number;
  readonly met: boolean;
  readonly reached: boolean;
  readonly worst: Numbered;
  readonly missed: number;
  readonly cases: number;
}

export function ratiosOf(results: Readonly<Record<string, unknown>>): Ratio[];
export function summary(
  title: string,
  over: Ratio['over'],
  goal: number,
  aim: number,
  numbers: readonly Numbered[],
): Ratio;
