/** Redraws edges as paths: chains of cubics with the same shape. */
import type {DraftedEdge, GarmentDocument} from '@/model/garment/garment-document.js';
import {between, type Point} from '@/model/geometry/vectors.js';

type Cubic = readonly [Point, Point, Point, Point];

/** Splits a cubic at a parameter, by de Casteljau's construction. */
function halves([a, b, c, d]: Cubic, t: number): readonly [Cubic, Cubic] {
  const [ab, bc, cd] = [between(a, b, t), between(b, c, t), between(c, d, t)];
  const [abc, bcd] = [between(ab, bc, t), between(bc, cd, t)];
  const at = between(abc, bcd, t);
  return [
    [a, ab, abc, at],
    [at, bcd, cd, d],
  ];
}

/** A line or a Bezier curve as a cubic. */
function cubicOf({points}: DraftedEdge): Cubic {
  const [a, b, c] = points;
  const end = points.at(-1) ?? a;
  if (points.length === 4 && c) return [a, b, c, end];
  if (points.length === 3) return [a, between(a, b, 2 / 3), between(end, b, 2 / 3), end];
  return [a, between(a, end, 1 / 3), between(a, end, 2 / 3), end];
}

/** An edge as a path of so many cubics; arcs stay arcs. */
function asPath(edge: DraftedEdge, parts: number): DraftedEdge {
  if (edge.radius !== undefined) return edge;
  const points: Point[] = [edge.points[0]];
  let rest = cubicOf(edge);
  for (let left = parts; left > 1; left--) {
    const [first, more] = halves(rest, 1 / left);
    points.push(...first.slice(1));
    rest = more;
  }
  points.push(...rest.slice(1));
  return {...edge, points: points as [Point, Point, ...Point[]]}; // at least four
}

/** A garment whose outlines and cut-outs are paths. */
export const redrawn = (document: GarmentDocument, parts: number): GarmentDocument => ({
  ...document,
  pieces: document.pieces.map((piece) => ({
    ...piece,
    outline: piece.outline.map((edge) => asPath(edge, parts)),
    holes: piece.holes.map((hole) => hole.map((edge) => asPath(edge, parts))),
  })),
});
