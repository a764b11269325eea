/** Garments as plain GarmentCode specifications, for programs that read no other format. */
import type {
  DraftedEdge,
  EdgeOfPiece,
  GarmentDocument,
  GarmentPiece,
  GarmentSeam,
} from './garment-document.js';
import {cubicsOf, objectText, shapeOf, stitchesOf} from './write-garment.js';
import type {Curvature, PanelEdge} from './specification.js';
import {cross, dot, minus, type Point} from '../geometry/vectors.js';
import {edgeLength, splitCurve} from './edge-curve.js';

/** A control point relative to an edge: along it and to its left, in lengths of the edge. */
function relative(point: Point, [from, to]: readonly [Point, Point]): Point {
  const [way, p] = [minus(to, from), minus(point, from)];
  const square = dot(way, way);
  return [dot(way, p) / square, cross(way, p) / square];
}

function relativeCurvature(curvature: Curvature, ends: readonly [Point, Point]): Curvature {
  if (!('type' in curvature)) return relative(curvature, ends);
  if (curvature.type === 'quadratic') {
    return {type: 'quadratic', params: [relative(curvature.params[0], ends)]};
  }
  if (curvature.type !== 'cubic') return curvature;
  const [first, second] = curvature.params;
  return {type: 'cubic', params: [relative(first, ends), relative(second, ends)]};
}

function plainEdge(edge: PanelEdge, vertices: readonly Point[]): PanelEdge {
  const {endpoints, curvature, label} = edge;
  const [from = [0, 0], to = from] = endpoints.map((k) => vertices[k]);
  return {
    endpoints,
    ...(curvature && {curvature: relativeCurvature(curvature, [from, to])}),
    ...(label !== undefined && {label}),
  };
}

/**
 * The text of a GarmentCode specification, in centimetres: panels, placements and stitches. Paths
 * are split into single cubics, together with both sides of their seams. Data that the format
 * cannot express is omitted, such as cut-outs, grain lines and marks.
 */
export function plainGarment(document: GarmentDocument): string {
  const single = singleCurves(document);
  const panels = single.pieces.map((piece): readonly [string, string] => {
    const {vertices, edges, translation, rotation} = shapeOf({...piece, holes: []});
    const panel = {
      translation: translation ?? [0, 0, 0],
      rotation: rotation ?? [0, 0, 0],
      vertices,
      edges: edges.map((edge) => plainEdge(edge, vertices)),
      ...(piece.label !== undefined && {label: piece.label}),
    };
    return [piece.name, JSON.stringify(panel)];
  });
  const properties = {
    curvature_coords: 'relative',
    normalize_panel_translation: false,
    normalized_edge_loops: false,
    units_in_meter: 100,
  };
  const pattern = objectText([
    ['panels', objectText(panels)],
    ['stitches', JSON.stringify(stitchesOf(single))],
    ['panel_order', JSON.stringify(single.pieces.map(({name}) => name))],
  ]);
  return `${objectText([
    ['pattern', pattern],
    ['parameters', '{}'],
    ['parameter_order', '[]'],
    ['properties', JSON.stringify(properties)],
  ])}\n`;
}

// Garments without paths: the cubics of a chain are separate edges, and its seam becomes one seam
// per cubic. Lengths in cm.

/** Shorter cubics are dropped; the neighbour then begins where they began. [cm] */
const sliver = 0.004;
/** Cuts on the two sides of a seam coincide within this distance. [cm] */
const sameCut = 0.0015;
/** A share this close to a joint of curves means the joint. */
const joint = 1e-9;

/** An edge as single curves, with the shares of its length at which they begin, and 1. */
interface Chain {
  readonly curves: readonly DraftedEdge[];
  readonly starts: readonly number[];
  readonly length: number;
}

function chainOf(edge: DraftedEdge): Chain {
  const curves = singles(edge);
  const lengths = curves.map(edgeLength);
  const length = lengths.reduce((sum, one) => sum + one, 0);
  let passed = 0;
  const starts = lengths.map((one) => (passed += one) / length);
  return {curves, starts: [0, ...starts.slice(0, -1), 1], length};
}

