/**
 * Lines, marks and text of a piece on the cutting sheet. Lengths in cm; line widths and letter
 * sizes in mm.
 */
import {
  angleOf,
  combined,
  distance,
  minus,
  plus,
  rotated,
  towards,
  unit,
  type Point,
} from '../model/geometry/vectors.js';
import {atShare, linesInside} from '../model/geometry/polyline.js';
import {foldArrows} from '../model/garment/fold-arrows.js';
import {foldLines} from '../model/garment/folds.js';
import type {Print} from '../model/print/repeating-print.js';
import {imageCell} from '../model/print/wallpaper.js';
import {textWidth} from '../layout/name-lines.js';
import type {CutPiece} from './cut-piece.js';
import type {CutFold} from './fold-marks.js';
import {slitOf} from './notches.js';
import type {SeamTick} from './ticks.js';
import {
  leastLetterMm,
  type CutLayer,
  type CutLine,
  type CutMark,
  type CutText,
} from './cut-sheet.js';

interface MarkStyle {
  /** Undefined for plain fabric. */
  readonly print: Print | undefined;
  /** Lines of text by importance; the first is the name. */
  readonly words: readonly string[];
  /** Transform from piece coordinates to the sheet. */
  readonly onto: (p: Point) => Point;
}

const haloMm = 0.7;
const cutMm = 0.5;
const sewMm = 0.35;
const notchMm = 0.5;
const grainMm = 0.4;
const crossMm = 0.3;
const frameMm = 0.2;
const sewDashMm = [4, 2];
const frameDashMm = [2, 2];
const crossRadius = 0.3;
const crossReach = 0.45;
const arrow = 0.35;
const greatestWordsMm = 7;
const easyWordsMm = 3;
const letterMm = 5.5;
const numberMm = 3.5;
const insideMm = 0.25;
const insideDashMm = [6, 1.5, 0.5, 1.5];
const foldMm = 0.35;
const foldDashMm = [8, 3];
/** Size of the names of internal lines. */
const lineNameMm = 3;
/** Lines whose direction has a smaller x are vertical. */
const upright = 1e-6;
const drillRadius = 0.15;
const tickMm = 0.4;
const tickReach = 0.4;
/** Distance from the end of a tick to the centre of its label. */
const tickAside = 0.35;
const stripeStyle = {
  widthMm: 0.25,
  dashMm: [8, 1.5, 0.5, 1.5, 0.5, 1.5],
  haloMm: 0.5,
  isFaint: true,
};
/** Offset from a cross to the centre of its number. */
const numberAside: Point = [0.65, 0.4];

type LineStyle = Omit<CutLine, 'kind' | 'layer' | 'points' | 'isClosed'>;

const line = (layer: CutLayer, points: readonly Point[], style: LineStyle): CutLine => ({
  ...{kind: 'line', layer, points, isClosed: false},
  ...style,
});

const closed = (
  layer: CutLayer,
  loops: readonly (readonly Point[])[],
  style: LineStyle,
): readonly CutLine[] => loops.map((points) => ({...line(layer, points, style), isClosed: true}));

const plate = (layer: CutLayer, at: Point, lines: readonly string[], sizeMm: number): CutText => ({
  ...{kind: 'text', layer, at, lines, sizeMm, hasPlate: true},
});

/** The grain line with arrowheads at both ends, since the file does not define its upper end. */
function grainArrow([from, to]: readonly [Point, Point]): readonly CutLine[] {
  const [ux, uy] = unit(minus(to, from)).map((side) => side * arrow) as [number, number];
  const head = ([x, y]: Point, sign: 1 | -1): Point[] => [
    [x - sign * ux - uy / 2, y - sign * uy + ux / 2],
    [x, y],
    [x - sign * ux + uy / 2, y - sign * uy - ux / 2],
  ];
  return [[from, to], head(to, 1), head(from, -1)].map((points) =>
    line('marks', points, {widthMm: grainMm, haloMm}),
  );
}

/** A tick across the sewn line, along a line of the print. */
function tickMarks({at, along, label}: SeamTick, onto: (p: Point) => Point): readonly CutMark[] {
  const ends = [plus(at, along, -tickReach), plus(at, along, tickReach)];
  return [
    line('matches', ends.map(onto), {widthMm: tickMm, haloMm}),
    plate('matches', onto(plus(at, along, -tickReach - tickAside)), [label], leastLetterMm),
  ];
}

/** The outline of one repeat of the print around a point, which helps to find it on the fabric. */
function repeatAround(p: Point, piece: CutPiece, {print, onto}: MarkStyle): readonly CutLine[] {
  if (!print) return [];
  const [a, b] = imageCell(print).map((side) => rotated(side, piece.alignment.angle));
  if (!a || !b) return [];
  const corner = (s: number, t: number): Point => plus(p, combined([a, b], s, t));
  const half = 1 / 2;
  const frame = [
    corner(-half, -half),
    corner(half, -half),
    corner(half, half),
    corner(-half, half),
  ];
  return frame
    .flatMap((from, k) => linesInside(piece.sewn, from, frame[(k + 1) % 4] ?? from))
    .map((ends) =>
      line('matches', ends.map(onto), {
        ...{widthMm: frameMm, dashMm: frameDashMm, haloMm, isFaint: true},
      }),
    );
}

