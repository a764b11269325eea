/**
 * Pages that help to place paper pieces on fabric that is printed already. Each piece has an
 * overview with two or three points, and the print around each of them. Lengths in cm.
 */
import type {LaidPiece} from '../cutting/cut-sheet.js';
import {lineColours} from '../cutting/line-colours.js';
import {colourOf} from '../files/base/colours.js';
import {box, filledWith, line, nums, scoped, strokedWith, through} from '../files/pdf/content.js';
import type {PdfResources} from '../files/pdf/resources.js';
import {textAt, widthOf} from '../files/pdf/text.js';
import type {SheetTexts} from '../texts/sheet-texts.js';
import type {Writing} from './writing.js';
import {formatLength, type Units} from '../model/base/length-text.js';
import {
  distance,
  middle,
  minus,
  plus,
  towards,
  unit,
  type Point,
} from '../model/geometry/vectors.js';
import {boxOf, type Box} from '../model/geometry/polyline.js';
import type {Print} from '../model/print/repeating-print.js';
import {boxAt} from './boxes.js';
import {fabricUnder, type Cell} from './cell.js';
import type {PageLayout} from './pages.js';
import {motifsOf} from './guide-motifs.js';
import {placingPoints, type PlacingPoint} from './placing-points.js';

export interface GuideOptions {
  readonly units: Units;
  /** Locale of numbers. Default 'en'. */
  readonly locale?: string;
}

const margin = 1;
const gap = 0.5;
const overviewWidth = 4.6;
const greatestSide = 6.2;
/** Height of a piece's name, and of the text below a picture. */
const titleHeight = 0.75;
const captionHeight = 1.05;
const blockGap = 0.6;
const headHeight = 2;
const footHeight = 0.4;
const titleSize = 0.45;
const textSize = 0.3;
const badge = 0.24;
const ringSteps = 32;
const mm = 0.1;
/** Opacity of the paper over the fabric. */
const paperShare = 0.6;
/** Space around a point and its motif in a picture. */
const rim = 0.9;
/** Smaller offsets are not mentioned. */
const leastOffset = 0.05;

/** The arrangement of a guide on pages of one size. */
interface GuideLayout {
  readonly side: number;
  /** Greatest number of points of a piece. */
  readonly points: number;
  /** Pictures beside each other, and rows of them. */
  readonly across: number;
  readonly down: number;
  readonly blockWidth: number;
  readonly blockHeight: number;
  readonly columns: number;
  readonly rows: number;
}

function arranged({widthCm, heightCm}: PageLayout): GuideLayout {
  const [width, height] = [widthCm - 2 * margin, heightCm - 2 * margin];
  const room = width - overviewWidth - gap;
  const free = height - headHeight - footHeight + blockGap;
  const words = titleHeight + captionHeight + blockGap;
  const most = Math.max(1, Math.round(free / (greatestSide + words)));
  const side = Math.min(greatestSide, room, free / most - words);
  const across = Math.min(3, Math.max(1, Math.floor((room + gap + 1e-6) / (side + gap))));
  const points = Math.max(2, across);
  const down = Math.ceil(points / across);
  const blockWidth = overviewWidth + across * (side + gap);
  const blockHeight = titleHeight + down * (side + captionHeight);
  return {
    ...{side, points, across, down, blockWidth, blockHeight},
    columns: Math.max(1, Math.floor((width + 2 * gap) / (blockWidth + 2 * gap))),
    rows: Math.max(1, Math.floor(free / (blockHeight + blockGap) + 1e-9)),
  };
}

/** Pieces on printed fabric. */
const printed = (pieces: readonly LaidPiece[]): readonly LaidPiece[] =>
  pieces.filter(({alignment}) => alignment !== undefined);

/** The number of guide pages. */
export function guideCount(layout: PageLayout, pieces: readonly LaidPiece[]): number {
  const {columns, rows} = arranged(layout);
  return Math.ceil(printed(pieces).length / (columns * rows));
}

const ring = (at: Point, radius: number): readonly Point[] =>
  Array.from({length: ringSteps}, (_, k) =>
    plus(at, towards((2 * Math.PI * k) / ringSteps), radius),
  );

const colour = (layer: 'cut' | 'matches' | 'words') =>
  colourOf(lineColours[layer].hex) ?? [0, 0, 0];
const [cutColour, markColour, ink] = [colour('cut'), colour('matches'), colour('words')];
const white = [1, 1, 1] as const;
const width = (millimetres: number): string => `${nums(millimetres * mm)} w`;

/** A line with a light one beneath, visible on any print. */
const haloed = (path: string, millimetres: number, by: readonly [number, number, number]): string =>
  [
    `${strokedWith(white)} ${width(millimetres + 0.7)}\n${path}\nS`,
    `${strokedWith(by)} ${width(millimetres)}\n${path}\nS`,
  ].join('\n');

