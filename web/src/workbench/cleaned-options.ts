/**
 * Options without names of pieces, and numbers of seams and edges, that a garment does not have.
 */
import type {Locks, SolveOptions} from '../model/design/options.js';
import type {MeshedPattern} from '../model/result/result.js';

type Entries<Value> = Readonly<Record<string, Value>>;

const only = <Value>(all: Entries<Value>, has: (key: string) => boolean): Entries<Value> =>
  Object.fromEntries(Object.entries(all).filter(([key]) => has(key)));

const knownLocks = (locked: Locks, edgesOf: ReadonlyMap<string, readonly number[]>): Locks =>
  Object.fromEntries(
    Object.entries(locked).flatMap(([name, lock]) => {
      const edges = edgesOf.get(name);
      if (!edges) return [];
      const known = lock === true || lock.filter((edge) => edges.includes(edge));
      return known === true || known.length > 0 ? [[name, known]] : [];
    }),
  );

/** Cleans options; returns the same object when there is nothing to remove. */
export function cleanedOptions(
  options: SolveOptions,
  {pieces, seams}: Pick<MeshedPattern, 'pieces' | 'seams'>,
): SolveOptions {
  const edgesOf = new Map(pieces.map(({name, edges}) => [name, edges]));
  const isPiece = (name: string): boolean => edgesOf.has(name);
  const isSeam = (number: string | number): boolean => seams[Number(number)] !== undefined;
  const {pins, plain, locked, weights, unmatched, matches, grain} = options;
  const cleaned: SolveOptions = {
    ...options,
    ...(pins && {pins: only(pins, isPiece)}),
    ...(plain && {plain: plain.filter(isPiece)}),
    ...(locked && {locked: knownLocks(locked, edgesOf)}),
    ...(weights && {weights: only(weights, isSeam)}),
    ...(unmatched && {unmatched: unmatched.filter(isSeam)}),
    ...(matches && {matches: matches.filter(({a, b}) => isPiece(a.piece) && isPiece(b.piece))}),
    ...(grain?.pieces && {grain: {...grain, pieces: only(grain.pieces, isPiece)}}),
  };
  return JSON.stringify(cleaned) === JSON.stringify(options) ? options : cleaned;
}
