/**
 * Writes a cutting sheet as AAMA DXF: R12 syntax, one block per piece, metric. Layers follow
 * ANSI/AAMA-292 and ASTM D6673. The units METRIC are millimetres.
 */
import {
  degrees,
  distance,
  minus,
  plus,
  towards,
  turnBetween,
  type Point,
} from '../../model/geometry/vectors.js';
import {signedArea} from '../../model/geometry/polyline.js';
import {packageVersion} from '../../model/base/version.js';
import type {CutSheet, LaidPiece} from '../cut-sheet.js';
import {lineColours} from '../line-colours.js';
import {
  block,
  dxfFile,
  insert,
  line,
  plainText,
  point,
  polyline,
  text,
  type Pair,
} from '../../files/dxf/records.js';

export const layers = {
  cut: 1,
  turn: 2,
  curve: 3,
  notch: 4,
  grain: 7,
  inner: 8,
  stripe: 9,
  plaid: 10,
  hole: 11,
  drill: 13,
  sew: 14,
  words: 15,
  /** The first of the quality-validation copies of layers 1, 8, 11 and 14. */
  copy: 84,
} as const;

export interface DxfOptions {
  /**
   * Writes the sewn line as the boundary on layer 1 and the cut line on layer 14, as CLO expects.
   * Default false.
   */
  readonly sewAsBoundary?: boolean;
  /** Creation date of the file. */
  readonly date?: Date;
}

/** Least turn of a corner. [rad] */
const cornerTurn = 0.35;
/** Points closer than this are equal. [cm] */
const same = 1e-3;
/** Half the length of an internal line that represents a tick. [cm] */
const tickReach = 0.4;
/** Greatest length of block names in some readers. */
const longestName = 31;

/** Corners of a line are turn points; all other points are curve points. */
function pointsOf(loop: readonly Point[], corners: readonly Point[]): readonly Pair[] {
  return loop.flatMap((p, k) => {
    const [before = p, after = p] = [loop.at(k - 1), loop[(k + 1) % loop.length]];
    const isCorner =
      Math.abs(turnBetween(minus(p, before), minus(after, p))) > cornerTurn ||
      corners.some((corner) => distance(corner, p) < same);
    return point(isCorner ? layers.turn : layers.curve, p);
  });
}

/** Greatest difference of the areas of equal lines. [cm2] */
const leastArea = 1e-6;

/** Returns whether the cut line differs from the sewn line. */
const hasAllowance = ({cut, sewn}: LaidPiece): boolean =>
  cut.length !== sewn.length ||
  cut.some((loop, k) => Math.abs(signedArea(loop) - signedArea(sewn[k] ?? [])) > leastArea);

/** The boundary with its validation copy, the other line, and cut-outs. */
function outlines(piece: LaidPiece, {sewAsBoundary = false}: DxfOptions): readonly Pair[] {
  const {cut, sewn, corners} = piece;
  const [boundary, other] = sewAsBoundary ? [sewn, cut] : [cut, sewn];
  const [ofCut, ofSewn] = [lineColours.cut.index, lineColours.sew.index];
  const [first, second] = sewAsBoundary ? [ofSewn, ofCut] : [ofCut, ofSewn];
  const [outer = [], ...holes] = boundary;
  const others = hasAllowance(piece) ? other : [];
  return [
    ...polyline(layers.cut, outer, true, first),
    ...pointsOf(outer, corners),
    ...polyline(layers.copy, outer, true),
    ...holes.flatMap((hole) => [
      ...polyline(layers.hole, hole, true, first),
      ...pointsOf(hole, corners),
    ]),
    ...others.flatMap((loop) => [
      ...polyline(layers.sew, loop, true, second),
      ...pointsOf(loop, corners),
    ]),
  ];
}

/** Notches on the boundary, with depth, width and direction into the piece. */
function notches(piece: LaidPiece, {sewAsBoundary = false}: DxfOptions): readonly Pair[] {
  return piece.notches.flatMap(({at, angle, allowanceCm, depthCm}) =>
    point(layers.notch, sewAsBoundary ? at : plus(at, towards(angle), allowanceCm), [
      [30, Number((10 * depthCm).toFixed(3))],
      [39, 0],
      [50, Number(((degrees(angle) + 540) % 360).toFixed(3))],
    ]),
  );
}

