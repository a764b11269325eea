/** What a person decides about one seam or one piece, as a change of the solver's options. */
import type {GrainLock, SolveOptions} from '../../model/options.js';
import type {SeamRow} from './rows.js';

export const matches = ['double', 'full', 'half', 'none'] as const;
export type Match = (typeof matches)[number];

const weights = {double: 2, full: 1, half: 0.5} as const;

/** Undefined for a weight of its own. */
export function matchOf({matched, weight}: Pick<SeamRow, 'matched' | 'weight'>): Match | undefined {
  if (!matched) return 'none';
  return matches.find((match) => match !== 'none' && weights[match] === weight);
}

const without = <Value>(
  all: Readonly<Record<string, Value>> | undefined,
  key: string | number,
): Record<string, Value> =>
  Object.fromEntries(Object.entries(all ?? {}).filter(([name]) => name !== String(key)));

/** A weight that the garment file gives by itself need not be said. */
export function withMatch(
  options: SolveOptions,
  {seam, ownWeight}: Pick<SeamRow, 'seam' | 'ownWeight'>,
  match: Match,
): SolveOptions {
  const others = (options.unmatched ?? []).filter((number) => number !== seam);
  if (match === 'none') return {...options, unmatched: [...others, seam]};
  const weight = weights[match];
  const rest = without(options.weights, seam);
  return {
    ...options,
    unmatched: others,
    weights: weight === ownWeight ? rest : {...rest, [seam]: weight},
  };
}

export function withGrain(
  options: SolveOptions,
  piece: string,
  grain: GrainLock | 'all',
): SolveOptions {
  const rest = without(options.grain?.pieces, piece);
  const pieces = grain === 'all' ? rest : {...rest, [piece]: grain};
  return {...options, grain: {...options.grain, pieces}};
}

export function withPrinted(options: SolveOptions, piece: string, printed: boolean): SolveOptions {
  const others = (options.plain ?? []).filter((name) => name !== piece);
  return {...options, plain: printed ? others : [...others, piece]};
}

export const withoutPin = (options: SolveOptions, piece: string): SolveOptions => ({
  ...options,
  pins: without(options.pins, piece),
});