const ringSteps = 32;

const ring = (at: Point, radius: number): readonly Point[] =>
  Array.from({length: ringSteps}, (_, k) =>
    plus(at, towards((2 * Math.PI * k) / ringSteps), radius),
  );

const drillHole = (at: Point): readonly CutLine[] =>
  closed('marks', [ring(at, drillRadius)], {widthMm: insideMm, haloMm});

function crossAt([x, y]: Point, number: number): readonly CutMark[] {
  const r = crossReach;
  const style = {widthMm: crossMm, haloMm};
  return [
    ...closed('matches', [ring([x, y], crossRadius)], style),
    ...[
      [[x - r, y] as const, [x + r, y] as const],
      [[x, y - r] as const, [x, y + r] as const],
    ].map((ends) => line('matches', ends, style)),
    plate('matches', plus([x, y], numberAside), [String(number)], numberMm),
  ];
}

/** The text, as large as its space allows; in a small space, only the first lines. */
function wordsOn({words: {at, room}}: CutPiece, {words, onto}: MarkStyle): CutText {
  const sizeOf = (lines: readonly string[]): number => {
    const longest = Math.max(...lines.map((one) => textWidth(one, 1)));
    return (20 * room) / Math.hypot(longest + 1, 1.25 * lines.length + 0.4);
  };
  const counts = words.map((_, k) => words.length - k);
  const count = counts.find((n) => sizeOf(words.slice(0, n)) >= easyWordsMm) ?? 1;
  const lines = words.slice(0, count);
  const size = Math.max(leastLetterMm, Math.min(greatestWordsMm, sizeOf(lines)));
  return plate('words', onto(at), lines, size);
}

/** Width and height of text. [mm] */
const sizeOfWords = ({lines, sizeMm}: CutText): readonly [number, number] => [
  Math.max(...lines.map((one) => textWidth(one, sizeMm))),
  1.25 * sizeMm * lines.length,
];

/** Places of a line's name by preference. [shares of the line's length] */
const nameShares = [0.5, 0.25, 0.75, 0.1, 0.9];

/** The name of an internal line, upright and along it, clear of the piece's text. */
function nameAlong(points: readonly Point[], name: string, words: CutText): CutText {
  const room = textWidth(name, 0.1 * lineNameMm) / 2 + 0.05 * Math.hypot(...sizeOfWords(words));
  const share = nameShares.find((one) => distance(atShare(points, one).at, words.at) > room) ?? 0.5;
  const {at, along} = atShare(points, share);
  const isReversed = along[0] < -upright || (along[0] < upright && along[1] < 0);
  const angle = angleOf(along) + (isReversed ? Math.PI : 0);
  return {...plate('words', at, [name], lineNameMm), angle, weight: 'regular'};
}

/** The lines of a fold, its arrows, and its name along both lines. */
function foldMarks(fold: CutFold, {onto}: MarkStyle, words: CutText): readonly CutMark[] {
  return [
    ...foldLines(fold).map((ends) =>
      line('marks', ends.map(onto), {widthMm: foldMm, dashMm: foldDashMm, haloMm}),
    ),
    ...foldArrows(fold).map((points) => line('marks', points.map(onto), {widthMm: foldMm, haloMm})),
    ...foldLines(fold).map((ends) => nameAlong(ends.map(onto), fold.name, words)),
  ];
}

/** The marks in drawing order. */
export function pieceMarks(piece: CutPiece, style: MarkStyle): readonly CutMark[] {
  const {onto} = style;
  const loops = (points: readonly (readonly Point[])[]) => points.map((loop) => loop.map(onto));
  const words = wordsOn(piece, style);
  return [
    ...closed('cut', loops(piece.cut), {widthMm: cutMm}),
    ...piece.matches.flatMap((p) => repeatAround(p, piece, style)),
    ...closed('sew', loops(piece.sewn), {widthMm: sewMm, dashMm: sewDashMm, haloMm}),
    ...piece.notches.map((notch) =>
      line('marks', slitOf(notch).map(onto), {widthMm: notchMm, haloMm}),
    ),
    ...piece.internalLines.map((points) =>
      line('marks', points.map(onto), {widthMm: insideMm, dashMm: insideDashMm, haloMm}),
    ),
    ...piece.internalLines.flatMap((points, k) => {
      const name = piece.lineNames[k];
      return name === undefined ? [] : [nameAlong(points.map(onto), name, words)];
    }),
    ...piece.folds.flatMap((fold) => foldMarks(fold, style, words)),
    ...piece.drillHoles.flatMap((p) => drillHole(onto(p))),
    ...grainArrow([onto(piece.grain[0]), onto(piece.grain[1])]),
    ...piece.matches.flatMap((p, k) => crossAt(onto(p), k + 1)),
    ...[piece.stripe, piece.plaid].flatMap((ends) =>
      ends ? [line('matches', ends.map(onto), stripeStyle)] : [],
    ),
    ...piece.ticks.flatMap((tick) => tickMarks(tick, onto)),
    ...piece.letters.map(({letter, at}) => plate('marks', onto(at), [letter], letterMm)),
    words,
  ];
}
