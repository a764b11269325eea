/** Types of numbers.mjs, for its tests. */

export function median(values: readonly number[]): number;
export function quotient(fit: number, other: number): number | null;
export function exponent(points: readonly (readonly [number, number])[]): number;
