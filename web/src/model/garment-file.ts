/** Garment documents as seamwise-garment/1 files, in centimetres. */
import type {DraftedEdge, EdgeOfPiece, GarmentDocument, GarmentPiece} from './garment-document.js';
import type {Curvature, PanelEdge, PathCubic, Stitch} from './garment.js';
import type {Point} from './geometry.js';

/** A point as the file has it. */
type Frame = (point: Point) => Point;

/** A piece that the file shows from its back is written so again: designs know axes and pins by these coordinates. */
const frameOf =
  ({mirroredFromInput}: Pick<GarmentPiece, 'mirroredFromInput'>): Frame =>
  ([x, y]) => [mirroredFromInput ? 0 - x : x, y];

/** The cubics of a path, by all its points. */
export const cubicsOf = (points: readonly Point[]): readonly PathCubic[] =>
  Array.from({length: (points.length - 1) / 3}, (_, k) => {
    const end = 3 * k + 4;
    const cubic = points.slice(end - 3, end === points.length ? end - 1 : end);
    return cubic as [Point, Point] | [Point, Point, Point]; // as many as are cut out
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

/** The edges of a closed loop, between vertices that go to the end of `vertices`. */
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
    const points = edge.points.map(frame) as [Point, Point, ...Point[]]; // as many as there were
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

/** What a placement turns the panel by when its x axis is the other way round. */
const turnedOver = ([x, y, z]: readonly [number, number, number]): readonly number[] => [
  0 - x,
  y - 180,
  z,
];

/** A member, unless it is empty or missing. */
const member = (name: string, value: unknown): Readonly<Record<string, unknown>> =>
  value === undefined || (Array.isArray(value) && value.length === 0) ? {} : {[name]: value};

/** What is drafted of a piece, and where it hangs. */
interface PanelShape {
  readonly translation?: readonly number[];
  readonly rotation?: readonly number[];
  readonly vertices: readonly Point[];
  readonly edges: readonly PanelEdge[];
  readonly holes?: readonly (readonly PanelEdge[])[];
}

/** Control points are those of panels. */
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

function panelOf(piece: GarmentPiece): object {
  const {internalLines, cutLine, sewLine, grain} = piece;
  const frame = frameOf(piece);
  return {
    ...shapeOf(piece),
    ...member('label', piece.label),
    ...member('grain', grain && {...grain, ...member('line', grain.line?.map(frame))}),
    ...member(
      'internalLines',
      internalLines.map((line) => line.map(frame)),
    ),
    ...member('cutLine', cutLine?.map(frame)),
    ...member('sewLine', sewLine?.map(frame)),
    ...member('drillHoles', piece.drillHoles?.map(frame)),
    ...member('notches', piece.notches),
    ...member('quantity', piece.quantity),
    ...member('size', piece.size),
    ...member('material', piece.material),
    ...piece.more,
  };
}

/** An object as text; unlike one in memory, it keeps its order whatever its members are called. */
export const objectText = (members: readonly (readonly [name: string, text: string])[]): string =>
  `{${members.map(([name, text]) => `\n${JSON.stringify(name)}: ${text}`).join(',')}}`;

export function stitchesOf({pieces, seams}: Pick<GarmentDocument, 'pieces' | 'seams'>): Stitch[] {
  const end = ({piece, edge}: EdgeOfPiece) => ({panel: pieces[piece]?.name ?? '', edge});
  return seams.map(({a, b, sameDirection}) =>
    sameDirection ? [end(a), end(b), 'right_wrong'] : [end(a), end(b)],
  );
}

/** The text of a file that reads as this document, but for the last digits of what is no centimetre there. */
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
      matches.map(({a, b, ...match}) => ({a: side(a), b: side(b), ...match})),
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
