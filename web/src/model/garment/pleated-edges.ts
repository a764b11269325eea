/**
 * Edges that end at the lines of pleats. Only the parts between pleats are sewn, so a seam counts
 * the length of a pleated edge with its pleats closed. Lengths in cm.
 */
import {after, edgeOf, sameEdge, sew, splitEdge, unchanged, unsew, type Edited} from './edits.js';
import {edgeLength, edgeLine, exactSteps} from './edge-curve.js';
import {hidesFabric} from './folds.js';
import type {
  DraftedEdge,
  EdgeOfPiece,
  GarmentDocument,
  GarmentPiece,
  GarmentSeam,
} from './garment-document.js';
import {nearestOn} from '../geometry/nearest.js';
import {lengthOf} from '../geometry/polyline.js';
import type {Point} from '../geometry/vectors.js';

/** Distance within which the end of a fold line is on the outline, or at a corner of it. */
const reach = 0.2;
const atCorner = 0.05;

/** The fabric of a pleat along an edge, as shares of the edge's length. */
interface HiddenPart {
  /** Number of the edge. */
  readonly edge: number;
  readonly from: number;
  readonly to: number;
}

/** The same on an edge of a garment. */
interface Hidden extends Pick<HiddenPart, 'from' | 'to'> {
  readonly edge: EdgeOfPiece;
}

/** The position on an edge that is nearest to a point, as a share of its length, and how far. */
function placeOn(edge: DraftedEdge, point: Point): {readonly share: number; readonly off: number} {
  const line = edgeLine(edge, exactSteps);
  const {at, off, step} = nearestOn(line, point, false);
  const whole = lengthOf(line);
  const along = lengthOf([...line.slice(0, step + 1), at]);
  return {share: whole > 0 ? along / whole : 0, off};
}

/** Position along an outline, and the length of its edges; undefined for a point inside. */
function alongOutline(outline: readonly DraftedEdge[], point: Point): number | undefined {
  let before = 0;
  let best = {at: 0, off: reach};
  for (const edge of outline) {
    const length = edgeLength(edge);
    const {share, off} = placeOn(edge, point);
    if (off < best.off) best = {at: before + share * length, off};
    before += length;
  }
  return best.off < reach ? best.at : undefined;
}

/** Stretches of an outline between two positions, the shorter way round. */
function stretches(one: number, other: number, whole: number): (readonly [number, number])[] {
  const [low, high] = one < other ? [one, other] : [other, one];
  if (high - low <= whole / 2) return [[low, high]];
  return [
    [high, whole],
    [0, low],
  ];
}

/** The fabric of all pleats of a piece along its edges. */
export function hiddenParts({
  outline,
  folds = [],
}: Pick<GarmentPiece, 'outline' | 'folds'>): readonly HiddenPart[] {
  const pleats = folds.filter(hidesFabric);
  if (pleats.length === 0) return [];
  const lengths = outline.map(edgeLength);
  const whole = lengths.reduce((sum, length) => sum + length, 0);
  return pleats.flatMap(({line, to}) =>
    [0, 1].flatMap((end) => {
      const [a, b] = [line[end], to?.[end]].map((p) => p && alongOutline(outline, p));
      if (a === undefined || b === undefined) return [];
      let before = 0;
      return lengths.flatMap((length, edge) => {
        const start = before;
        before += length;
        return stretches(a, b, whole).flatMap(([low, high]): HiddenPart[] => {
          const [from, until] = [Math.max(low, start) - start, Math.min(high, before) - start];
          return until - from < atCorner ? [] : [{edge, from: from / length, to: until / length}];
        });
      });
    }),
  );
}

/** Shares at which an edge is divided: the ends of its hidden parts, except its own ends. */
function cutsOf(document: GarmentDocument, edge: EdgeOfPiece, hidden: readonly Hidden[]): number[] {
  const drafted = edgeOf(document, edge);
  const corner = atCorner / (drafted ? edgeLength(drafted) : 1);
  const shares = hidden
    .filter((one) => sameEdge(one.edge, edge))
    .flatMap(({from, to}) => [from, to])
    .filter((share) => share > corner && share < 1 - corner);
  return [...new Set(shares)].sort((a, b) => a - b);
}

