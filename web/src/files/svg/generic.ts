/**
 * Reads pieces of SVG files from unknown programs: closed lines, with the text and marks inside.
 * [mm]
 */
import type {DrawnGrain} from '../../model/garment/grain.js';
import type {DrawnPiece, Run} from '../../model/garment/imported-drawing.js';
import {distance, middle, type Point} from '../../model/geometry/vectors.js';
import {isInside, type Box} from '../../model/geometry/polyline.js';
import {endOf} from '../base/bezier.js';
import {longerSide} from '../base/closed-lines.js';
import {runsOf} from '../base/edges.js';
import {foldsAmong} from '../base/fold-lines.js';
import {grainsAmong, usualGrain} from '../base/grain-lines.js';
import {
  cutOutNote,
  doubtOf,
  doubtfulHoles,
  gapNote,
  isNearlyClosed,
  leftOutNotes,
  mostDoubts,
} from '../base/left-out.js';
import {leastPiece, rolesOf, type Candidate, type Roles, type RolesOfPiece} from '../base/roles.js';
import {countOf, saysFold} from '../base/words.js';
import type {XmlElement} from '../base/xml.js';
import {closedStrokes, loopsOf, type Loop, type Stroke} from './nesting.js';
import {isFaint, isForHelp, isPainted} from './paint.js';
import {valentina} from './lengths.js';
import {distinctNames, labelOf, titled, type WrittenName} from './names.js';
import {
  foldOf,
  grainEnds,
  grainOf,
  straightOf,
  isDrill,
  isLetter,
  isLong,
  marksOf,
  middleOf,
  notchesOf,
  type Mark,
} from './marks.js';
import {chained, pointsOf} from './outlines.js';
import {testSquares} from './scale-box.js';
import type {DrawnText, Sheet} from './walk.js';

export interface Found {
  readonly pieces: readonly DrawnPiece[];
  readonly notes: readonly string[];
}

/** Connected lines, with the gaps between them. */
interface JoinedStroke extends Stroke {
  readonly gap: {readonly width: number; readonly at: Point};
}

/** Connected lines with the elements that draw them. */
function strokesOf({drawn}: Sheet): JoinedStroke[] {
  const drawers = drawn.flatMap((one) => one.lines.map(() => one));
  return chained(drawn.flatMap(({lines}) => lines)).map(({line, parts, gap}) => ({
    ...{line, gap},
    drawers: parts.flatMap((part) => drawers[part] ?? []),
  }));
}

/** The longer side of the largest closed line that is no frame. [mm] */
export function largestClosed(sheet: Sheet): number {
  const loops = loopsOf(strokesOf(sheet)).slice(0, 100); // only the largest
  const {pieces} = rolesOf(
    loops.map((loop) => candidateOf(loop, new Set())),
    surroundings(sheet),
  );
  const all = pieces.length > 0 ? pieces.map(({outline}) => outline) : loops;
  return Math.max(0, ...all.map(({box}) => longerSide(box)));
}

const surroundings = ({texts, page}: Sheet): Parameters<typeof rolesOf>[1] => ({
  words: texts,
  page,
});

/** GarmentCode fills its panels with this colour, and overlaps them. */
const garmentCodeFill = 'rgb(227,175,186)';

/** Greatest number of outlines, far above that of many pieces drawn twice. */
const mostOutlines = 1000;

/** Area from which closed lines count as outlines for that limit. [mm2] */
const outlineArea = 2500;

const tooMany = (count: number): string =>
  `It has ${count} closed lines of 25 cm² or more, as no pattern has; delete what is no piece.`;

/** A closed line before its role is known. */
interface LoopCandidate extends Candidate, Loop {}

function candidateOf(loop: Loop, squares: ReadonlySet<Loop['line']>): LoopCandidate {
  const [drawer] = loop.drawers;
  const isPanel = loop.drawers.some(({style}) => style.fill === garmentCodeFill);
  const isMark = squares.has(loop.line) || isLetter(loop);
  return {
    ...loop,
    ...(isPanel ? {stated: 'piece'} : isMark ? {stated: 'mark'} : hinted(loop)),
    isAside: loop.drawers.every((one) => isFaint(one) || isForHelp(one)),
    style: drawer ? (drawer.hints?.style ?? `${drawer.style.stroke} ${drawer.style.fill}`) : '',
    ...(drawer && loop.drawers.length === 1 && {path: drawer.element}),
    isEvenOdd: drawer?.style.isEvenOdd ?? false,
  };
}

function hinted({drawers}: Loop): Pick<Candidate, 'stated'> {
  const stated = drawers.flatMap(({hints}) => hints?.stated ?? [])[0];
  return stated ? {stated} : {};
}

