/** Reads one piece of a DXF file: its outline as curves, and its marks. */
import type {DrawnNotch, DrawnPiece, NotchKind} from '../../model/garment/imported-drawing.js';
import {distance, middle, type Point} from '../../model/geometry/vectors.js';
import {isInside} from '../../model/geometry/polyline.js';
import {FileError} from '../../model/base/versioned-file.js';
import * as layers from './layers.js';
import {areaOf, isAllowance, loopsOf, type Loop, type Loops} from './loops.js';

import {outlineOf, type Outline} from './outline.js';
import {linesOn, pointsOn, type DxfPiece} from './pieces.js';
import type {Vendor} from './vendors.js';

/** Greatest gap between the ends of consecutive lines. [cm] */
const reach = 0.02;

interface DrawnWith {
  readonly cmPerUnit: number;
  readonly vendor: Vendor;
  /** File name for messages. */
  readonly file: string;
}

interface DrawnDxfPiece {
  readonly piece: DrawnPiece;
  readonly isInterpolated: boolean;
}

/**
 * The drawn piece of a DXF piece.
 * @throws {FileError} if the outline is open
 */
export function drawnPiece(piece: DxfPiece, how: DrawnWith): DrawnDxfPiece {
  const {entities, text} = piece;
  const {cmPerUnit, vendor} = how;
  const turnPoints = pointsOn(entities, layers.turnPoint).map(({at}) => at);
  // without a program name and marked points, lines are taken as drawn
  const hasKeyPoints =
    vendor.program !== undefined ||
    pointsOn(entities, layers.turnPoint, layers.curvePoint).length > 0;
  const outline = (loop: Loop): Outline =>
    outlineOf(loop, {cmPerUnit, turnPoints, rule: hasKeyPoints ? vendor.rule : undefined});
  const [largest, ...others] = densest(piece, layers.boundary, how);
  if (!largest) throw openOutline(piece, how);
  const outer = outline(largest);
  const [sewnLoop] = sewLoops(piece, [largest, ...others], how);
  const sewn = sewnLoop && outline(sewnLoop);
  const inner = [...others, ...densest(piece, layers.cutOut, how)]
    .filter((loop) => loop !== sewnLoop)
    .filter(({points}) => points[0] && isInside(largest.points, points[0]))
    .map(outline);
  const material = materialIn(piece);
  const grain = axisOn(piece, layers.grainLine);
  const fold = axisOn(piece, layers.mirrorLine);
  return {
    piece: {
      name: piece.name,
      ...(piece.size !== undefined && {size: piece.size}),
      quantity: piece.quantity,
      ...(material !== undefined && {material}),
      sewn: (sewn ?? outer).runs,
      ...(sewn && {cut: outer.runs}),
      holes: inner.map(({runs}) => runs),
      notches: notchesOf(piece, how),
      ...(grain && {grain}),
      ...(fold && {fold}),
      internalLines: linesOn(entities, layers.internalLine)
        .filter(({points}) => points.length > 1 && points[0] !== sewnLoop?.points[0])
        .map(({points, isClosed}) => [...points, ...(isClosed ? points.slice(0, 1) : [])]),
      drillHoles: pointsOn(entities, layers.drillHole).map(({at}) => at),
      words: text.others.map((entity) => entity.text).filter((words) => words !== ''),
    },
    isInterpolated: [outer, ...(sewn ? [sewn] : []), ...inner].some((one) => one.isInterpolated),
  };
}

const loopsOn = ({entities}: DxfPiece, layer: string, {cmPerUnit}: DrawnWith): Loops =>
  loopsOf(linesOn(entities, layer), reach / cmPerUnit);

const bySize = (loops: readonly Loop[]): Loop[] => [...loops].sort((a, b) => areaOf(b) - areaOf(a));

/**
 * Closed lines of a layer, the largest first. Each is replaced by its validation copy if that has
 * more points.
 */
function densest(piece: DxfPiece, layer: string, how: DrawnWith): Loop[] {
  const own = bySize(loopsOn(piece, layer, how).closed);
  const check = bySize(loopsOn(piece, layers.validation[layer] ?? '', how).closed);
  return own.map((loop, k) => {
    const copy = check[k];
    const isCopy = copy && Math.abs(areaOf(copy) / areaOf(loop) - 1) < 0.1;
    return isCopy && copy.points.length > loop.points.length ? copy : loop;
  });
}

