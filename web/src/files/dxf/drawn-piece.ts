/** Reads one piece of a DXF file: its outline as curves, and its marks. */
import type {DrawnNotch, DrawnPiece, NotchKind} from '../../model/garment/imported-drawing.js';
import {distance, middle, type Point} from '../../model/geometry/vectors.js';
import {FileError} from '../../model/base/versioned-file.js';
import * as layers from './layers.js';
import {closedLine, isCutAround, liesIn, type ClosedLine} from '../base/closed-lines.js';
import {foldsAmong} from '../base/fold-lines.js';
import {grainsAmong, usualGrain} from '../base/grain-lines.js';
import {doubtfulHoles, gapNote, openNotes, placesOf} from '../base/left-out.js';
import {reach} from './flat.js';
import {areaOf, bySize, loopsOf, type Gap, type Loop, type Loops} from './loops.js';
import {outlineOf, type Outline} from './outline.js';
import type {LineEntity} from './entities.js';
import {linesOf, linesOn, pointsOn, type DxfPiece} from './pieces.js';
import type {Vendor} from './vendors.js';

export interface DrawnWith {
  readonly cmPerUnit: number;
  readonly vendor: Vendor;
  /** File name for messages. */
  readonly file: string;
}

export interface DrawnDxfPiece {
  readonly piece: DrawnPiece;
  readonly isInterpolated: boolean;
  readonly notes: readonly string[];
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
  const within = lineOf(largest, how);
  const [inside, outside] = parted(
    [...others, ...densest(piece, layers.cutOut, how)].filter((loop) => loop !== sewnLoop),
    (loop) => liesIn(lineOf(loop, how), within),
  );
  const beside = densest(piece, layers.sewLine, how).filter(
    ({points}) => points[0] !== sewnLoop?.points[0],
  );
  const holes = inside.map((loop) => sewnAround(loop, beside, how) ?? loop);
  const inner = holes.map(outline);
  const gaps = [largest, ...(sewnLoop ? [sewnLoop] : [])].map(({gap}) => gap);
  const material = materialIn(piece);
  const grains = grainsAmong(axesOn(piece, layers.grainLine), text.others, {
    cmPerUnit,
    isSure: true,
  });
  const grain = usualGrain(grains) ?? axisOn(piece, layers.grainLine);
  const fold = axisOn(piece, layers.mirrorLine);
  const drawnInside = [
    ...linesOn(entities, layers.internalLine).filter(
      (line) => line.points.length > 1 && !isTick(line, piece, how),
    ),
    ...beside.filter((loop) => !holes.includes(loop)).map(({points}) => ({points, isClosed: true})),
    ...openSewLines(piece, how),
  ]
    .filter(({points}) => points[0] !== sewnLoop?.points[0])
    .map(({points, isClosed}) => [...points, ...(isClosed ? points.slice(0, 1) : [])]);
  const {folds, lines} = foldsAmong(drawnInside, text.others, cmPerUnit);
  return {
    piece: {
      name: piece.name,
      ...(piece.size !== undefined && {size: piece.size}),
      quantity: piece.quantity,
      ...(material !== undefined && {material}),
      sewn: (sewn ?? outer).runs,
      ...(sewn && {cut: outer.runs}),
      holes: inner.map(({runs}) => runs),
      ...doubtfulHoles(
        inside,
        inside.filter(({isDoubtful}) => isDoubtful),
      ),
      notches: notchesOf(piece, how),
      ...(grain && {grain}),
      ...(grains.length > 0 && {grains}),
      ...(fold && {fold}),
      ...(folds.length > 0 && {folds}),
      internalLines: lines,
      drillHoles: pointsOn(entities, layers.drillHole).map(({at}) => at),
      words: text.others.map((entity) => entity.text).filter((words) => words !== ''),
      ...(piece.doubt !== undefined && {doubt: piece.doubt}),
    },
    isInterpolated: [outer, ...(sewn ? [sewn] : []), ...inner].some((one) => one.isInterpolated),
    notes: [
      ...gaps.flatMap((gap) => gapNote(piece.name, gap && gapInMm(gap, cmPerUnit), 'up') ?? []),
      ...openNotes(
        loopsOn(piece, layers.boundary, how).open.map(({points, layer}) => ({
          points: points.map(([x, y]): Point => [10 * cmPerUnit * x, 10 * cmPerUnit * y]),
          layer,
        })),
        'up',
      ),
      ...unreadNotes(piece, [...outside, ...unread(piece, how)], how),
    ],
  };
}

const loopsOn = ({entities, loops}: DxfPiece, layer: string, {cmPerUnit}: DrawnWith): Loops => {
  const known = loops?.filter((loop) => loop.layer === layer) ?? [];
  return known.length > 0
    ? {closed: known, open: []}
    : loopsOf(linesOn(entities, layer), reach / cmPerUnit);
};

