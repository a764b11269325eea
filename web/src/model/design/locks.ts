/** Locked parts stay as drafted: pieces, and edges of their outlines, with their mirror images. */
import type {Locks, SolveOptions} from './options.js';
import type {MeshedPattern} from '../result/result.js';

/** A pattern with the edges of its pieces, and the images of vertices in its symmetries. */
export type LockablePattern = Pick<MeshedPattern, 'symmetries'> & {
  readonly pieces: readonly Pick<MeshedPattern['pieces'][number], 'name' | 'outline' | 'edges'>[];
};

/** Locked parts of one piece. */
interface KeptParts {
  readonly whole: boolean;
  /** Numbers of edges in the garment file; all edges of a locked piece. */
  readonly edges: ReadonlySet<number>;
}

/** An edge of a piece, or the whole piece without an edge. */
export interface Lockable {
  readonly piece: number;
  readonly edge?: number | undefined;
}

/** A symmetry as a map of pieces and edges, in one direction. */
interface Image {
  readonly from: number;
  readonly to: number;
  readonly edges: ReadonlyMap<number, number>;
}

function imageOf(
  {pieces}: LockablePattern,
  from: number,
  to: number,
  vertices: ReadonlyMap<number, number>,
): Image {
  const [source, target] = [pieces[from], pieces[to]];
  const position = new Map(target?.outline.map((vertex, k) => [vertex, k]));
  const edges = new Map<number, number>();
  source?.edges.forEach((edge, k) => {
    // mirroring reverses the outline: the image of an edge begins where the edge ends
    const end = source.outline[(k + 1) % source.outline.length];
    const start = end === undefined ? undefined : position.get(vertices.get(end) ?? -1);
    const image = start === undefined ? undefined : target?.edges[start];
    if (image !== undefined) edges.set(edge, image);
  });
  return {from, to, edges};
}

const imagesOf = (pattern: LockablePattern): readonly Image[] =>
  pattern.symmetries.flatMap((one) => {
    const [first, second] = one.kind === 'piece' ? [one.piece, one.piece] : one.pieces;
    const forth = new Map(one.pairs);
    const back = new Map(one.pairs.map(([i, j]) => [j, i]));
    return [imageOf(pattern, first, second, forth), imageOf(pattern, second, first, back)];
  });

/** A part and its mirror images; the part itself comes first. */
function orbit(images: readonly Image[], part: Lockable): readonly Lockable[] {
  const parts: Lockable[] = [part];
  for (const {piece, edge} of parts) {
    for (const image of images) {
      if (image.from !== piece) continue;
      const other = edge === undefined ? undefined : image.edges.get(edge);
      if (edge !== undefined && other === undefined) continue;
      if (parts.some((one) => one.piece === image.to && one.edge === other)) continue;
      parts.push({piece: image.to, edge: other});
    }
  }
  return parts;
}

/** Locked parts of each piece, with mirror images. */
export function keptParts(
  pattern: LockablePattern,
  locked: Locks | undefined,
): readonly KeptParts[] {
  const parts = pattern.pieces.map(() => ({whole: false, edges: new Set<number>()}));
  if (!locked) return parts;
  const images = imagesOf(pattern);
  pattern.pieces.forEach(({name}, piece) => {
    const lock = Object.hasOwn(locked, name) ? locked[name] : undefined;
    const asked: readonly Lockable[] =
      lock === true ? [{piece}] : (lock ?? []).map((edge) => ({piece, edge}));
    for (const one of asked.flatMap((part) => orbit(images, part))) {
      const part = parts[one.piece];
      if (!part) continue;
      if (one.edge === undefined) part.whole = true;
      else part.edges.add(one.edge);
    }
  });
  parts.forEach((part, piece) => {
    if (part.whole) part.edges = new Set(pattern.pieces[piece]?.edges);
  });
  return parts;
}

export const isKept = (parts: readonly KeptParts[], {piece, edge}: Lockable): boolean =>
  (edge === undefined ? parts[piece]?.whole : parts[piece]?.edges.has(edge)) ?? false;

/** Unlocks a locked part with its mirror images, or locks an unlocked part. */
export function toggledLock(
  options: SolveOptions,
  pattern: LockablePattern,
  part: Lockable,
): SolveOptions {
  const {locked: before = {}, ...others} = options;
  const parts = keptParts(pattern, before);
  const locked = isKept(parts, part)
    ? orbit(imagesOf(pattern), part).reduce((all, one) => released(all, pattern, one), before)
    : kept(before, pattern, part);
  return Object.keys(locked).length > 0 ? {...others, locked} : others;
}

function kept(locked: Locks, {pieces}: LockablePattern, {piece, edge}: Lockable): Locks {
  const name = pieces[piece]?.name;
  if (name === undefined) return locked;
  if (edge === undefined) return {...locked, [name]: true};
  const lock = Object.hasOwn(locked, name) ? locked[name] : undefined;
  const edges = lock === true || lock === undefined ? [] : lock;
  return {...locked, [name]: [...edges, edge].sort((one, other) => one - other)};
}

/** Unlocks a part. If a single edge of a locked piece is unlocked, its other edges stay locked. */
function released(locked: Locks, {pieces}: LockablePattern, {piece, edge}: Lockable): Locks {
  const {name = '', edges: all = []} = pieces[piece] ?? {};
  const lock = Object.hasOwn(locked, name) ? locked[name] : undefined;
  if (lock === undefined) return locked;
  const edges = lock === true ? [...new Set(all)].sort((one, other) => one - other) : lock;
  const left = edge === undefined ? [] : edges.filter((one) => one !== edge);
  const others = Object.fromEntries(Object.entries(locked).filter(([other]) => other !== name));
  return left.length > 0 ? {...others, [name]: left} : others;
}
