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

/** What of the print on a garment's pieces may move, and with what. Pieces are meant by their numbers. */
interface Movable {
  /** Each by itself: nothing holds it to the print where it is. */
  readonly loose: ReadonlySet<number>;
  /** Only together; the one of most pieces first. */
  readonly joined: readonly (readonly number[])[];
}

/** Pieces alone are loose, but for one where all are alone. */
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
