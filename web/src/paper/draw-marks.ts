/** Draws lines, marks and text of pieces as page content, in cm on the sheet. */
import type {Colour} from '../files/base/colours.js';
import type {CutLine, CutMark, CutText} from '../cutting/cut-sheet.js';
import {lineColours} from '../cutting/line-colours.js';
import {plus, rotated, towards, type Point} from '../model/geometry/vectors.js';
import {boxOf, type Box} from '../model/geometry/polyline.js';
import {grown, overlap} from './boxes.js';
import {
  filledWith,
  line,
  nums,
  onLayer,
  scoped,
  strokedWith,
  through,
} from '../files/pdf/content.js';
import type {PdfResources} from '../files/pdf/resources.js';
import {textAt, widthOf, type Weight} from '../files/pdf/text.js';

/** Content names of the layers of marks. */
type MarkLayers = Readonly<Record<CutMark['layer'], string>>;

const mm = 0.1;
const leading = 1.25;
/** Opacity of the light plates and halos of marks. */
const light = 0.85;
const faint = 0.4;

const white = filledWith([1, 1, 1]);

/** The colour of `#rrggbb`. */
const colourOf = (hex: string): Colour => {
  const part = (k: number): number => parseInt(hex.slice(2 * k + 1, 2 * k + 3), 16) / 255;
  return [part(0), part(1), part(2)];
};

/** A rectangle with rounded corners, from its lower left corner. */
function roundBox([x, y]: Point, width: number, height: number, radius: number): string {
  const k = 0.5523 * radius; // a quarter circle as a cubic
  const [right, top] = [x + width, y + height];
  const curve = (...values: number[]): string => `${nums(...values)} c`;
  return [
    `${nums(x + radius, y)} m ${nums(right - radius, y)} l`,
    curve(right - radius + k, y, right, y + radius - k, right, y + radius),
    `${nums(right, top - radius)} l`,
    curve(right, top - radius + k, right - radius + k, top, right - radius, top),
    `${nums(x + radius, top)} l`,
    curve(x + radius - k, top, x, top - radius + k, x, top - radius),
    `${nums(x, y + radius)} l`,
    curve(x, y + radius - k, x + radius - k, y, x + radius, y),
    'h',
  ].join('\n');
}

function stroke({points, isClosed}: CutLine, widthMm: number, dashMm: readonly number[]): string {
  const dash = dashMm.map((part) => part * mm);
  return `${nums(widthMm * mm)} w [${nums(...dash)}] 0 d\n${line(points, isClosed)}\nS`;
}

/** A line and the halo beneath it. */
function drawnLine(mark: CutLine, resources: PdfResources): readonly [string, string] {
  const {widthMm, haloMm, dashMm = [], isFaint} = mark;
  const seen = (share: number): string => `/${resources.opacity(share)} gs`;
  const halo =
    haloMm === undefined
      ? ''
      : scoped(
          seen(isFaint ? light * faint : light),
          strokedWith([1, 1, 1]),
          stroke(mark, widthMm + haloMm, []),
        );
  const colour = strokedWith(colourOf(lineColours[mark.layer].hex));
  const drawn = `${colour}\n${stroke(mark, widthMm, dashMm)}`;
  return [halo, isFaint ? scoped(seen(faint), drawn) : drawn];
}

interface WordsBox {
  readonly width: number;
  readonly height: number;
}

const weightOf = ({weight}: CutText, k: number): Weight => weight ?? (k === 0 ? 'bold' : 'regular');

function wordsBox(mark: CutText): WordsBox {
  const {lines, sizeMm} = mark;
  const size = sizeMm * mm;
  const widths = lines.map((words, k) => size * widthOf(words, weightOf(mark, k)));
  return {width: Math.max(...widths) + size, height: size * (leading * lines.length + 0.4)};
}

/** Offset of the text's left edge from its point, as a share of its width. */
const leftShare = {left: 0, middle: -0.5, right: -1} as const;

function drawnText(mark: CutText, resources: PdfResources): string {
  const {at, lines, sizeMm, hasPlate, angle = 0, align = 'middle'} = mark;
  const size = sizeMm * mm;
  const {width, height} = wordsBox(mark);
  const [c, s] = towards(angle);
  return scoped(
    through({xx: c, xy: -s, yx: s, yy: c, shift: at}),
    hasPlate
      ? scoped(
          `/${resources.opacity(light)} gs`,
          white,
          roundBox([width * leftShare[align], -height / 2], width, height, size / 3),
          'f',
        )
      : '',
    ...lines.map((words, k) => {
      const y = size * (leading * ((lines.length - 1) / 2 - k) - 0.35);
      return textAt(resources, [0, y], words, {size, weight: weightOf(mark, k), align});
    }),
  );
}

/** The bounding box of a mark. */
export function boxOfMark(mark: CutMark): Box {
  if (mark.kind === 'line') {
    return grown(boxOf(mark.points), (mark.widthMm + (mark.haloMm ?? 0)) * mm);
  }
  const {width, height} = wordsBox(mark);
  const left = width * leftShare[mark.align ?? 'middle'];
  const corners = [left, left + width].flatMap((x) =>
    [-1, 1].map((j) => plus(mark.at, rotated([x, (j * height) / 2], mark.angle ?? 0))),
  );
  return boxOf(corners);
}

/**
 * Draws the marks in a window. Consecutive lines of a layer share their halos, which are drawn
 * beneath all of them.
 */
export function drawMarks(
  marks: readonly CutMark[],
  window: Box,
  layers: MarkLayers,
  resources: PdfResources,
): string {
  const shown = marks.filter((mark) => overlap(boxOfMark(mark), window));
  const drawn: string[] = [];
  shown.forEach((first, k) => {
    const before = shown[k - 1];
    const isRun = first.kind === 'line';
    // drawn with the previous ones
    if (isRun && before?.kind === 'line' && before.layer === first.layer) return;
    const end = shown.findIndex(
      (mark, n) => n > k && !(isRun && mark.kind === 'line' && mark.layer === first.layer),
    );
    const parts = shown
      .slice(k, end < 0 ? undefined : end)
      .map((mark) =>
        mark.kind === 'text' ? ['', drawnText(mark, resources)] : drawnLine(mark, resources),
      );
    const [below, above] = [0, 1].map((layer) => parts.map((part) => part[layer] ?? ''));
    drawn.push(onLayer(layers[first.layer], ...(below ?? []), ...(above ?? [])));
  });
  return scoped('1 j 1 J', ...drawn);
}