const badgeAt = (resources: PdfResources, at: Point, number: number): string =>
  [
    `${filledWith(ink)} ${strokedWith(white)} ${width(0.4)}`,
    `${line(ring(at, badge), true)}\nB`,
    filledWith(white),
    textAt(resources, plus(at, [0, -0.11]), String(number), {
      ...{size: 0.32, weight: 'bold', align: 'middle'},
    }),
    filledWith(ink),
  ].join('\n');

interface Drawing extends Writing {
  readonly cell: Cell;
}

/** A part of the sheet on the page, at a scale. */
interface Framed {
  /** On the page. */
  readonly frame: Box;
  /** The middle of the frame on the sheet. */
  readonly at: Point;
  readonly scale: number;
}

const onPage = ({frame, at, scale}: Framed, p: Point): Point =>
  plus(middle(frame.low, frame.high), minus(p, at), scale);

/** The paper piece on its fabric in a frame. */
function drawnFabric(
  {place, alignment, cut}: LaidPiece,
  framed: Framed,
  {resources, cell}: Drawing,
  isPieceOnly: boolean,
): string {
  const {frame, at, scale} = framed;
  const [w, h] = [frame.high[0] - frame.low[0], frame.high[1] - frame.low[1]];
  const seen = boxAt([at[0] - w / scale / 2, at[1] - h / scale / 2], w / scale, h / scale);
  const corners: readonly Point[] = [
    ...[seen.low, [seen.high[0], seen.low[1]] as const],
    ...[seen.high, [seen.low[0], seen.high[1]] as const],
  ];
  const shift = onPage(framed, [0, 0]);
  const path = cut.map((loop) => line(loop, true)).join('\n');
  const fabric = {place, cut: isPieceOnly ? cut : [corners], ...(alignment && {alignment})};
  return scoped(
    `${box(frame.low, w, h)}\nW n`,
    through({xx: scale, xy: 0, yx: 0, yy: scale, shift}),
    fabricUnder(resources, cell, fabric, {window: seen}),
    isPieceOnly
      ? ''
      : scoped(`/${resources.opacity(paperShare)} gs`, filledWith(white), path, 'f*'),
    `${nums((0.5 * mm) / scale)} w ${strokedWith(cutColour)}\n${path}\nS`,
  );
}

/** The horizontal and vertical distance of a motif from a point, as arrows meeting at a corner. */
function drawnOffset(from: Point, to: Point): string {
  const turn: Point = [to[0], from[1]];
  return [[from, turn] as const, [turn, to] as const]
    .filter(([a, b]) => distance(a, b) > badge)
    .map(([a, b]) => {
      const along = unit(minus(b, a));
      const side: Point = [-along[1] * 0.09, along[0] * 0.09];
      const neck = plus(b, along, -0.2);
      const tip = [plus(neck, side), b, plus(neck, side, -1)];
      return haloed(`${line([a, b])}\n${line(tip)}`, 0.35, ink);
    })
    .join('\n');
}

function offsetWords(
  {at, motif}: PlacingPoint,
  {units, locale = 'en'}: GuideOptions,
  texts: SheetTexts,
): string {
  const [dx, dy] = minus(motif, at);
  const length = (cm: number): string => formatLength(Math.abs(cm), units, locale);
  const parts = [
    ...(Math.abs(dx) < leastOffset ? [] : [texts[dx > 0 ? 'right' : 'left'](length(dx))]),
    ...(Math.abs(dy) < leastOffset ? [] : [texts[dy > 0 ? 'above' : 'below'](length(dy))]),
  ];
  return parts.length === 0 ? texts.here : texts.motif(parts.join(', '));
}

const scales = [1, 0.5, 0.25] as const;
const scaleWords = ['trueSize', 'halfSize', 'quarterSize'] as const;

