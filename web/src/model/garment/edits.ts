/**
 * Edits of a garment: each takes a document and returns a new one. An edit may change the numbers
 * of edges and seams, and maps the old numbers to the new ones. Lengths in cm.
 */
import {edgeLength, splitCurve} from './edge-curve.js';
import type {
  Allowance,
  DraftedEdge,
  EdgeOfPiece,
  GarmentDocument,
  GarmentPiece,
  GarmentSeam,
} from './garment-document.js';
import {distance, middle, minus, plus, leftOf, type Point} from '../geometry/vectors.js';
import type {Symmetry} from './symmetries.js';

export interface Edited {
  readonly document: GarmentDocument;
  /**
   * The new edges of an old one: itself, its parts from its start to its end, or none of a removed
   * piece.
   */
  readonly edgesOf: (edge: EdgeOfPiece) => readonly EdgeOfPiece[];
  /** The new numbers of an old seam: none, itself, or its parts. */
  readonly seamsOf: (seam: number) => readonly number[];
}

/** An edit that keeps all numbers of edges and seams. */
export const unchanged = (document: GarmentDocument): Edited => ({
  document,
  edgesOf: (edge) => [edge],
  seamsOf: (seam) => [seam],
});

/** Applies one edit after the other. */
export function after(first: Edited, next: (document: GarmentDocument) => Edited): Edited {
  const second = next(first.document);
  return {
    document: second.document,
    edgesOf: (edge) => first.edgesOf(edge).flatMap(second.edgesOf),
    seamsOf: (seam) => first.seamsOf(seam).flatMap(second.seamsOf),
  };
}

export const sameEdge = (one: EdgeOfPiece, other: EdgeOfPiece): boolean =>
  one.piece === other.piece && one.edge === other.edge;

export const edgeOf = ({pieces}: GarmentDocument, at: EdgeOfPiece): DraftedEdge | undefined =>
  pieces[at.piece]?.outline[at.edge];

/** Number of the seam that contains an edge; undefined without one. */
export function seamAt({seams}: GarmentDocument, edge: EdgeOfPiece): number | undefined {
  const seam = seams.findIndex(({a, b}) => sameEdge(a, edge) || sameEdge(b, edge));
  return seam < 0 ? undefined : seam;
}

/** The edge on the other side of a seam. */
export const twinOf = ({a, b}: GarmentSeam, edge: EdgeOfPiece): EdgeOfPiece =>
  sameEdge(a, edge) ? b : a;

/** Returns whether the user has marked an edge as not sewn. */
export const isOpen = (edge: DraftedEdge | undefined): boolean => edge?.open === true;

const inPiece = (
  document: GarmentDocument,
  number: number,
  change: (piece: GarmentPiece) => GarmentPiece,
): GarmentDocument => ({
  ...document,
  pieces: document.pieces.map((piece, k) => (k === number ? change(piece) : piece)),
});

const inEdge = (
  document: GarmentDocument,
  at: EdgeOfPiece,
  change: (edge: DraftedEdge) => DraftedEdge,
): GarmentDocument =>
  inPiece(document, at.piece, (piece) => ({
    ...piece,
    outline: piece.outline.map((edge, k) => (k === at.edge ? change(edge) : edge)),
  }));

/**
 * Axis in which two edges of an outline mirror each other: the start of one onto the end of the
 * other.
 */
export function axisBetween(one: DraftedEdge, other: DraftedEdge): readonly [Point, Point] {
  const ends = [
    [one.points[0], other.points.at(-1) ?? other.points[0]],
    [one.points.at(-1) ?? one.points[0], other.points[0]],
  ] as const;
  const [first, second] = ends.map(([p, q]) => middle(p, q)) as [Point, Point];
  if (distance(first, second) > 1) return [first, second];
  const [p, q] = ends[0];
  return [first, plus(first, leftOf(minus(q, p)))];
}

/**
 * Symmetries of a piece before one of its edges is split. Halves have no mirror image, so a
 * symmetry by this edge becomes one by axis.
 */
function withoutSplit(
  symmetries: readonly Symmetry[],
  {name, outline}: GarmentPiece,
  split: number,
): readonly Symmetry[] {
  const moved = (edge: number): number => (edge > split ? edge + 1 : edge);
  return symmetries.map((one): Symmetry => {
    if (one.kind !== 'piece' || one.piece !== name || !one.seams) return one;
    const [first, second] = one.seams;
    const [a, b] = [outline[first], outline[second]];
    if (!a || !b || (first !== split && second !== split))
      return {...one, seams: [moved(first), moved(second)]};
    return {kind: 'piece', piece: name, axis: axisBetween(a, b)};
  });
}

