/** Garments as plain GarmentCode specifications, for programs that read no other format. */
import type {GarmentDocument} from './garment-document.js';
import {objectText, shapeOf, stitchesOf} from './write-garment.js';
import type {Curvature, PanelEdge} from './specification.js';
import {cross, dot, minus, type Point} from '../geometry/vectors.js';
import {singleCurves} from './single-curves.js';

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
