/** Writes garment documents as seamwise-garment/1 files, in centimetres. */
import {
  unitsInMetre,
  type DraftedEdge,
  type DraftedFold,
  type EdgeOfPiece,
  type FileUnit,
  type GarmentDocument,
  type GarmentPiece,
} from './garment-document.js';
import type {Curvature, PanelEdge, PathCubic, Stitch} from './specification.js';
import type {Point} from '../geometry/vectors.js';
import {fieldOf} from '../base/read.js';

/** Maps a point to the coordinates of the file. */
type Frame = (point: Point) => Point;

/**
 * Coordinates of a piece in the file. A piece shown from its back is mirrored back, because axes
 * and pins of designs refer to these coordinates.
 */
const frameOf =
  ({mirroredFromInput}: Pick<GarmentPiece, 'mirroredFromInput'>): Frame =>
  ([x, y]) => [mirroredFromInput ? 0 - x : x, y];

/** Cubics of a path, from all its points. */
export const cubicsOf = (points: readonly Point[]): readonly PathCubic[] =>
  Array.from({length: (points.length - 1) / 3}, (_, k) => {
    const end = 3 * k + 4;
    const cubic = points.slice(end - 3, end === points.length ? end - 1 : end);
    return cubic as [Point, Point] | [Point, Point, Point]; // the slice has two or three points
  });

function curvatureOf({points, radius, sweep}: DraftedEdge, turn: 1 | -1): Curvature | undefined {
  if (radius !== undefined && sweep !== undefined) {
    const isLong = Math.abs(sweep) > Math.PI;
    return {type: 'circle', params: [radius, isLong ? 1 : 0, turn * sweep > 0 ? 1 : 0]};
  }
  const [, first, second] = points;
  if (points.length > 4) return {type: 'path', params: cubicsOf(points)};
  if (points.length === 4 && second) return {type: 'cubic', params: [first, second]};
  return points.length === 3 ? {type: 'quadratic', params: [first]} : undefined;
}

/** Edges of a closed loop; its vertices are appended to `vertices`. */
function loopOf(
  loop: readonly DraftedEdge[],
  {
    frame,
    turn,
    vertices,
  }: {readonly frame: Frame; readonly turn: 1 | -1; readonly vertices: Point[]},
): readonly PanelEdge[] {
  const first = vertices.length;
  return loop.map((edge, k) => {
    const points = edge.points.map(frame) as [Point, Point, ...Point[]]; // the same number
    vertices.push(points[0]);
    const curvature = curvatureOf({...edge, points}, turn);
    return {
      endpoints: [first + k, first + ((k + 1) % loop.length)],
      ...(curvature && {curvature}),
      ...(edge.label !== undefined && {label: edge.label}),
      ...(edge.allowance && {allowance: edge.allowance}),
      ...(edge.open && {open: true}),
      ...edge.more,
    };
  });
}

/** Rotation of a placement for a panel whose x axis is reversed. */
const turnedOver = ([x, y, z]: readonly [number, number, number]): readonly number[] => [
  0 - x,
  y - 180,
  z,
];

/** An object with one member; empty if the value is missing or an empty list. */
const member = (name: string, value: unknown): Readonly<Record<string, unknown>> =>
  value === undefined || (Array.isArray(value) && value.length === 0) ? {} : {[name]: value};

/** Drafted shape of a piece, and its placement. */
interface PanelShape {
  readonly translation?: readonly number[];
  readonly rotation?: readonly number[];
  readonly vertices: readonly Point[];
  readonly edges: readonly PanelEdge[];
  readonly holes?: readonly (readonly PanelEdge[])[];
}

/** Shape of a piece in the coordinates of its panel. */
export function shapeOf(piece: GarmentPiece): PanelShape {
  const {mirroredFromInput, outline, holes, placement} = piece;
  const vertices: Point[] = [];
  const frame = frameOf(piece);
  const file = {frame, turn: mirroredFromInput ? -1 : 1, vertices} as const;
  const edges = loopOf(outline, file);
  const cutOuts = holes.map((hole) => loopOf(hole, file));
  return {
    ...(placement && {
      translation: placement.translation,
      ...member(
        'rotation',
        mirroredFromInput ? turnedOver(placement.rotation ?? [0, 0, 0]) : placement.rotation,
      ),
    }),
    vertices,
    edges,
    ...member('holes', cutOuts),
  };
}

