/** Pieces that have to keep their relative places on the print. */
import type {SolveResult} from '../model/result/result.js';

type Joined = Pick<SolveResult, 'pieces' | 'seams' | 'symmetries' | 'matches'>;

/**
 * Groups of piece indices, joined directly or indirectly by matched seams, matches or mirror
 * symmetry.
 */
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

/**
 * Pieces under which the print may move alone, and those under which it moves together; by index.
 */
interface Movable {
  /** Pieces that nothing ties to their place on the print. */
  readonly loose: ReadonlySet<number>;
  /** Groups that move only together, the largest first. */
  readonly joined: readonly (readonly number[])[];
}

/**
 * Divides pieces into loose and joined ones. Single pieces are loose, except the first if all are
 * single.
 */
export function movablePieces(garment: Joined, printed: readonly number[]): Movable {
  const groups = components(garment)
    .map((group) => group.filter((k) => printed.includes(k)))
    .filter((group) => group.length > 0)
    .sort((one, other) => other.length - one.length);
  const isLoose = (group: readonly number[], n: number): boolean => n > 0 && group.length === 1;
  return {
    loose: new Set(groups.filter(isLoose).flat()),
    joined: groups.filter((group, n) => !isLoose(group, n)),
  };
}
