/** Strokes of an overlay: lines over the sheet while the user points, selects or marks. */
import type {LineLook, OnPiece, Overlay} from '../scene/overlay.js';
import type {Point} from '../model/geometry/vectors.js';
import type {SeamSide} from '../model/result/result.js';
import {ontoSheet} from '../model/geometry/sheet-place.js';
import {pick} from '../scene/marks.js';
import type {LineStyle, Stroke} from './line-layer.js';
import {lineOf, type PatternScene, type SceneSeam} from '../scene/scene.js';
import {atShare} from '../model/geometry/polyline.js';
import {shiftsOutside} from './outside.js';
import {axisTicks, besideEdge, cased, inks, seamStrokes, type Appearance} from './strokes.js';

/** Bend of the thread between two sides, as a share of its length. */
const bend = 0.16;

/** Converts a point of a piece to the sheet. */
export const onSheet = ({pieces}: PatternScene, piece: number, point: Point): Point =>
  ontoSheet(pieces[piece] ?? {offset: [0, 0]}, point);

function thread([x0, y0]: Point, [x1, y1]: Point): readonly Point[] {
  const [mx, my] = [(x0 + x1) / 2 - bend * (y1 - y0), (y0 + y1) / 2 + bend * (x1 - x0)];
  return Array.from({length: 33}, (_, k): Point => {
    const t = k / 32;
    const [a, b, c] = [(1 - t) ** 2, 2 * t * (1 - t), t ** 2];
    return [a * x0 + b * mx + c * x1, a * y0 + b * my + c * y1];
  });
}

export function overlayStrokes(
  scene: PatternScene,
  overlay: Overlay,
  appearance: Appearance,
): readonly Stroke[] {
  const {accent, casing, mark, quiet} = inks[appearance];
  const line = (piece: number, points: readonly Point[], styles: LineStyle): Stroke => ({
    points: points.map((point) => onSheet(scene, piece, point)),
    styles,
  });
  const dot = ({piece, point}: OnPiece, width: number, colour = accent): Stroke[] => {
    const at = line(piece, [point, point], {colour, width});
    return [cased(at, casing), at];
  };
  const outline = (piece: number | undefined, styles: LineStyle): Stroke[] => {
    const {points = [], outline: loop = [], holes = []} = scene.pieces[piece ?? -1] ?? {};
    return [loop, ...holes].map((vertices) => {
      const edge = line(piece ?? 0, pick(points, vertices), styles);
      return {...edge, closed: true, shifts: shiftsOutside(edge.points, 1, true)};
    });
  };
  const axis = (piece: number, ends: readonly Point[], colour: LineStyle['colour']): Stroke[] => {
    const dashed = line(piece, ends, {colour, width: 1.6, dash: [5, 7]});
    return [cased(dashed, casing), dashed];
  };
  const {
    ghosts = [],
    candidate,
    points = [],
    lines = [],
    threads = [],
    cursors = [],
    rails = [],
    highlight,
  } = overlay;
  const seam = highlight && scene.seams[highlight.seam];
  const lookOf: Readonly<Record<LineLook, LineStyle>> = {
    chosen: {colour: accent, width: 3.5},
    lit: {colour: accent, width: 2.4, dash: [6, 9]},
    faint: {colour: accent, width: 1.2, dash: [1, 5]},
    open: {colour: quiet, width: 2.4, dash: [0.5, 5]},
    fold: {colour: mark, width: 1.6, dash: [9, 5]},
  };
  return [
    ...outline(overlay.hoverPiece, {colour: accent, width: 2}),
    ...outline(overlay.selectPiece, {colour: accent, width: 3.5}),
    ...ghosts.flatMap((ghost) =>
      ghost.kind === 'piece' ? axisTicks(scene.pieces[ghost.piece], ghost.axis, quiet) : [],
    ),
    ...rails.flatMap(({piece, line: ends}) => {
      const rail = line(piece, ends, {colour: mark, width: 1, dash: [1, 4]});
      return [cased(rail, casing), rail];
    }),
    ...(candidate ? axis(candidate.piece, candidate.axis, accent) : []),
    ...lines.flatMap(({piece, line: marked, look = 'chosen'}) => {
      const drawn = line(piece, marked, lookOf[look]);
      return [cased(drawn, casing), drawn];
    }),
    ...threads.flatMap(({from, to, isFaint = false}) => {
      const points = thread(
        onSheet(scene, from.piece, from.point),
        onSheet(scene, to.piece, to.point),
      );
      const styles: LineStyle = isFaint ? lookOf.faint : {colour: accent, width: 1.6};
      const ends = isFaint ? [] : [from, to].flatMap((end) => dot(end, 6));
      return [cased({points, styles}, casing), {points, styles}, ...ends];
    }),
    ...(seam ? highlit(scene, seam, highlight.side, appearance) : []),
    ...points.flatMap((point) => dot(point, 8)),
    ...cursors.flatMap((cursor) => [...dot(cursor, 11, mark), ...dot(cursor, 5)]),
  ];
}

/** Returns a seam with a glow around both sides, in the colours of its mismatch, and the thread. */
function highlit(
  scene: PatternScene,
  seam: SceneSeam,
  pointed: 'a' | 'b' | undefined,
  appearance: Appearance,
): Stroke[] {
  const {accent, casing} = inks[appearance];
  const glow = (side: SeamSide, name: 'a' | 'b'): Stroke => ({
    ...besideEdge(scene, side),
    styles: {colour: accent, width: pointed === name ? 9 : 7},
  });
  const ends = [seam.a, seam.b].map((side) => atShare(lineOf(scene, side), 0.5).at);
  const joined: Stroke = {
    points: thread(ends[0] ?? [0, 0], ends[1] ?? [0, 0]),
    styles: {colour: accent, width: 1.6},
  };
  return [
    cased(joined, casing),
    joined,
    glow(seam.a, 'a'),
    glow(seam.b, 'b'),
    ...seamStrokes(scene, appearance, [seam]),
  ];
}