const foldOf =
  (frame: Frame) =>
  ({line, to, kind, more}: DraftedFold): object => ({
    line: line.map(frame),
    ...member('to', to?.map(frame)),
    kind,
    ...more,
  });

function panelOf(piece: GarmentPiece): object {
  const {internalLines, cutLine, sewLine, grain} = piece;
  const frame = frameOf(piece);
  return {
    ...shapeOf(piece),
    ...member('label', piece.label),
    ...member('grain', grain && {...grain, ...member('line', grain.line?.map(frame))}),
    ...member(
      'grains',
      piece.grains?.map(({name, line, angleDeg, more}) => ({
        ...member('name', name),
        ...member('line', line?.map(frame)),
        ...member('angleDeg', angleDeg),
        ...more,
      })),
    ),
    ...member(
      'internalLines',
      internalLines.map((line) => line.map(frame)),
    ),
    ...member('cutLine', cutLine?.map(frame)),
    ...member('sewLine', sewLine?.map(frame)),
    ...member('drillHoles', piece.drillHoles?.map(frame)),
    ...member('folds', piece.folds?.map(foldOf(frame))),
    ...member('notches', piece.notches),
    ...member('quantity', piece.quantity),
    ...member('size', piece.size),
    ...member('material', piece.material),
    ...piece.more,
  };
}

/**
 * JSON text of an object. Members keep their order whatever their names, unlike those of a
 * JavaScript object.
 */
export const objectText = (members: readonly (readonly [name: string, text: string])[]): string =>
  `{${members.map(([name, text]) => `\n${JSON.stringify(name)}: ${text}`).join(',')}}`;

export function stitchesOf({pieces, seams}: Pick<GarmentDocument, 'pieces' | 'seams'>): Stitch[] {
  const end = ({piece, edge}: EdgeOfPiece) => ({panel: pieces[piece]?.name ?? '', edge});
  return seams.map(({a, b, sameDirection}) =>
    sameDirection ? [end(a), end(b), 'right_wrong'] : [end(a), end(b)],
  );
}

/**
 * Text of a file that reads as this document, except for the last digits of values that are not in
 * centimetres.
 */
export function garmentFile(document: GarmentDocument): string {
  const {pieces, seams, matches, symmetries, morePattern = {}, moreProperties} = document;
  const frames = new Map(pieces.map((piece) => [piece.name, frameOf(piece)]));
  const drawn = (piece: string, line: readonly Point[]): readonly Point[] =>
    line.map(frames.get(piece) ?? ((point) => point));
  const described = seams.map(({weight, matched, name, lengthRatio, suggested, more}, stitch) => ({
    ...{stitch, weight, matched},
    ...member('name', name),
    ...member('lengthRatio', lengthRatio),
    ...member('suggested', suggested),
    ...more,
  }));
  const side = ({piece, line}: (typeof matches)[number]['a']) => ({
    piece,
    line: drawn(piece, line),
  });
  const top = {
    ...member('title', document.title),
    ...member('size', document.size),
    ...member('names', document.names),
    properties: {...moreProperties, units_in_meter: 100, curvature_coords: 'absolute'},
    ...member('seams', described),
    ...member(
      'matches',
      matches.map(({a, b, more: others, ...match}) => ({
        a: side(a),
        b: side(b),
        ...match,
        ...others,
      })),
    ),
    ...member(
      'symmetries',
      symmetries.map((one) =>
        one.kind === 'piece' && one.axis ? {...one, axis: drawn(one.piece, one.axis)} : one,
      ),
    ),
    ...document.more,
  };
  const texts = (object: object) =>
    Object.entries(object).map(([name, value]) => [name, JSON.stringify(value)] as const);
  const panels = objectText(pieces.map((piece) => [piece.name, JSON.stringify(panelOf(piece))]));
  return `${objectText([
    ['format', '"seamwise-garment/1"'],
    [
      'pattern',
      objectText([
        ['panels', panels],
        ['stitches', JSON.stringify(stitchesOf(document))],
        ...texts(morePattern),
      ]),
    ],
    ...texts(top),
  ])}\n`;
}

/** The same file with its numbers taken in another unit. @param text of a readable file */
export function inUnit(text: string, unit: FileUnit): string {
  const garment = JSON.parse(text) as object;
  const stated = fieldOf(garment, 'properties');
  const properties = {...(stated as object | undefined), units_in_meter: unitsInMetre[unit]};
  return JSON.stringify({...garment, properties});
}
