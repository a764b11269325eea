/** The cutting sheet of a drafted garment, for plain fabric. Lengths in cm. */
import type {
  DraftedEdge,
  GarmentDocument,
  GarmentPiece,
} from '../model/garment/garment-document.js';
import {garmentTitle, panelMarks} from '../model/garment/panel-marks.js';
import {combined, norm, plus, type Point} from '../model/geometry/vectors.js';
import {edgeLine} from '../model/garment/edge-curve.js';
import {lengthOf} from '../model/geometry/polyline.js';
import type {Pattern, ResultPiece, ResultSeam} from '../model/result/result.js';
import type {CutSheet} from './cut-sheet.js';
import {cutSheet, type SheetOptions} from './lay-sheet.js';

/** Greatest distance of polylines from their curves. */
const tolerance = 0.001;
/** Least and greatest number of segments of a curve. */
const leastSteps = 4;
const greatestSteps = 400;

/** The number of segments of each curve of an edge. */
function stepsOf({points, sweep, radius}: DraftedEdge): number {
  const bends = points.slice(2).map((c, k) => {
    const [a = c, b = c] = points.slice(k, k + 2);
    return norm(plus(combined([a, b], 1, -2), c));
  });
  // second differences bound the distance of a Bezier curve from its chord; for an arc, its angle
  // does
  const steps =
    sweep === undefined
      ? Math.sqrt((0.75 * Math.max(0, ...bends)) / tolerance)
      : Math.abs(sweep) / Math.sqrt((8 * tolerance) / Math.max(radius ?? 1, tolerance)) / 2;
  return Math.min(greatestSteps, Math.max(leastSteps, Math.ceil(steps)));
}

interface Vertices {
  readonly points: Point[];
  /** For each edge, its vertices from start to end. */
  readonly edges: readonly (readonly number[])[];
}

/** The vertices of a closed line, which are appended to `points`. */
function loopOf(loop: readonly DraftedEdge[], points: Point[]): Vertices['edges'] {
  const first = points.length;
  const starts = loop.map((edge) => {
    const start = points.length;
    points.push(...edgeLine(edge, stepsOf(edge)).slice(0, -1));
    return start;
  });
  return loop.map((_, k) => {
    const start = starts[k] ?? first;
    const next = starts[k + 1] ?? points.length;
    const inner = Array.from({length: next - start}, (__, n) => start + n);
    return [...inner, k + 1 < loop.length ? next : first];
  });
}

/** A piece as the solver represents it before meshing: as drafted, without a place on a print. */
function pieceOf({name, outline, holes, mirroredFromInput}: GarmentPiece): {
  readonly piece: ResultPiece;
  readonly edges: Vertices['edges'];
} {
  const points: Point[] = [];
  const edges = loopOf(outline, points);
  const holeEdges = holes.map((hole) => loopOf(hole, points));
  const around = (loop: Vertices['edges']): readonly number[] =>
    loop.flatMap((edge) => edge.slice(0, -1));
  return {
    piece: {
      ...{name, mirroredFromInput, rest: points, shape: points, triangles: []},
      ...{outline: around(edges), holes: holeEdges.map(around)},
      alignment: {angle: 0, translation: [0, 0]},
    },
    edges,
  };
}

function draftedPattern({pieces, seams}: GarmentDocument): Omit<Pattern, 'print'> {
  const drafted = pieces.map(pieceOf);
  const side = ({piece, edge}: {readonly piece: number; readonly edge: number}) => ({
    piece,
    vertices: drafted[piece]?.edges[edge] ?? [],
  });
  const lengthAlong = ({piece, vertices}: ReturnType<typeof side>): number =>
    lengthOf(vertices.flatMap((v) => drafted[piece]?.piece.shape.slice(v, v + 1) ?? []));
  return {
    pieces: drafted.map(({piece}) => piece),
    symmetries: [],
    seams: seams.map(({a, b, sameDirection, weight}): ResultSeam => {
      const [one, two] = [side(a), side(b)];
      const sewn = sameDirection ? two : {...two, vertices: [...two.vertices].reverse()};
      return {
        ...{a: one, b: sewn, weight, matched: false, kind: 'continuous', mismatch: []},
        lengthRatio: lengthAlong(one) / (lengthAlong(two) || 1),
      };
    }),
  };
}

/**
 * The cutting sheet.
 * @param file the garment's name if it has no title
 */
export const draftedSheet = (
  garment: GarmentDocument,
  options: Omit<SheetOptions, 'plain'>,
  file?: string,
): CutSheet =>
  cutSheet(
    draftedPattern(garment),
    undefined,
    {...garmentTitle(garment, file), panels: panelMarks(garment)},
    options,
  );