/** All lines and points of a piece. */
export const drawn = (piece: LaidPiece, options: DxfOptions = {}): readonly Pair[] => [
  ...outlines(piece, options),
  ...notches(piece, options),
  ...inside(piece),
];

function inside(piece: LaidPiece): readonly Pair[] {
  const {grain, internalLines, ticks, stripe, plaid, drillHoles, matchPoints} = piece;
  return [
    ...line(layers.grain, grain),
    ...internalLines.flatMap((points) => polyline(layers.inner, points, false)),
    ...ticks.flatMap(({at, angle, label}) => {
      const reach = towards(angle);
      return [
        ...line(layers.inner, [plus(at, reach, -tickReach), plus(at, reach, tickReach)]),
        ...text(layers.words, at, label),
      ];
    }),
    ...(stripe ? line(layers.stripe, stripe) : []),
    ...(plaid ? line(layers.plaid, plaid) : []),
    ...crosses(matchPoints),
    ...drillHoles.flatMap((at) => point(layers.drill, at)),
  ];
}

/** Numbered crosses. */
export const crosses = (points: LaidPiece['matchPoints']): readonly Pair[] =>
  points.flatMap(({at, number}) => [
    ...[0, Math.PI / 2].flatMap((angle) =>
      line(layers.inner, [
        plus(at, towards(angle), -tickReach),
        plus(at, towards(angle), tickReach),
      ]),
    ),
    ...text(layers.words, at, String(number)),
  ]);

function words(piece: LaidPiece, name: string, {size}: CutSheet): readonly Pair[] {
  const [foot] = piece.grain;
  const said = [
    `Piece Name: ${name}`,
    `Quantity: ${piece.quantity},0`,
    ...(size === undefined ? [] : [`Size: ${size}`]),
    ...(piece.material === undefined ? [] : [`Material: ${piece.material}`]),
    `Annotation: ${piece.words.join('; ')}`,
  ];
  return [
    ...said.flatMap((one) => text(layers.cut, foot, one)),
    ...piece.words.flatMap((one, k) => text(layers.words, plus(foot, [0, -k]), one)),
    ...piece.letters.flatMap(({letter, at}) => text(layers.words, at, letter)),
  ];
}

/** Unique readable names in 7-bit ASCII, regardless of case. */
export function namesOf(pieces: readonly Pick<LaidPiece, 'name'>[]): readonly string[] {
  const taken = new Set<string>();
  return pieces.map(({name}, k) => {
    const plain = plainText(name);
    const readable = /\w/.test(plain) && !plain.includes('?') ? plain : `piece ${k + 1}`;
    let unique = readable.slice(0, longestName);
    for (let n = 2; taken.has(blockName(unique).toLowerCase()); n++) {
      const ending = ` ${n}`;
      unique = readable.slice(0, longestName - ending.length) + ending;
    }
    taken.add(blockName(unique).toLowerCase());
    return unique;
  });
}

/** A block name of characters that every reader supports. */
export const blockName = (name: string): string => name.replace(/[^\w-]+/g, '_');

const twoDigits = (value: number): string => String(value).padStart(2, '0');

function style(sheet: CutSheet, {date}: DxfOptions): readonly string[] {
  const day = date && [date.getUTCDate(), date.getUTCMonth() + 1].map(twoDigits);
  return [
    `Style Name: ${sheet.title ?? 'Pattern'}`,
    ...(date && day ? [`Creation Date: ${day.join('-')}-${date.getUTCFullYear()}`] : []),
    `Author: Seamwise;Seamwise;${packageVersion}`,
    ...(sheet.size === undefined ? [] : [`Sample Size: ${sheet.size}`]),
    'Units: METRIC',
  ];
}

/** The text of a DXF file in 7-bit ASCII. */
export function sheetDxf(sheet: CutSheet, options: DxfOptions = {}): string {
  const names = namesOf(sheet.pieces);
  const blocks = sheet.pieces.flatMap((piece, k) => {
    const name = names[k] ?? piece.name;
    return block(blockName(name), [...words(piece, name, sheet), ...drawn(piece, options)]);
  });
  const entities = [
    ...style(sheet, options).flatMap((one, k) => text(layers.cut, [0, -2 - k], one)),
    ...names.flatMap((name) => insert(blockName(name))),
  ];
  return dxfFile(blocks, entities);
}