/** Divides an edge that is not sewn at shares of its length, in ascending order. */
function dividedAt(start: Edited, edge: EdgeOfPiece, cuts: readonly number[]): Edited {
  let before = 0;
  return cuts.reduce((edited, cut) => {
    const last = edited.edgesOf(edge).at(-1);
    const share = (cut - before) / (1 - before);
    before = cut;
    return last ? after(edited, (next) => splitEdge(next, last, share)) : edited;
  }, start);
}

/**
 * Divides the edges that run across pleats where the lines of the pleats meet them. A seam of such
 * an edge is sewn anew along the parts between the pleats, at equal shares of the lengths with the
 * pleats closed.
 */
export function divideAtFolds(document: GarmentDocument): Edited {
  const hidden = document.pieces.flatMap((panel, piece) =>
    hiddenParts(panel).map(({edge, ...part}): Hidden => ({edge: {piece, edge}, ...part})),
  );
  if (hidden.length === 0) return unchanged(document);
  const isHidden = (edge: EdgeOfPiece): boolean => hidden.some((one) => sameEdge(one.edge, edge));
  const isWhole = (edge: EdgeOfPiece): boolean =>
    isHidden(edge) && cutsOf(document, edge, hidden).length === 0;
  const crossed = document.seams.flatMap((seam, number) => {
    const sides = [seam.a, seam.b];
    return sides.some(isHidden) && !sides.some(isWhole) ? [{seam, number}] : [];
  });
  const apart = [...crossed]
    .reverse()
    .reduce(
      (edited, {number}) => after(edited, (next) => unsew(next, number)),
      unchanged(document),
    );
  const edges = hidden
    .map(({edge}) => edge)
    .filter((edge, k, all) => all.findIndex((one) => sameEdge(one, edge)) === k);
  const divided = edges.reduce(
    (edited, edge) => dividedAt(edited, edge, cutsOf(document, edge, hidden)),
    apart,
  );
  /** The parts of an edge between pleats, by their middles. */
  const visible = (edge: EdgeOfPiece): readonly EdgeOfPiece[] => {
    const bounds = [0, ...cutsOf(document, edge, hidden), 1];
    return divided.edgesOf(edge).filter((_, k) => {
      const centre = ((bounds[k] ?? 0) + (bounds[k + 1] ?? 1)) / 2;
      return !hidden.some(
        (one) => sameEdge(one.edge, edge) && centre > one.from && centre < one.to,
      );
    });
  };
  const parts = new Map<number, readonly number[]>();
  const sewn = crossed.reduce((edited, {seam, number}) => {
    const first = edited.document.seams.length;
    const [a = [], b = []] = [seam.a, seam.b].map((edge) => visible(edge).flatMap(edited.edgesOf));
    const {sameDirection} = seam;
    const next = after(edited, (before) => sew(before, {a, b, sameDirection}));
    const seams = next.document.seams.map((one, k) => (k < first ? one : likeSeam(seam, one)));
    parts.set(
      number,
      seams.slice(first).map((_, k) => first + k),
    );
    return {...next, document: {...next.document, seams}};
  }, unchanged(divided.document));
  const all = after(divided, () => sewn);
  return {...all, seamsOf: (seam) => parts.get(seam) ?? all.seamsOf(seam)};
}

/** A part of a seam that is sewn anew; its lengths are no longer those that the file states. */
function likeSeam(seam: GarmentSeam, {a, b, sameDirection}: GarmentSeam): GarmentSeam {
  const {weight, matched, name, suggested, more} = seam;
  return {
    ...{a, b, sameDirection, weight, matched},
    ...(name !== undefined && {name}),
    ...(suggested && {suggested}),
    ...(more && {more}),
  };
}
