/**
 * Writes strokes for plotters and cutters in HP-GL. Its unit is 1/40 mm, and plotters reject
 * coordinates beyond 32767. A longer plot is divided into frames along x, the way of the paper.
 */
import {SolverError} from '../../model/base/failure.js';
import type {Point} from '../../model/geometry/vectors.js';
import {boxOf, type Box} from '../../model/geometry/polyline.js';
import {clippedTo} from './clip.js';

interface Stroke {
  readonly points: readonly Point[];
  readonly isClosed: boolean;
}

/** Text in the plotter's font, 1 cm high. */
interface Label {
  readonly words: string;
  readonly at: Point;
}

/** Strokes of one pen. Pens draw in the order of the list. */
export interface PenStrokes {
  readonly pen: number;
  readonly strokes: readonly Stroke[];
  readonly labels?: readonly Label[];
}

/** Units per centimetre. */
const units = 400;
/** Greatest coordinate. [units] */
const farthest = 32767;
/** Length of all frames but the last. [cm] */
const frameCm = 80;

const reach = farthest / units;
/** Greatest width of a plot across the paper. [cm] */
const hpglWidthCm = 2 * reach;

const place = ([x, y]: Point): string => `${Math.round(units * x)},${Math.round(units * y)}`;

function written(points: readonly Point[]): string {
  const [first, ...others] = points;
  if (!first) return '';
  return `PU;PA${place(first)};PD;${others.map((p) => `PA${place(p)};`).join('')}PU;`;
}

/** A label ends with the character ETX; plotters know printable ASCII. */
const labelled = (words: string, at: Point): string =>
  `PU;PA${place(at)};SI0.7,1;LB${words.replace(/[^ -~]/g, '?')}\x03`;

const closed = ({points, isClosed}: Stroke): readonly Point[] =>
  isClosed ? [...points, ...points.slice(0, 1)] : points;

const penLines = (lines: readonly {readonly pen: number; readonly lines: readonly string[]}[]) =>
  lines.flatMap(({pen, lines: own}) => [`SP${pen};`, ...own]);

/**
 * The HP-GL text of strokes in cm. A plot within 81.9 cm is written as it is. A larger one is moved
 * to the origin with its longer side along x. Each frame then starts at x = 0, and joins the end of
 * the one before; `FR` advances the paper by a frame, whose length `PS` states.
 * @throws {SolverError} `options` if both sides are longer than `hpglWidthCm`
 */
export function hpglText(pens: readonly PenStrokes[]): string {
  const all = pens.flatMap(({strokes}) => strokes.flatMap(({points}) => points));
  const box = boxOf(all);
  const isNear = [...box.low, ...box.high].every((far) => Math.abs(far) <= reach);
  if (all.length === 0 || isNear) {
    const lines = pens.map(({pen, strokes, labels = []}) => ({
      pen,
      lines: [
        ...strokes.map((stroke) => written(closed(stroke))),
        ...labels.map(({words, at}) => labelled(words, at)),
      ],
    }));
    return ['IN;', ...penLines(lines), 'SP0;', ''].join('\n');
  }
  return framed(pens, box);
}

/** The place of a point on the plotter, whose x axis follows the longer side. */
function onPlotter({low, high}: Box): {
  readonly lengthCm: number;
  readonly map: (point: Point) => Point;
} {
  const [across, up] = [high[0] - low[0], high[1] - low[1]];
  const [lengthCm, widthCm] = [Math.max(across, up), Math.min(across, up)];
  if (widthCm > hpglWidthCm) {
    throw new SolverError({
      code: 'options',
      message: `The sheet is ${across.toFixed(1)} x ${up.toFixed(1)} cm, but HP-GL reaches ${hpglWidthCm.toFixed(1)} cm across the paper; write it as DXF or PDF.`,
    });
  }
  // a plot wider than the positive range lies on both sides of the origin
  const shift = widthCm > reach ? -widthCm / 2 : 0;
  const map = ([x, y]: Point): Point =>
    up > across ? [y - low[1], high[0] - x + shift] : [x - low[0], y - low[1] + shift];
  return {lengthCm, map};
}

function framed(pens: readonly PenStrokes[], box: Box): string {
  const {lengthCm, map} = onPlotter(box);
  const laid = pens.map(({pen, strokes, labels = []}) => ({
    pen,
    labels: labels.map(({words, at}) => ({words, at: map(at)})),
    lines: strokes.map((stroke) => closed(stroke).map(map)),
  }));
  const frames = Array.from({length: Math.ceil(lengthCm / frameCm)}, (_, k) => {
    const [from, to] = [k * frameCm, (k + 1) * frameCm];
    return penLines(
      laid.map(({pen, lines, labels}) => ({
        pen,
        lines: [
          ...lines
            .flatMap((line) => clippedTo(line, from, to))
            .map((line) => written(line.map(([x, y]): Point => [x - from, y]))),
          ...labels
            .filter(({at: [x]}) => x >= from && x < to)
            .map(({words, at: [x, y]}) => labelled(words, [x - from, y])),
        ],
      })),
    ).join('\n');
  });
  const size = `PS${Math.round(units * frameCm)};`;
  return ['IN;', size, frames.join('\nFR;\n'), 'SP0;', ''].join('\n');
}
