/**
 * Points inside a piece that show the same point of the print, for aligning paper with printed
 * fabric. Lengths in cm.
 */
import {
  combined,
  coordinates,
  distance,
  minus,
  norm,
  onPiece,
  onPrint,
  plus,
  type Alignment,
  type Point,
} from '../model/geometry/vectors.js';
import {boxOf, distanceTo, isInside} from '../model/geometry/polyline.js';
import type {Print} from '../model/print/repeating-print.js';

/** Least distance of marks from the sewn outline. */
const margin = 1.5;
/** Shorter repeats are combined to multiples. */
const least = 1;
/** Candidate points per side of the repeat. */
const parts = 6;
/** Sufficient distance between three marks, as a share of the piece's diagonal. */
const enough = 0.3;

type Lattice = Pick<Print, 'w1' | 'w2'>;

const several = (side: Point): Point => plus(side, side, Math.ceil(least / norm(side)) - 1);

/** All points of the piece, clear of its lines, that show the point `motif` of the print. */
function placesOf(
  motif: Point,
  basis: readonly [Point, Point],
  alignment: Alignment,
  loops: readonly (readonly Point[])[],
): readonly Point[] {
  const [outline = []] = loops;
  // the extent of the piece, in whole repeats from the motif
  const shares = outline.map((p) => coordinates(basis, minus(onPrint(alignment, p), motif)));
  const range = (axis: 0 | 1): number[] => {
    const values = shares.map((share) => share[axis]);
    const low = Math.ceil(Math.min(...values));
    return Array.from({length: Math.floor(Math.max(...values)) - low + 1}, (_, k) => low + k);
  };
  return range(0)
    .flatMap((i) => range(1).map((j) => onPiece(alignment, plus(motif, combined(basis, i, j)))))
    .filter((p) => loops.every((loop, k) => isInside(loop, p) === (k === 0)))
    .filter((p) => loops.every((loop) => distanceTo(loop, p) >= margin));
}

/** Up to three of the points, each as far as possible from those before it. */
function farApart(places: readonly Point[]): readonly Point[] {
  const [first] = places;
  if (!first) return [];
  const furthest = (from: readonly Point[]): Point =>
    places.reduce((best, p) => {
      const off = (q: Point): number => Math.min(...from.map((r) => distance(q, r)));
      return off(p) > off(best) ? p : best;
    }, first);
  const one = furthest([first]);
  const two = furthest([one]);
  return [...new Set([one, two, furthest([one, two])])];
}

/** The least distance between two points. */
const spread = (marks: readonly Point[]): number =>
  marks.length < 2
    ? 0
    : Math.min(...marks.flatMap((p, k) => marks.slice(k + 1).map((q) => distance(p, q))));

function diagonal(points: readonly Point[]): number {
  const {low, high} = boxOf(points);
  return distance(low, high);
}

/**
 * Up to three points of the piece that are whole repeats of the print apart. They show the print's
 * origin, the middle of a motif, if at least two fit well; otherwise the best other point of the
 * print.
 * @param loops outline and holes of the shape
 */
export function matchMarks(
  {w1, w2}: Lattice,
  alignment: Alignment,
  loops: readonly (readonly Point[])[],
): readonly Point[] {
  const basis = [several(w1), several(w2)] as const;
  const wide = enough * diagonal(loops[0] ?? []);
  let best: readonly Point[] = [];
  for (let k = 0; k < parts * parts; k++) {
    const motif = combined([w1, w2], Math.floor(k / parts) / parts, (k % parts) / parts);
    const marks = farApart(placesOf(motif, basis, alignment, loops));
    if (marks.length >= (k === 0 ? 2 : 3) && spread(marks) >= wide) return marks;
    if ((marks.length - best.length || spread(marks) - spread(best)) > 0) best = marks;
  }
  return best;
}