/** The print around a point and its motif, at true size if they fit, with a text below. */
function drawnPoint(
  piece: LaidPiece,
  point: PlacingPoint,
  {number, frame}: {readonly number: number; readonly frame: Box},
  drawing: Drawing,
  options: GuideOptions,
): string {
  const {resources, texts} = drawing;
  const {name, at, motif, radius} = point;
  const {low, high} = boxOf([
    ...[plus(at, [-rim, -rim]), plus(at, [rim, rim])],
    ...[plus(motif, [-radius - 0.2, -radius - 0.2]), plus(motif, [radius + 0.2, radius + 0.2])],
  ]);
  const side = frame.high[0] - frame.low[0];
  const need = Math.max(high[0] - low[0], high[1] - low[1]);
  const step = Math.max(
    0,
    scales.findIndex((one) => need * one <= side),
  );
  const scale = scales[step] ?? 1;
  const framed: Framed = {frame, at: middle(low, high), scale};
  const [from, to] = [onPage(framed, at), onPage(framed, motif)];
  const [left, top] = [frame.low[0], frame.low[1] - 0.42];
  const title = `${number}  ${name}`;
  return [
    drawnFabric(piece, framed, drawing, false),
    scoped(
      `${box(frame.low, side, frame.high[1] - frame.low[1])}\nW n 1 J 1 j`,
      drawnOffset(from, to),
      haloed(line(ring(to, Math.max(0.3, radius * scale)), true), 0.5, markColour),
      haloed(
        [
          line([plus(to, [-0.25, 0]), plus(to, [0.25, 0])]),
          line([plus(to, [0, -0.25]), plus(to, [0, 0.25])]),
        ].join('\n'),
        0.35,
        markColour,
      ),
      badgeAt(resources, from, number),
    ),
    `${strokedWith([0.45, 0.45, 0.45])} ${width(0.2)}\n${box(frame.low, side, frame.high[1] - frame.low[1])} S`,
    textAt(resources, [left, top], title, {size: textSize, weight: 'bold'}),
    textAt(resources, [frame.high[0], top], texts[scaleWords[step] ?? 'trueSize'], {
      ...{size: 0.26, align: 'right'},
    }),
    textAt(resources, [left, top - 0.42], offsetWords(point, options, texts), {size: textSize}),
  ].join('\n');
}

/** A piece with its points, and the pictures around them. */
function drawnBlock(
  piece: LaidPiece,
  [left, top]: Point,
  {side, points: count, across}: GuideLayout,
  {drawing, print, options}: GuideContent,
): string {
  const {alignment, label, cut} = piece;
  if (!alignment) return '';
  const {resources, texts} = drawing;
  const motifs = motifsOf(print, drawing.cell.leaves);
  const points = placingPoints(piece, alignment, motifs, {count, texts});
  const around = boxOf(cut[0] ?? []);
  const [w, h] = [around.high[0] - around.low[0], around.high[1] - around.low[1]];
  const pad = badge + 0.1;
  const scale = Math.min((overviewWidth - 2 * pad) / w, (side - 2 * pad) / h);
  const height = h * scale + 2 * pad;
  const overview: Framed = {
    frame: boxAt([left, top - titleHeight - height], overviewWidth, height),
    at: middle(around.low, around.high),
    scale,
  };
  return [
    textAt(resources, [left, top - 0.45], label, {size: titleSize, weight: 'bold'}),
    drawnFabric(piece, overview, drawing, true),
    ...points.map(({at}, k) => badgeAt(resources, onPage(overview, at), k + 1)),
    ...points.map((point, k) => {
      const column = k % across;
      const x = left + overviewWidth + gap + column * (side + gap);
      const y = top - titleHeight - Math.floor(k / across) * (side + captionHeight) - side;
      const frame = boxAt([x, y], side, side);
      return drawnPoint(piece, point, {number: k + 1, frame}, drawing, options);
    }),
  ].join('\n');
}

interface GuideContent {
  readonly drawing: Drawing;
  readonly print: Print;
  readonly options: GuideOptions;
}

/** The text at the top, shortened to lines that fit. */
function drawnHead([left, top]: Point, room: number, {resources, texts}: Writing): string {
  const lines: string[] = [];
  for (const word of texts.guideFacts.join(' ').split(' ')) {
    const longer = `${lines.at(-1) ?? ''} ${word}`.trim();
    if (lines.length > 0 && textSize * widthOf(longer) <= room) lines.splice(-1, 1, longer);
    else lines.push(word);
  }
  return [
    textAt(resources, [left, top - 0.5], texts.guide, {size: 0.6, weight: 'bold'}),
    ...lines.map((words, k) =>
      textAt(resources, [left, top - 1.05 - 0.42 * k], words, {size: textSize}),
    ),
  ].join('\n');
}

/** Contents of the guide pages, from the lower left corner of each page. */
export function guidePages(
  pieces: readonly LaidPiece[],
  layout: PageLayout,
  content: GuideContent,
): readonly (() => string)[] {
  const form = arranged(layout);
  const {columns, rows, blockWidth, blockHeight} = form;
  const all = printed(pieces);
  const top = layout.heightCm - margin;
  return Array.from({length: guideCount(layout, pieces)}, (_, page) => () => {
    const shown = all.slice(page * columns * rows, (page + 1) * columns * rows);
    return [
      drawnHead([margin, top], layout.widthCm - 2 * margin, content.drawing),
      ...shown.map((piece, k) => {
        const at: Point = [
          margin + (k % columns) * (blockWidth + 2 * gap),
          top - headHeight - Math.floor(k / columns) * (blockHeight + blockGap),
        ];
        return drawnBlock(piece, at, form, content);
      }),
    ].join('\n');
  });
}
