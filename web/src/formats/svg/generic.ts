/**
 * Reads pieces of SVG files from unknown programs: closed lines, with the text and marks inside.
 * [mm]
 */
import type {DrawnPiece} from '../../model/garment/imported-drawing.js';
import {distance, middle, minus, type Point} from '../../model/geometry/vectors.js';
import {isInside, type Box} from '../../model/geometry/polyline.js';
import {endOf} from '../base/bezier.js';
import {countOf, saysFold} from '../base/words.js';
import type {XmlElement} from '../base/xml.js';
import {
  isCutAround,
  isRectangle,
  leastPiece,
  liesIn,
  longerSide,
  loopsOf,
  type Loop,
  type Stroke,
} from './nesting.js';
import {valentina} from './lengths.js';
import {labelOf, titled} from './names.js';
import {
  foldOf,
  grainEnds,
  grainOf,
  isDrill,
  isLong,
  marksOf,
  middleOf,
  notchesOf,
  type Mark,
} from './marks.js';
import {chained, runsOf} from './outlines.js';
import {testSquares} from './scale-box.js';
import type {DrawnText, Sheet} from './walk.js';

export interface Found {
  readonly pieces: readonly DrawnPiece[];
  readonly notes: readonly string[];
}

/** Connected lines with the elements that draw them. */
function strokesOf({drawn}: Sheet): Stroke[] {
  const drawers = drawn.flatMap((one) => one.lines.map(() => one));
  return chained(drawn.flatMap(({lines}) => lines)).map(({line, parts}) => ({
    line,
    drawers: parts.flatMap((part) => drawers[part] ?? []),
  }));
}

/** The longer side of the largest closed line that is no frame. [mm] */
export function largestClosed(sheet: Sheet): number {
  const loops = loopsOf(strokesOf(sheet)).slice(0, 100); // only the largest
  const shown = loops.filter((loop) => !isFrame(loop, loops, sheet));
  return Math.max(0, ...shown.map(({box}) => longerSide(box)));
}

/** GarmentCode fills its panels with this colour, and overlaps them. */
const garmentCodeFill = 'rgb(227,175,186)';

/** Greatest number of outlines, far above that of many pieces drawn twice. */
const mostOutlines = 1000;

const tooMany = (count: number): string =>
  `It has ${count} closed lines of 25 cm² or more, as no pattern has; delete what is no piece.`;

export function genericPieces(sheet: Sheet): Found {
  const strokes = strokesOf(sheet);
  const squares = testSquares(sheet);
  const large = loopsOf(strokes).filter(({area, line}) => area >= leastPiece && !squares.has(line));
  if (large.length > mostOutlines) return {pieces: [], notes: [tooMany(large.length)]};
  const shown = large.filter((loop) => !isFrame(loop, large, sheet));
  const isPanel = ({drawers}: Loop): boolean =>
    drawers.some(({style}) => style.fill === garmentCodeFill);
  const outer = shown.filter(
    (loop, k) => isPanel(loop) || !shown.slice(0, k).some((other) => liesIn(loop, other)),
  );
  const lines = new Set(outer.map(({line}) => line));
  const innerLoops = shown.filter(({line}) => !lines.has(line));
  const marks = marksOf(strokes.filter(({line}) => !lines.has(line)));
  const pieces = outer.map((loop, k): DrawnPiece => {
    const inner = innerLoops.find((other) => liesIn(other, loop) && isCutAround(loop, other));
    const written = sheet.texts.filter((text) => ownerOf(text, outer) === loop);
    const others = outer.filter((other) => other !== loop);
    const name =
      titled(written, sheet.program === valentina) ??
      labelsOf(inner ?? loop, others) ??
      labelsOf(loop, others) ??
      `piece ${k + 1}`;
    return {name, ...pieceOf(loop, inner, marks, written)};
  });
  return {
    pieces,
    notes: [
      ...(shown.length < large.length ? ['Frames around pieces are left out.'] : []),
      ...openNotes(marks, outer),
    ],
  };
}