/**
 * Sewn lines that differ from the cut line: from layer 14, otherwise closed lines inside the
 * outline. Valentina draws them among the internal lines of AAMA files.
 */
function sewLoops(
  piece: DxfPiece,
  [outer, ...others]: readonly [Loop, ...Loop[]],
  how: DrawnWith,
): Loop[] {
  const stated = densest(piece, layers.sewLine, how);
  if (stated.length > 0) return stated;
  const internal =
    how.vendor.program === undefined ? loopsOn(piece, layers.internalLine, how).closed : [];
  return [...others, ...internal].filter((loop) => isAllowance(loop, outer, how.cmPerUnit));
}

const materialIn = ({text}: DxfPiece): string | undefined =>
  text.value('material') ??
  text.value('fabric') ??
  text.value('category') ??
  text.all('annotation').find((words) => /lining|fusible|fusing|interfacing/i.test(words));

function axisOn({entities}: DxfPiece, layer: string): readonly [Point, Point] | undefined {
  const [line] = linesOn(entities, layer)
    .map(({points}) => [points[0] ?? [0, 0], points.at(-1) ?? [0, 0]] as const)
    .filter(([from, to]) => distance(from, to) > 0)
    .sort((a, b) => distance(...b) - distance(...a));
  return line;
}

/** Greatest number of notches, above that of any outline. */
const mostNotches = 1000;

/** @throws {FileError} for more notches than any outline has */
function notchesOf({name, entities}: DxfPiece, {file}: DrawnWith): DrawnNotch[] {
  const notches = Object.entries(layers.notches).flatMap(([layer, kind]) => [
    ...pointsOn(entities, layer).map(({at, depth, width}): DrawnNotch => ({
      at,
      ...(depth !== undefined && {depth}),
      kind: kind === 'v' && width === undefined ? 'slit' : kind,
    })),
    ...linesOn(entities, layer).map((line): DrawnNotch => drawnNotch(line.points, kind)),
  ]);
  if (notches.length <= mostNotches) return notches;
  throw new FileError(
    file,
    `has a piece '${name}' with ${notches.length} notches, more than any has; export it again.`,
  );
}

/**
 * A notch from a line. Either end of a slit can be on the outline; a V of three points is at the
 * middle of its mouth.
 */
const drawnNotch = (points: readonly Point[], kind: NotchKind): DrawnNotch => ({
  at:
    points.length > 2
      ? middle(points[0] ?? [0, 0], points.at(-1) ?? [0, 0])
      : (points[0] ?? [0, 0]),
  kind: kind === 'v' && points.length === 2 ? 'slit' : kind,
});

/** @returns the error for a piece without a closed line on the boundary layer */
function openOutline(piece: DxfPiece, how: DrawnWith): FileError {
  const {open} = loopsOn(piece, layers.boundary, how);
  const ends = open.flatMap((line, k) => [
    {at: line[0] ?? ([0, 0] as const), k, last: false},
    {at: line.at(-1) ?? ([0, 0] as const), k, last: true},
  ]);
  const gaps = ends.flatMap((one, i) =>
    ends
      .slice(i + 1)
      .filter((other) => other.k !== one.k || open.length === 1)
      .map((other) => ({from: one.at, to: other.at, width: distance(one.at, other.at)})),
  );
  // report the widest of the gaps that have to be closed
  const gap = gaps.sort((a, b) => a.width - b.width)[Math.max(0, open.length - 1)] ?? gaps.at(-1);
  const cm = ([x, y]: Point): string =>
    `(${(x * how.cmPerUnit).toFixed(1)}, ${(y * how.cmPerUnit).toFixed(1)})`;
  return new FileError(
    how.file,
    gap
      ? `has a piece '${piece.name}' whose outline is open: ${(10 * gap.width * how.cmPerUnit).toFixed(1)} mm are missing between ${cm(gap.from)} and ${cm(gap.to)} cm; close it and export it again.`
      : `has a piece '${piece.name}' without an outline; draw one on layer 1 and export it again.`,
  );
}
