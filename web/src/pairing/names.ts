/** Features of a pair of edges that come from the names of their pieces. */
import type {MeasuredEdge, MeasuredGarment, MeasuredPiece} from './edges.js';
import type {PieceKind} from '../model/garment/piece-words.js';

/** Kinds that are sewn to each other; the first one is worn above the second, or farther inside. */
const neighbours: ReadonlySet<string> = new Set<`${PieceKind} ${PieceKind}`>([
  ...(['hood bodice', 'collar bodice', 'hood collar', 'bodice sleeve', 'sleeve cuff'] as const),
  ...(['bodice band', 'bodice skirt', 'bodice trousers', 'band skirt'] as const),
  ...(['band trousers', 'trousers cuff'] as const),
]);

/** Returns whether pieces of two kinds are sewn to each other. */
export const areNeighbours = (one: PieceKind | undefined, other: PieceKind | undefined): boolean =>
  one !== undefined &&
  other !== undefined &&
  (neighbours.has(`${one} ${other}`) || neighbours.has(`${other} ${one}`));

/** Kinds that hang below their first neighbour, at its foot. */
const below = /^(bodice (band|skirt|trousers)|band (skirt|trousers))$/;

/**
 * Greatest distance from the middle of a piece that is neither left nor right, as a share of its
 * width.
 */
const middle = 0.05;

/**
 * Returns 1 for an edge worn on the left, -1 on the right, and 0 if neither names nor places
 * decide. Pieces are face up.
 */
export function sideOf({pieces}: MeasuredGarment, {at, place: [across]}: MeasuredEdge): number {
  const {side = 0, face = 0} = pieces[at.piece]?.words ?? {};
  if (side !== 0) return side;
  return Math.abs(across) > middle ? face * Math.sign(across) : 0;
}

/** Returns 1 for neighbours in a numbered row or ring, -1 for others in it, and 0 without one. */
function neighboursByNumber(
  pieces: readonly MeasuredPiece[],
  {words: one}: MeasuredPiece,
  {words: other}: MeasuredPiece,
): number {
  if (one.number === undefined || other.number === undefined || one.stem !== other.stem) return 0;
  const row = pieces.filter(({words}) => words.stem === one.stem);
  const areas = row.map(({area}) => area);
  // numbers of pieces that differ are mere numbers
  if (row.length < 3 || Math.max(...areas) > 2 * Math.min(...areas)) return 0;
  const apart = Math.abs(one.number - other.number);
  return apart === 1 || apart === row.length - 1 ? 1 : -1;
}

/** Returns the share of the words in both names, and whether exactly one word differs. */
function sharedWords(one: readonly string[], other: readonly string[]): readonly [number, number] {
  const most = Math.max(one.length, other.length);
  const shared = one.filter((word) => other.includes(word)).length;
  return most === 0 ? [0, 0] : [shared / most, Number(most > 1 && most - shared === 1)];
}

/** Returns the features of two edges by the names of their pieces; symmetric. */
export function nameFeatures(
  garment: MeasuredGarment,
  a: MeasuredEdge,
  b: MeasuredEdge,
): readonly number[] {
  const [p, q] = [garment.pieces[a.at.piece], garment.pieces[b.at.piece]];
  const [one, other] = [p?.words.kind, q?.words.kind];
  if (!p || !q) return [0, 0, 0, 0, 0, 0, 0, 0];
  const areKnown = one !== undefined && other !== undefined;
  const [down, up] = [`${one ?? ''} ${other ?? ''}`, `${other ?? ''} ${one ?? ''}`];
  const isNatural = areNeighbours(one, other);
  const hangs = below.test(down)
    ? (1 - a.place[1]) * b.place[1]
    : below.test(up)
      ? (1 - b.place[1]) * a.place[1]
      : 0;
  const isOther = one === 'pocket' || other === 'pocket';
  return [
    Number(areKnown && one === other),
    Number(isNatural),
    Number(areKnown && one !== other && !isNatural && !isOther),
    hangs,
    sideOf(garment, a) * sideOf(garment, b),
    p === q ? 0 : neighboursByNumber(garment.pieces, p, q),
    ...sharedWords(p.words.all, q.words.all),
  ];
}

/**
 * Returns 1 if two edges of equal length face each other on neighbours in a numbered row or ring,
 * -1 if they do so on other pieces of it, and 0 otherwise.
 */
export function rowOf({edges, pieces}: MeasuredGarment, one: number, other: number): number {
  const [a, b] = [edges[one], edges[other]];
  const [p, q] = [pieces[a?.at.piece ?? -1], pieces[b?.at.piece ?? -1]];
  if (!a || !b || !p || !q || p === q || a.chord[1] * b.chord[1] > -0.5) return 0;
  return Math.abs(Math.log(a.length / b.length)) < 0.01 ? neighboursByNumber(pieces, p, q) : 0;
}
