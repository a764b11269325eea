/** Adds, replaces and removes folds of a garment, with the edges that end at them. Lengths in cm. */
import {
  after,
  sameEdge,
  seamAt,
  sew,
  twinOf,
  unchanged,
  unsewAll,
  type Edited,
} from '../model/garment/edits.js';
import {foldLines, hidesFabric, mappedFold} from '../model/garment/folds.js';
import type {DraftedFold, EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import {goesStraightOn, joinNext, nextEdge} from '../model/garment/join-edges.js';
import {divideAtFolds, hiddenParts} from '../model/garment/pleated-edges.js';
import {distance, minus, type MirrorMap, type Point} from '../model/geometry/vectors.js';
import {mirrorImage} from '../scene/marks.js';

/** Ends of lines at most this far apart coincide. */
const sameEnd = 0.1;

const isNear = (one: Point, other: Point): boolean => distance(one, other) < sameEnd;

const isSameLine = ([a, b]: readonly [Point, Point], [c, d]: readonly [Point, Point]): boolean =>
  (isNear(a, c) && isNear(b, d)) || (isNear(a, d) && isNear(b, c));

/** Returns whether two folds have the same lines, in any order. */
export function isSameFold(one: DraftedFold, other: DraftedFold): boolean {
  const [first, second] = [foldLines(one), foldLines(other)];
  return (
    first.length === second.length &&
    first.every((line) => second.some((each) => isSameLine(line, each)))
  );
}

/**
 * The mirror image of a fold.
 * @param map of the face-up piece onto its image
 * @param towards `original`: the fold is on the image
 */
export const foldImage = (
  fold: DraftedFold,
  map: MirrorMap,
  towards: 'image' | 'original' = 'image',
): DraftedFold =>
  mappedFold(fold, (p) =>
    towards === 'image'
      ? mirrorImage(map, p)
      : mirrorImage({...map, translation: [0, 0]}, minus(p, map.translation)),
  );

const withFolds = (
  document: GarmentDocument,
  piece: number,
  change: (folds: readonly DraftedFold[]) => readonly DraftedFold[],
): GarmentDocument => ({
  ...document,
  pieces: document.pieces.map((one, k) =>
    k === piece ? {...one, folds: change(one.folds ?? [])} : one,
  ),
});

/** Returns whether the fabric of a pleat would be hidden twice along an edge. */
export function overlapsPleat(
  {pieces}: GarmentDocument,
  piece: number,
  fold: DraftedFold,
): boolean {
  const drafted = pieces[piece];
  if (!drafted || !hidesFabric(fold)) return false;
  const own = hiddenParts({...drafted, folds: [fold]});
  return hiddenParts(drafted).some((one) =>
    own.some(
      (other) =>
        one.edge === other.edge &&
        Math.min(one.to, other.to) - Math.max(one.from, other.from) > 1e-3,
    ),
  );
}

/** Adds a fold as the last one of its piece. Edges that it crosses end at its lines. */
export const withFold = (document: GarmentDocument, piece: number, fold: DraftedFold): Edited =>
  divideAtFolds(withFolds(document, piece, (folds) => [...folds, fold]));

/** Corners of an outline at the ends of a fold, each as the edge that ends there. */
function cornersAt(document: GarmentDocument, piece: number, fold: DraftedFold): EdgeOfPiece[] {
  const {outline = [], folds = []} = document.pieces[piece] ?? {};
  const endsOf = (one: DraftedFold): readonly Point[] =>
    hidesFabric(one) ? foldLines(one).flat() : [];
  const others = folds.flatMap(endsOf);
  return outline.flatMap(({points}, edge) => {
    const corner = points.at(-1) ?? points[0];
    const at = {piece, edge};
    const isOwn = endsOf(fold).some((end) => isNear(end, corner));
    const isOther = others.some((end) => isNear(end, corner));
    return isOwn && !isOther && goesStraightOn(document, at) ? [at] : [];
  });
}

/** Runs of edges that follow each other at these corners. */
function runsAt(document: GarmentDocument, corners: readonly EdgeOfPiece[]): EdgeOfPiece[][] {
  const ends = (edge: EdgeOfPiece): boolean => corners.some((one) => sameEdge(one, edge));
  const starts = corners.filter(
    (corner) => !corners.some((one) => sameEdge(nextEdge(document, one), corner)),
  );
  return starts.map((start) => {
    const run = [start];
    for (let edge = start; ends(edge);) {
      edge = nextEdge(document, edge);
      run.push(edge);
    }
    return run;
  });
}

/** Joins edges that follow each other. */
const joinRun = (start: Edited, run: readonly EdgeOfPiece[]): Edited =>
  run.slice(1).reduce((edited) => {
    const [first] = run.flatMap(edited.edgesOf);
    return first ? after(edited, (next) => joinNext(next, first)) : edited;
  }, start);

/** Sorts edges so that each follows the one before on their piece; undefined if none do. */
function inRow(
  document: GarmentDocument,
  edges: readonly EdgeOfPiece[],
): readonly EdgeOfPiece[] | undefined {
  const follows = (one: EdgeOfPiece, other: EdgeOfPiece): boolean =>
    sameEdge(nextEdge(document, one), other) && goesStraightOn(document, one);
  const [start, ...more] = edges.filter((edge) => !edges.some((one) => follows(one, edge)));
  if (!start || more.length > 0) return undefined;
  const row = [start];
  for (let last = start; row.length < edges.length;) {
    const next = edges.find((edge) => follows(last, edge));
    if (!next) return undefined;
    row.push((last = next));
  }
  return row;
}

/** Joins the edges of a run, and the edges sewn to them, which are sewn as a whole then. */
function rejoined(start: Edited, given: readonly EdgeOfPiece[]): Edited {
  const {document} = start;
  const run = given.flatMap(start.edgesOf);
  const seams = run.flatMap((edge) => seamAt(document, edge) ?? []);
  const sewn = seams.flatMap((number) => document.seams[number] ?? []);
  if (sewn.length === 0) return after(start, (next) => joinRun(unchanged(next), run));
  const [first] = sewn;
  const twins = run.flatMap((edge) => {
    const seam = document.seams[seamAt(document, edge) ?? -1];
    return seam ? [twinOf(seam, edge)] : [];
  });
  const row = inRow(document, twins);
  const isAlike = sewn.every((seam) => seam.sameDirection === first?.sameDirection);
  if (!first || !row || !isAlike || new Set(seams).size < seams.length) return start;
  const apart = unsewAll(document, seams);
  const joined = [run, row].reduce((edited, edges) => {
    const now = edges.flatMap(edited.edgesOf);
    return after(edited, (next) => joinRun(unchanged(next), now));
  }, apart);
  const [a, b] = [run[0], row[0]].map((edge) => (edge ? joined.edgesOf(edge) : []));
  if (!a || !b) return start;
  const {sameDirection, weight, matched, name} = first;
  const whole = after(joined, (next) => sew(next, {a, b, sameDirection}));
  const last = whole.document.seams.length - 1;
  const named = {weight, matched, ...(name !== undefined && {name})};
  const all = {
    ...whole,
    document: {
      ...whole.document,
      seams: whole.document.seams.map((seam, k) => (k === last ? {...seam, ...named} : seam)),
    },
    seamsOf: (seam: number) => (seams.includes(seam) ? [last] : whole.seamsOf(seam)),
  };
  return after(start, () => all);
}

/** Removes a fold, and joins the edges that ended at its lines. */
export function withoutFold(document: GarmentDocument, piece: number, number: number): Edited {
  const fold = document.pieces[piece]?.folds?.[number];
  if (!fold) return unchanged(document);
  const without = withFolds(document, piece, (folds) => folds.filter((_, k) => k !== number));
  const runs = runsAt(without, cornersAt(without, piece, fold));
  return runs.reduce(rejoined, unchanged(without));
}

/** Replaces a fold; a fold with other lines becomes the last one of its piece. */
export function replaceFold(
  document: GarmentDocument,
  piece: number,
  number: number,
  fold: DraftedFold,
): Edited {
  const before = document.pieces[piece]?.folds?.[number];
  if (!before) return unchanged(document);
  if (isSameFold(before, fold) && hidesFabric(before) === hidesFabric(fold))
    return unchanged(
      withFolds(document, piece, (folds) => folds.map((one, k) => (k === number ? fold : one))),
    );
  return after(withoutFold(document, piece, number), (next) => withFold(next, piece, fold));
}

/** Number of the fold of a piece with the same lines; -1 without one. */
export const foldLike = ({pieces}: GarmentDocument, piece: number, fold: DraftedFold): number =>
  (pieces[piece]?.folds ?? []).findIndex((one) => isSameFold(one, fold));