/** Splits only the edge itself; a seam along it keeps the first part. */
function splitOne(document: GarmentDocument, at: EdgeOfPiece, share: number): Edited {
  const piece = document.pieces[at.piece];
  const edge = piece?.outline[at.edge];
  if (!piece || !edge) return unchanged(document);
  const moved = (other: EdgeOfPiece): EdgeOfPiece =>
    other.piece === at.piece && other.edge > at.edge ? {...other, edge: other.edge + 1} : other;
  const notches = piece.notches?.map((notch) => {
    if (notch.edge !== at.edge) return {...notch, edge: moved({...at, edge: notch.edge}).edge};
    return notch.at < share
      ? {...notch, at: notch.at / share}
      : {...notch, edge: at.edge + 1, at: (notch.at - share) / (1 - share)};
  });
  const outline = piece.outline.flatMap((one, k) =>
    k === at.edge ? splitCurve(one, share) : [one],
  );
  return {
    document: {
      ...inPiece(document, at.piece, () => ({...piece, outline, ...(notches && {notches})})),
      seams: document.seams.map((seam) => ({...seam, a: moved(seam.a), b: moved(seam.b)})),
      symmetries: withoutSplit(document.symmetries, piece, at.edge),
    },
    edgesOf: (other) => (sameEdge(other, at) ? [at, {...at, edge: at.edge + 1}] : [moved(other)]),
    seamsOf: (seam) => [seam],
  };
}

/**
 * Splits an edge at a share of its length, between 0 and 1. The edge sewn to it is split at the
 * same share, and the seam with them: its second part becomes the last seam.
 */
export function splitEdge(document: GarmentDocument, at: EdgeOfPiece, share: number): Edited {
  const number = seamAt(document, at);
  const seam = number === undefined ? undefined : document.seams[number];
  const first = splitOne(document, at, share);
  if (number === undefined || !seam) return first;
  const {sameDirection} = seam;
  const [twin = at] = first.edgesOf(twinOf(seam, at));
  const both = after(first, (next) => splitOne(next, twin, sameDirection ? share : 1 - share));
  const [near, far] = [both.edgesOf(at), both.edgesOf(twinOf(seam, at))];
  const [far1, far2] = sameDirection ? far : [...far].reverse();
  const [near1, near2] = near;
  if (!near1 || !near2 || !far1 || !far2) return unchanged(document);
  const part = (one: EdgeOfPiece, other: EdgeOfPiece): GarmentSeam =>
    sameEdge(seam.a, at) ? {...seam, a: one, b: other} : {...seam, a: other, b: one};
  const seams = both.document.seams.map((one, k) => (k === number ? part(near1, far1) : one));
  return {
    document: {...both.document, seams: [...seams, part(near2, far2)]},
    edgesOf: both.edgesOf,
    seamsOf: (other) => (other === number ? [number, seams.length] : [other]),
  };
}

/**
 * Two sides to sew to each other. Each side lists its edges in sewing order, each from its start to
 * its end.
 */
export interface Sewn {
  readonly a: readonly EdgeOfPiece[];
  readonly b: readonly EdgeOfPiece[];
  /** The start of one side meets the start of the other; otherwise its end. */
  readonly sameDirection: boolean;
}

/** Ends of edges at most this far apart along a seam coincide. [cm] */
const sameEnd = 0.3;

const lengthIn = (document: GarmentDocument, at: EdgeOfPiece): number => {
  const edge = edgeOf(document, at);
  return edge ? edgeLength(edge) : 0;
};

/** Length of a side. [cm] */
export const sideLength = (document: GarmentDocument, side: readonly EdgeOfPiece[]): number =>
  side.reduce((sum, edge) => sum + lengthIn(document, edge), 0);

/** Joints between the edges of a side, as shares of its length from its start. */
function jointsOf(document: GarmentDocument, side: readonly EdgeOfPiece[]): readonly number[] {
  const whole = sideLength(document, side);
  let along = 0;
  return side.slice(0, -1).map((edge) => (along += lengthIn(document, edge)) / whole);
}

/** Splits a side at shares of its length, except where edges meet already. */
function splitSide(
  start: Edited,
  side: readonly EdgeOfPiece[],
  shares: readonly number[],
): {readonly edited: Edited; readonly parts: readonly EdgeOfPiece[]} {
  const whole = sideLength(start.document, side);
  const met = jointsOf(start.document, side);
  const wanted = shares
    .filter((share) => met.every((other) => Math.abs(other - share) * whole > sameEnd))
    .sort((one, other) => other - one);
  let edited = start;
  let parts = side;
  for (const share of wanted) {
    const joints = [0, ...jointsOf(edited.document, parts), 1];
    const k = joints.findLastIndex((joint) => joint < share);
    const [from = 0, to = 1] = [joints[k], joints[k + 1]];
    const at = parts[k];
    if (!at) continue;
    const next = splitOne(edited.document, at, (share - from) / (to - from));
    parts = parts.flatMap(next.edgesOf);
    edited = after(edited, () => next);
  }
  return {edited, parts};
}

