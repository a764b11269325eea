/** Pieces that have to keep their places on the print relative to each other. */
import type {SolveResult} from '../model/result.js';

type Joined = Pick<SolveResult, 'pieces' | 'seams' | 'symmetries' | 'matches'>;

/** The numbers of the pieces, by what is matched, directly or by way of others; or is each other's mirror image. */
function components({
  pieces,
  seams,
  symmetries,
  matches = [],
}: Joined): readonly (readonly number[])[] {
  const above = pieces.map((_, k) => k);
  const top = (k: number): number => {
    const next = above[k] ?? k;
    return next === k ? k : top(next);
  };
  const join = (one: number, other: number): void => {
    const [first, last] = [top(one), top(other)].sort((a, b) => a - b);
    if (first !== undefined && last !== undefined) above[last] = first;
  };
  for (const {a, b, matched} of seams) if (matched) join(a.piece, b.piece);
  for (const {a, b} of matches) join(a.piece, b.piece);
  for (const symmetry of symmetries) if (symmetry.kind === 'pair') join(...symmetry.pieces);
  const groups = new Map<number, number[]>();
  for (const k of above.keys()) groups.set(top(k), [...(groups.get(top(k)) ?? []), k]);
  return [...groups.values()];
}

/** Pieces that nothing holds to the print where they are: those alone, but for one where all are alone. */
export function loosePieces(joined: Joined, printed: readonly number[]): ReadonlySet<number> {
  const groups = components(joined)
    .map((group) => group.filter((k) => printed.includes(k)))
    .filter((group) => group.length > 0)
    .sort((one, other) => other.length - one.length);
  return new Set(groups.slice(1).flatMap((group) => (group.length === 1 ? group : [])));
}