/** The cubics of a path; any other edge is returned unchanged. */
function singles(edge: DraftedEdge): readonly DraftedEdge[] {
  if (edge.points.length <= 4) return [edge];
  const [start] = edge.points;
  const end = edge.points.at(-1) ?? start;
  const kept: (readonly [Point, Point, Point])[] = [];
  let from = start;
  for (const [first, second, to = end] of cubicsOf(edge.points)) {
    if (edgeLength({points: [from, first, second, to]}) < sliver) continue;
    kept.push([first, second, to]);
    from = to;
  }
  if (kept.length === 0) return [{...edge, points: [start, end]}];
  return kept.map(([first, second, to], k) => ({
    ...edge,
    points: [kept[k - 1]?.[2] ?? start, first, second, k + 1 < kept.length ? to : end],
  }));
}

/** A cut of both sides of a seam, in the seam's order, as shares of each side's length. */
type Cut = readonly [a: number, b: number];

/** All cuts of either side. A cut that both sides have is not made twice. */
function cutsOf(a: readonly number[], b: readonly number[], length: number): readonly Cut[] {
  const cuts: Cut[] = [];
  let [i, j] = [0, 0];
  while (i < a.length || j < b.length) {
    const [one, other] = [a[i] ?? Infinity, b[j] ?? Infinity];
    if (Math.abs(one - other) * length <= sameCut) {
      cuts.push([one, other]);
      i++;
      j++;
    } else {
      const share = Math.min(one, other);
      cuts.push([share, share]);
      if (one < other) i++;
      else j++;
    }
  }
  return cuts;
}

/** Parts of an edge, cut where its curves meet and at these ascending shares of its length. */
function partsOf({curves, starts}: Chain, shares: readonly number[]): readonly DraftedEdge[] {
  return curves.flatMap((curve, k) => {
    const [from = 0, to = 1] = [starts[k], starts[k + 1]];
    const within = shares.filter((share) => share > from + joint && share < to - joint);
    const parts: DraftedEdge[] = [];
    let [rest, begin] = [curve, from];
    for (const share of within) {
      const [part, more] = splitCurve(rest, (share - begin) / (to - begin));
      parts.push(part);
      [rest, begin] = [more, share];
    }
    return [...parts, rest];
  });
}

const inner = ({starts}: Chain): readonly number[] => starts.slice(1, -1);
const turned = (shares: readonly number[]): readonly number[] =>
  shares.map((share) => 1 - share).reverse();

/** Parts of every edge, by piece and edge. */
function partsOfEdges({pieces, seams}: GarmentDocument): readonly (readonly DraftedEdge[])[][] {
  const chains = pieces.map(({outline}) => outline.map(chainOf));
  const parts = chains.map((edges) => edges.map((chain) => partsOf(chain, [])));
  for (const {a, b, sameDirection} of seams) {
    const [one, other] = [chains[a.piece]?.[a.edge], chains[b.piece]?.[b.edge]];
    if (!one || !other || one.curves.length + other.curves.length === 2) continue;
    const inOrder = sameDirection ? inner(other) : turned(inner(other));
    const cuts = cutsOf(inner(one), inOrder, Math.min(one.length, other.length));
    const ends = cuts.map((cut) => cut[1]);
    put(
      parts,
      a,
      partsOf(
        one,
        cuts.map((cut) => cut[0]),
      ),
    );
    put(parts, b, partsOf(other, sameDirection ? ends : turned(ends)));
  }
  return parts;
}

function put<T>(rows: T[][], {piece, edge}: EdgeOfPiece, value: T): void {
  const row = rows[piece];
  if (row) row[edge] = value;
}

/**
 * The same outlines and seams with every path split into its cubics. Both sides of a seam are split
 * at the same shares of their lengths, so a seam becomes several. Only edges and their numbers in
 * pieces and seams are updated: notches and symmetries by edges are not.
 */
function singleCurves(document: GarmentDocument): GarmentDocument {
  const parts = partsOfEdges(document);
  const firsts = parts.map((edges) => {
    let count = 0;
    return edges.map((those) => (count += those.length) - those.length);
  });
  const at = ({piece, edge}: EdgeOfPiece, part: number): EdgeOfPiece => ({
    piece,
    edge: (firsts[piece]?.[edge] ?? 0) + part,
  });
  const seams = document.seams.flatMap((seam): readonly GarmentSeam[] => {
    const count = parts[seam.a.piece]?.[seam.a.edge]?.length ?? 0;
    return Array.from({length: count}, (_, k) => ({
      ...seam,
      a: at(seam.a, k),
      b: at(seam.b, seam.sameDirection ? k : count - 1 - k),
    }));
  });
  const pieces = document.pieces.map((piece, p): GarmentPiece => ({
    ...piece,
    outline: (parts[p] ?? []).flat(),
  }));
  return {...document, pieces, seams};
}
