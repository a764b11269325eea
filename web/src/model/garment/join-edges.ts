/** Joins edges of an outline that were divided, such as at a pleat. Lengths in cm. */
import {centreOf, edgeLength} from './edge-curve.js';
import type {Edited} from './edits.js';
import type {DraftedEdge, EdgeOfPiece, GarmentDocument, GarmentPiece} from './garment-document.js';
import {arcAround} from '../geometry/arc.js';
import {
  between,
  cross,
  distance,
  dot,
  minus,
  rotated,
  unit,
  type Point,
} from '../geometry/vectors.js';

/** Greatest distance of the joint of two lines from one line. */
const straight = 1e-6;
/** Greatest angle of an arc that one cubic represents. [rad] */
const mostSweep = Math.PI / 8;

/** Control points of the same course in cubics, after the start of the edge. */
function cubicsAlong(edge: DraftedEdge): readonly Point[] {
  const {points, sweep} = edge;
  const [from, first, second] = points;
  const to = points.at(-1) ?? from;
  if (sweep !== undefined) return arcAround(centreOf(edge, sweep), from, sweep, mostSweep).flat();
  if (points.length === 2) return [between(from, to, 1 / 3), between(from, to, 2 / 3), to];
  if (points.length === 3) return [between(from, first, 2 / 3), between(to, first, 2 / 3), to];
  return second ? points.slice(1) : [];
}

/** One edge with the course of two that follow each other. */
function joinedCurve(one: DraftedEdge, other: DraftedEdge): DraftedEdge {
  const {radius, sweep, ...rest} = one;
  const [from, joint] = [one.points[0], other.points[0]];
  const to = other.points.at(-1) ?? joint;
  if (sweep !== undefined && other.sweep !== undefined && radius === other.radius)
    return {...one, points: [from, to], sweep: sweep + other.sweep};
  const isLine = one.points.length + other.points.length === 4 && sweep === other.sweep;
  if (isLine && Math.abs(cross(unit(minus(to, from)), minus(joint, from))) < straight)
    return {...rest, points: [from, to]};
  return {...rest, points: [from, ...cubicsAlong(one), ...cubicsAlong(other)] as never};
}

/** The piece with its edge `at` joined to the next one; `kept` is the number of both afterwards. */
function joinedPiece(piece: GarmentPiece, at: number, next: number, kept: number): GarmentPiece {
  const {outline, notches} = piece;
  const [one, other] = [outline[at], outline[next]];
  if (!one || !other) return piece;
  const [first, second] = [edgeLength(one), edgeLength(other)];
  const removed = at + next - kept;
  const moved = (edge: number): number => (edge > removed ? edge - 1 : edge);
  return {
    ...piece,
    outline: outline
      .map((edge, k) => (k === kept ? joinedCurve(one, other) : edge))
      .filter((_, k) => k !== removed),
    ...(notches && {
      notches: notches.map((notch) => {
        if (notch.edge !== at && notch.edge !== next) return {...notch, edge: moved(notch.edge)};
        const along = notch.edge === at ? notch.at * first : first + notch.at * second;
        return {...notch, edge: kept, at: along / (first + second)};
      }),
    }),
  };
}

/** The edge after another one of its piece. */
export const nextEdge = ({pieces}: GarmentDocument, {piece, edge}: EdgeOfPiece): EdgeOfPiece => ({
  piece,
  edge: (edge + 1) % (pieces[piece]?.outline.length ?? 1),
});

/** Joins an edge to the next one; neither is sewn. */
export function joinNext(document: GarmentDocument, at: EdgeOfPiece): Edited {
  const {piece} = at;
  const next = nextEdge(document, at).edge;
  const [kept, removed] = [Math.min(at.edge, next), Math.max(at.edge, next)];
  const moved = (edge: number): number =>
    edge === removed ? kept : edge > removed ? edge - 1 : edge;
  const ofEdge = (edge: EdgeOfPiece): EdgeOfPiece =>
    edge.piece === piece ? {piece, edge: moved(edge.edge)} : edge;
  const name = document.pieces[piece]?.name;
  return {
    document: {
      ...document,
      pieces: document.pieces.map((one, k) =>
        k === piece ? joinedPiece(one, at.edge, next, kept) : one,
      ),
      seams: document.seams.map((seam) => ({...seam, a: ofEdge(seam.a), b: ofEdge(seam.b)})),
      symmetries: document.symmetries.map((one) =>
        one.kind === 'piece' && one.piece === name && one.seams
          ? {...one, seams: [moved(one.seams[0]), moved(one.seams[1])] as const}
          : one,
      ),
    },
    edgesOf: (edge) => [ofEdge(edge)],
    seamsOf: (seam) => [seam],
  };
}

/** Greatest turn of an outline that goes straight on, as a sine. */
const leastTurn = 0.1;

/** Returns whether the outline goes straight on from an edge to the next one. */
export function goesStraightOn(document: GarmentDocument, at: EdgeOfPiece): boolean {
  const {outline = []} = document.pieces[at.piece] ?? {};
  const [one, other] = [outline[at.edge], outline[nextEdge(document, at).edge]];
  if (!one || !other || one === other) return false;
  const [before, after] = [endWay(one, 'end'), endWay(other, 'start')];
  return Math.abs(cross(before, after)) < leastTurn && dot(before, after) > 0;
}

/** Unit vector along an edge at one of its ends. */
function endWay({points, sweep}: DraftedEdge, at: 'start' | 'end'): Point {
  const last = points.at(-1) ?? points[0];
  if (sweep !== undefined)
    return rotated(unit(minus(last, points[0])), ((at === 'end' ? 1 : -1) * sweep) / 2);
  const line: readonly Point[] = at === 'end' ? [...points].reverse() : points;
  const from = at === 'end' ? last : points[0];
  const beside = line.find((p) => distance(p, from) > straight) ?? from;
  const way = unit(minus(beside, from));
  return at === 'end' ? [0 - way[0], 0 - way[1]] : way;
}