const gapInMm = ({width, at}: Gap, cmPerUnit: number): Gap => ({
  width: 10 * cmPerUnit * width,
  at: [10 * cmPerUnit * at[0], 10 * cmPerUnit * at[1]],
});

/** A loop in millimetres. */
const lineOf = ({points}: Loop, {cmPerUnit}: DrawnWith): ClosedLine =>
  closedLine(points.map(([x, y]): Point => [10 * cmPerUnit * x, 10 * cmPerUnit * y]));

function parted<T>(all: readonly T[], is: (one: T) => boolean): [T[], T[]] {
  return [all.filter(is), all.filter((one) => !is(one))];
}

/** Layers whose closed lines are part of a piece. */
const isRead = (layer: string): boolean => layer === layers.boundary || layer in layers.roles;

/** Closed lines of a block on layers without a meaning, or of marks that hold none. */
const unread = ({entities, loops}: DxfPiece, {cmPerUnit}: DrawnWith): readonly Loop[] =>
  loops
    ? []
    : loopsOf(
        linesOf(entities).filter(({layer, isClosed}) =>
          layers.isMark(layer) ? isClosed && !layers.holdsClosedMarks(layer) : !isRead(layer),
        ),
        reach / cmPerUnit,
      ).closed;

/** The sewn line around a cut-out, whose allowance lies inside it. */
function sewnAround(cutOut: Loop, sewn: readonly Loop[], how: DrawnWith): Loop | undefined {
  const inner = lineOf(cutOut, how);
  return [...sewn]
    .sort((a, b) => areaOf(a) - areaOf(b))
    .find((loop) => liesIn(inner, lineOf(loop, how)));
}

/** Open lines on the layer of sewn lines. */
const openSewLines = (
  piece: DxfPiece,
  how: DrawnWith,
): {readonly points: readonly Point[]; readonly isClosed: boolean}[] =>
  loopsOn(piece, layers.sewLine, how).open.map(({points}) => ({points, isClosed: false}));

/** A note on closed lines of a block that are no part of its piece. */
function unreadNotes(piece: DxfPiece, loops: readonly Loop[], how: DrawnWith): string[] {
  if (loops.length === 0) return [];
  const names = [...new Set(loops.map(({layer}) => layer))].join(', ');
  return [
    `${loops.length} closed ${loops.length === 1 ? 'line' : 'lines'} of '${piece.name}' on layer ${names} ${loops.length === 1 ? 'is' : 'are'} left out; ${placesOf(
      loops.map((loop) => lineOf(loop, how)),
      'up',
    )}.`,
  ];
}

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
  const cut = lineOf(outer, how);
  return [...others, ...internal].filter((loop) => isCutAround(cut, lineOf(loop, how)));
}

/** Greatest distance of a label from the middle of its tick. [cm] */
const labelReach = 0.001;

/** Longest tick or cross of a print. [cm] */
const longestTick = 1;

/**
 * Returns whether an internal line is a tick or a part of a cross where a print has to match, with its
 * label at its middle. Such marks belong to that print, not to the piece.
 */
const isTick = (line: LineEntity, {text}: DxfPiece, {cmPerUnit}: DrawnWith): boolean => {
  const [from, to] = line.points;
  if (!from || !to || line.points.length !== 2) return false;
  if (distance(from, to) * cmPerUnit > longestTick) return false;
  const at = middle(from, to);
  return text.others.some(
    (label) =>
      layers.annotations.includes(label.layer) && distance(label.at, at) * cmPerUnit < labelReach,
  );
};

const materialIn = ({text}: DxfPiece): string | undefined =>
  text.value('material') ??
  text.value('fabric') ??
  text.value('category') ??
  text.all('annotation').find((words) => /lining|fusible|fusing|interfacing/i.test(words));

const axesOn = ({entities}: DxfPiece, layer: string): readonly (readonly [Point, Point])[] =>
  linesOn(entities, layer)
    .map(({points}) => [points[0] ?? [0, 0], points.at(-1) ?? [0, 0]] as const)
    .filter(([from, to]) => distance(from, to) > 0);

function axisOn(piece: DxfPiece, layer: string): readonly [Point, Point] | undefined {
  const [line] = [...axesOn(piece, layer)].sort((a, b) => distance(...b) - distance(...a));
  return line;
}

/** Greatest number of notches, above that of any outline. */
const mostNotches = 1000;

/** @throws {FileError} for more notches than any outline has */
function notchesOf({name, entities}: DxfPiece, {file}: DrawnWith): DrawnNotch[] {
  const notches = Object.entries(layers.notches).flatMap(([layer, kind]) => [
    ...pointsOn(entities, layer).map(({at, towards, depth, width}): DrawnNotch => ({
      at,
      ...(towards && {towards}),
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
  const open = loopsOn(piece, layers.boundary, how).open.map(({points}) => points);
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