/** Labels of a line and of the groups around it, except groups that contain other pieces. */
function labelsOf({drawers: [drawer]}: Loop, others: readonly Loop[]): string | undefined {
  const around = drawer ? [drawer.element, ...drawer.groups.toReversed()] : [];
  const isOwn = (element: XmlElement): boolean =>
    !others.some(({drawers}) => drawers.some(({groups}) => groups.includes(element)));
  return around.filter(isOwn).flatMap((element) => labelOf(element) ?? [])[0];
}

/** The piece that contains a text; of several, the one with the nearest middle. */
function ownerOf({at}: DrawnText, outer: readonly Loop[]): Loop | undefined {
  const off = ({box}: Loop): number => distance(middle(box.low, box.high), at);
  return outer.filter(({rim}) => isInside(rim, at)).sort((a, b) => off(a) - off(b))[0];
}

/**
 * Returns whether a rectangle has the page's size, or encloses several others without any text of
 * its own.
 */
function isFrame(loop: Loop, large: readonly Loop[], {page, texts}: Sheet): boolean {
  if (!isRectangle(loop.line)) return false;
  const size = minus(loop.box.high, loop.box.low);
  if (page.every((side, k) => Math.abs((size[k] ?? 0) - side) < 0.02 * side)) return true;
  const inner = large.filter((other) => other !== loop && liesIn(other, loop));
  const isApart = (one: Loop): boolean =>
    !inner.some((other) => other !== one && liesIn(one, other));
  const isOwn = ({at}: DrawnText): boolean =>
    isInside(loop.rim, at) && !inner.some(({rim}) => isInside(rim, at));
  return inner.filter(isApart).length > 1 && !texts.some(isOwn);
}

/** Notes on open lines as long as an outline whose ends nearly meet, outside of all pieces. */
function openNotes(marks: readonly Mark[], outer: readonly Loop[]): string[] {
  return marks.flatMap(({line, length, at}) => {
    const gap = distance(line.start, endOf(line));
    const isOutline = !line.isClosed && gap <= 50 && length > 200 && length > 5 * gap;
    if (!isOutline || outer.some(({rim}) => isInside(rim, at))) return [];
    const [x, y] = line.start;
    return [
      `An outline does not close: its ends lie ${gap.toFixed(1)} mm apart at x ${(x / 10).toFixed(1)} cm, y ${(-y / 10).toFixed(1)} cm of the page; join them.`,
    ];
  });
}

function pieceOf(
  outer: Loop,
  seam: Loop | undefined,
  marks: readonly Mark[],
  written: readonly DrawnText[],
): Omit<DrawnPiece, 'name'> {
  const sewn = seam ?? outer;
  const runs = runsOf(sewn.line);
  const words = written.flatMap(({lines}) => lines);
  const near = marks.filter((mark) => mark.line !== seam?.line && isAround(outer.box, mark.at));
  const within = near.filter(({at}) => isInside(outer.rim, at));
  const grain = grainOf(within, written);
  const fold = saysFold(words) ? foldOf(runs, outer, seam, written) : undefined;
  const drills = within.filter(isDrill);
  const inner = within.filter((mark) => mark !== grain && !drills.includes(mark) && isLong(mark));
  return {
    quantity: countOf(words) ?? {asDrawn: 1, mirrored: 0},
    sewn: runs,
    ...(seam && {cut: runsOf(outer.line)}),
    holes: [],
    notches: notchesOf(near, sewn, outer),
    ...(grain && {grain: grainEnds(grain)}),
    ...(fold && {fold: [fold.start, endOf(fold)]}),
    internalLines: inner.map(({points}) => points),
    drillHoles: drills.map(middleOf),
    words,
  };
}

/** Distance outside an outline at which notches are accepted. [mm] */
const outside = 20;

const isAround = ({low, high}: Box, [x, y]: Point): boolean =>
  x > low[0] - outside && x < high[0] + outside && y > low[1] - outside && y < high[1] + outside;