/** @param isNamedByGroup if labels of groups name pieces, before any text */
export function genericPieces(whole: Sheet, {isNamedByGroup = false} = {}): Found {
  const painted = whole.drawn.filter(isPainted);
  const sheet = {...whole, drawn: painted};
  const strokes = strokesOf(sheet);
  const squares = testSquares(sheet);
  const closed = closedStrokes(strokes).map((loop) => candidateOf(loop, squares));
  const large = closed.filter(({area}) => area >= outlineArea);
  if (large.length > mostOutlines) return {pieces: [], notes: [tooMany(large.length)]};
  const unclosed = strokes.filter(({line}) => !line.isClosed).map(({line}) => pointsOf(line));
  const roles = rolesOf(closed, {...surroundings(sheet), open: unclosed});
  const outer = roles.pieces.map(({outline}) => outline);
  const used = new Set(
    roles.pieces.flatMap(({outline, sewn, cutOuts}) => [
      outline,
      ...(sewn ? [sewn] : []),
      ...cutOuts,
    ]),
  );
  const lines = new Set([...used].map(({line}) => line));
  const unread = new Set(
    [...roles.asides, ...roles.nested, ...roles.grids, ...roles.frames].map(({line}) => line),
  );
  const marks = marksOf(strokes.filter(({line}) => !lines.has(line) && !unread.has(line)));
  const written = roles.pieces.map(({outline}) =>
    sheet.texts.filter((text) => ownerOf(text, outer) === outline),
  );
  const names = distinctNames(
    roles.pieces.map(({outline, sewn}, k): WrittenName => {
      const others = outer.filter((other) => other !== outline);
      const byGroup = isNamedByGroup ? labelsOf(outline, others) : undefined;
      if (byGroup !== undefined) return {name: byGroup};
      const inText = titled(written[k] ?? [], sheet.program === valentina);
      if (inText) return inText;
      const label = labelsOf(sewn ?? outline, others) ?? labelsOf(outline, others);
      return {name: label ?? `piece ${k + 1}`};
    }),
  );
  const pieces = roles.pieces.map((one, k): DrawnPiece => ({
    name: names[k] ?? '',
    ...pieceOf(one, marks, written[k] ?? []),
  }));
  const open = marks.filter(
    ({line, at, points}) =>
      !line.isClosed && (isNearlyClosed(points) || !outer.some(({rim}) => isInside(rim, at))),
  );
  const gaps = new Map(strokes.map(({line, gap}) => [line, gap]));
  return {
    pieces: [...pieces, ...doubtsIn(roles)],
    notes: [
      ...unpaintedNotes(whole),
      ...roles.pieces.flatMap(({outline, doubtfulCutOuts}, k) => {
        const {name} = pieces[k] ?? {name: ''};
        return [
          gapNote(name, gaps.get(outline.line), 'down'),
          cutOutNote(name, doubtfulCutOuts, 'down'),
        ].flatMap((note) => note ?? []);
      }),
      ...leftOutNotes(roles, {
        axis: 'down',
        open: open.map(({line}) => ({points: pointsOf(line)})),
      }),
    ],
  };
}

/** Lines that may be pieces. */
const doubtsIn = ({asides, nested}: Roles<LoopCandidate>): DrawnPiece[] =>
  [...asides, ...nested]
    .filter(({area}) => area >= leastPiece)
    .slice(0, mostDoubts)
    .map((outline): DrawnPiece => {
      const {name, reason} = doubtOf(outline, nested.includes(outline), undefined, 'down');
      const roles = {outline, cutOuts: [], marks: [], doubtfulCutOuts: []};
      return {name: labelsOf(outline, []) ?? name, ...pieceOf(roles, [], []), doubt: reason};
    });

function unpaintedNotes({drawn}: Sheet): string[] {
  const count = drawn
    .filter((one) => !isPainted(one))
    .flatMap(({lines}) => lines.filter(({isClosed}) => isClosed)).length;
  return count > 0
    ? [
        `${count} closed ${count === 1 ? 'line' : 'lines'} without stroke and fill ${count === 1 ? 'is' : 'are'} left out.`,
      ]
    : [];
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

/** Returns whether a line is one of several grain lines. */
const isAmong = (points: readonly Point[], grains: readonly DrawnGrain[]): boolean =>
  grains.some(({line}) => line.every((p) => points.includes(p)));

function pieceOf(
  {outline: outer, sewn: seam, cutOuts, doubtfulCutOuts}: RolesOfPiece<LoopCandidate>,
  marks: readonly Mark[],
  written: readonly DrawnText[],
): Omit<DrawnPiece, 'name'> {
  const sewn = seam ?? outer;
  const runs = runsOf(sewn.line);
  const words = written.flatMap(({lines}) => lines);
  const near = marks.filter((mark) => mark.line !== seam?.line && isAround(outer.box, mark.at));
  const within = near.filter(({at}) => isInside(outer.rim, at));
  const drills = within.filter(isDrill);
  const long = within.filter((mark) => !drills.includes(mark) && isLong(mark));
  const labels = written.flatMap(({lines: texts, at}) => texts.map((text) => ({at, text})));
  const {folds, lines} = foldsAmong(
    long.map(({points}) => points),
    labels,
    0.1,
  );
  const unfolded = within.filter((mark) => !long.includes(mark) || lines.includes(mark.points));
  const grain = grainOf(unfolded, written);
  const grains = grainsAmong(straightOf(unfolded).map(grainEnds), labels, {
    cmPerUnit: 0.1,
    isSure: false,
  });
  const line = usualGrain(grains) ?? (grain && grainEnds(grain));
  const fold = saysFold(words) ? foldOf(runs, outer, seam, written) : undefined;
  return {
    quantity: countOf(words) ?? {asDrawn: 1, mirrored: 0},
    sewn: runs,
    ...(seam && {cut: runsOf(outer.line)}),
    holes: cutOuts.map(({line}): readonly Run[] => runsOf(line)),
    ...doubtfulHoles(cutOuts, doubtfulCutOuts),
    notches: notchesOf(near, sewn, outer),
    ...(line && {grain: line}),
    ...(grains.length > 0 && {grains}),
    ...(fold && {fold: [fold.start, endOf(fold)]}),
    ...(folds.length > 0 && {folds}),
    internalLines: lines.filter((points) => points !== grain?.points && !isAmong(points, grains)),
    drillHoles: drills.map(middleOf),
    words,
  };
}

/** Distance outside an outline at which notches are accepted. [mm] */
const outside = 20;

const isAround = ({low, high}: Box, [x, y]: Point): boolean =>
  x > low[0] - outside && x < high[0] + outside && y > low[1] - outside && y < high[1] + outside;