/**
 * Sews two sides. Each side is split where edges of the other meet, at the same shares of its
 * length. Its edges lose the mark `open`.
 */
export function sew(document: GarmentDocument, {a, b, sameDirection}: Sewn): Edited {
  const flipped = (shares: readonly number[]): readonly number[] =>
    sameDirection ? shares : shares.map((share) => 1 - share);
  const first = splitSide(unchanged(document), a, flipped(jointsOf(document, b)));
  const second = splitSide(
    first.edited,
    b.flatMap(first.edited.edgesOf),
    flipped(jointsOf(document, a)),
  );
  const ofA = a.flatMap(second.edited.edgesOf);
  const ofB = sameDirection ? second.parts : [...second.parts].reverse();
  const seams = ofA.flatMap((one, k): GarmentSeam[] => {
    const other = ofB[k];
    return other ? [{a: one, b: other, sameDirection, weight: 1, matched: true}] : [];
  });
  const closed = [...ofA, ...ofB].reduce(
    (next, edge) => setOpen(next, edge, false).document,
    second.edited.document,
  );
  return {...second.edited, document: {...closed, seams: [...closed.seams, ...seams]}};
}

/** Takes a seam apart. The numbers of all later seams decrease by one. */
export const unsew = (document: GarmentDocument, seam: number): Edited => ({
  document: {...document, seams: document.seams.filter((_, k) => k !== seam)},
  edgesOf: (edge) => [edge],
  seamsOf: (other) => (other === seam ? [] : [other > seam ? other - 1 : other]),
});

const inSeam = (document: GarmentDocument, number: number, change: Partial<GarmentSeam>): Edited =>
  unchanged({
    ...document,
    seams: document.seams.map((seam, k) => (k === number ? {...seam, ...change} : seam)),
  });

/** Removes seams, the later first, so that the other indices stay valid. */
export const unsewAll = (document: GarmentDocument, seams: readonly number[]): Edited =>
  [...seams]
    .sort((one, other) => other - one)
    .reduce((done, seam) => after(done, (next) => unsew(next, seam)), unchanged(document));

/** Reverses a seam: the start of one edge meets the other end of its twin. */
export const turnSeam = (document: GarmentDocument, seam: number): Edited =>
  inSeam(document, seam, {sameDirection: !document.seams[seam]?.sameDirection});

const without = <T extends object>(holder: T, name: string): T =>
  Object.fromEntries(Object.entries(holder).filter(([other]) => other !== name)) as T;

/** Sets whether an edge stays open, such as a hem or a neckline. */
export const setOpen = (document: GarmentDocument, at: EdgeOfPiece, open: boolean): Edited =>
  isOpen(edgeOf(document, at)) === open
    ? unchanged(document)
    : unchanged(inEdge(document, at, (edge) => (open ? {...edge, open} : without(edge, 'open'))));

/** Sets the seam allowance of an edge; undefined restores the usual one. */
export const setAllowance = (
  document: GarmentDocument,
  at: EdgeOfPiece,
  allowance: Allowance | undefined,
): Edited =>
  unchanged(
    inEdge(document, at, (edge) => (allowance ? {...edge, allowance} : without(edge, 'allowance'))),
  );

/** Sets the name of a piece for the user. */
export const rename = (document: GarmentDocument, piece: number, label: string): Edited =>
  unchanged(inPiece(document, piece, (one) => ({...one, label})));

/** Removes a piece, its seams, and its symmetries and matches. */
export function removePiece(document: GarmentDocument, number: number): Edited {
  const {pieces, seams, symmetries, matches, names} = document;
  const name = pieces[number]?.name;
  const moved = (edge: EdgeOfPiece): EdgeOfPiece =>
    edge.piece > number ? {...edge, piece: edge.piece - 1} : edge;
  const isKept = ({a, b}: GarmentSeam): boolean => a.piece !== number && b.piece !== number;
  const kept = seams.flatMap((seam, k) => (isKept(seam) ? [k] : []));
  return {
    document: {
      ...document,
      ...(names && name !== undefined && {names: without(names, name)}),
      pieces: pieces.filter((_, k) => k !== number),
      seams: seams.filter(isKept).map((seam) => ({...seam, a: moved(seam.a), b: moved(seam.b)})),
      symmetries: symmetries.filter((one) =>
        one.kind === 'piece' ? one.piece !== name : !one.pieces.includes(name ?? ''),
      ),
      matches: matches.filter(({a, b}) => a.piece !== name && b.piece !== name),
    },
    edgesOf: (edge) => (edge.piece === number ? [] : [moved(edge)]),
    seamsOf: (seam) => (kept.includes(seam) ? [kept.indexOf(seam)] : []),
  };
}
