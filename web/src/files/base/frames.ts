/** Recognises frames around a sheet, and title boxes in them. [mm] */
import {minus, type Point} from '../../model/geometry/vectors.js';
import {isInside} from '../../model/geometry/polyline.js';
import {isCutAround, longerSide, type ClosedLine, type Words} from './closed-lines.js';

export interface Surroundings<T> {
  readonly words: readonly Words[];
  /** Width and height of the page, if known. */
  readonly page?: Point;
  /** Lines directly inside a line. */
  readonly childrenOf: (line: T) => readonly T[];
  readonly isRectangle: (line: T) => boolean;
}

const inch = 25.4;

/** ISO A and B, ANSI and Arch sheets. [mm] */
const papers: readonly Point[] = [
  ...([
    [841, 1189],
    [594, 841],
    [420, 594],
    [297, 420],
    [210, 297],
    [1000, 1414],
  ] as const),
  ...([
    [707, 1000],
    [500, 707],
    [353, 500],
    [250, 353],
  ] as const),
  ...(
    [
      [8.5, 11],
      [11, 17],
      [17, 22],
      [22, 34],
      [34, 44],
      [8.5, 14],
    ] as const
  ).map(toMm),
  ...(
    [
      [9, 12],
      [12, 18],
      [18, 24],
      [24, 36],
      [36, 48],
      [30, 42],
    ] as const
  ).map(toMm),
];

function toMm([short, long]: Point): Point {
  return [inch * short, inch * long];
}

/** The sheet of this size, in either orientation; undefined if there is none. */
export function paperOf(size: Point, tolerance: number): Point | undefined {
  const [short = 0, long = 0] = [...size].sort((a, b) => a - b);
  return papers.find(
    (paper) => Math.abs(paper[0] - short) <= tolerance && Math.abs(paper[1] - long) <= tolerance,
  );
}

/** Greatest difference between a frame and its sheet. */
const paperTolerance = 1;

/** Least size of a frame that contains another frame alone. */
const largeFrame = 900;

/** Area of a single line in a frame, above that of neck openings. [mm2] */
const leastFramed = 40_000;

const isLargeFrame = ({box}: ClosedLine): boolean => longerSide(box) >= largeFrame;

const sizeOf = ({box}: ClosedLine): Point => minus(box.high, box.low);

/**
 * Returns whether a rectangle has the size of the page or of a sheet of paper with a line in it, or
 * encloses several lines without any text of its own, or encloses such a frame.
 */
export function isFrame<T extends ClosedLine>(line: T, around: Surroundings<T>): boolean {
  if (!around.isRectangle(line)) return false;
  const size = sizeOf(line);
  const {page, words} = around;
  if (page?.every((side, k) => Math.abs((size[k] ?? 0) - side) < 0.02 * side)) return true;
  const inner = around.childrenOf(line);
  if (inner.length > 0 && paperOf(size, paperTolerance)) return true;
  const others = inner.filter((one) => !isInCorner(one, line));
  const [only] = others;
  if (!only || others.some((one) => !isLargeFrame(line) && isCutAround(line, one))) {
    return false;
  }
  const isOwn = ({at}: Words): boolean =>
    isInside(line.rim, at) && !inner.some(({rim}) => isInside(rim, at));
  if (others.length > 1) return !words.some(isOwn);
  const [innermost] = around.childrenOf(only);
  const isFramed = innermost !== undefined && isCutAround(only, innermost);
  if (inner.length > 1 || (isLargeFrame(line) && (isFramed || isFrame(only, around)))) return true;
  // one large line is a piece, and no cut-out, if it alone has words or a cut-out
  if (only.area < leastFramed || isCutAround(line, only) || words.some(isOwn)) return false;
  return (innermost && !isFramed) ?? words.some(({at}) => isInside(only.rim, at));
}

/** Greatest gap between a title box and the sides of its frame. */
const cornerReach = 2;

/** Returns whether a line touches two sides of the line around it. */
function isInCorner(line: ClosedLine, frame: ClosedLine): boolean {
  const touches = (axis: 0 | 1): boolean =>
    Math.abs(line.box.low[axis] - frame.box.low[axis]) <= cornerReach ||
    Math.abs(line.box.high[axis] - frame.box.high[axis]) <= cornerReach;
  return touches(0) && touches(1) && line.area < 0.25 * frame.area;
}

const titleWords =
  /\b(?:scale|drawn|date|sheet|title|drawing|project|approved|revision|ma(?:ß|ss)stab|datum|blatt|gezeichnet|échelle|feuille|scala|foglio|escala|hoja)\b/i;

/** Returns whether a rectangle in a frame lies in its corner, or holds the words of a title box. */
export function isTitleBox<T extends ClosedLine>(
  line: T,
  frame: T,
  {words, isRectangle}: Surroundings<T>,
): boolean {
  if (line === frame || !isRectangle(line) || line.area >= 0.25 * frame.area) return false;
  if (isInCorner(line, frame)) return true;
  const written = words.filter(({at}) => isInside(line.rim, at)).flatMap(({lines}) => lines);
  return written.filter((one) => titleWords.test(one)).length > 1;
}
