/** Notes on lines of a drawing that become neither pieces nor marks of pieces. [mm] */
import type {DrawnPiece} from '../../model/garment/imported-drawing.js';
import {distance, type Point} from '../../model/geometry/vectors.js';
import {lengthOf, signedArea} from '../../model/geometry/polyline.js';
import {longerSide, placeOf, pointText, type ClosedLine, type YAxis} from './closed-lines.js';
import type {Candidate, Roles} from './roles.js';

/** An open line outside of all pieces. */
interface OpenOutline {
  readonly points: readonly Point[];
  readonly layer?: string;
}

interface LeftOutLines {
  readonly open: readonly OpenOutline[];
  readonly axis: YAxis;
  /** Layer of a line; undefined in files without layers. */
  readonly layerOf?: (line: Candidate) => string | undefined;
}

/** Area from which an open line may be an outline. [mm2] */
const leastOutline = 2500;

/** Greatest gap of a line that was meant to close. [mm] */
const meantToClose = 5;

/** Returns whether the ends of a line nearly meet, so that it is an outline wherever it lies. */
export const isNearlyClosed = (points: readonly Point[]): boolean =>
  distance(points[0] ?? [0, 0], points.at(-1) ?? [0, 0]) <= meantToClose;

/** Size of a closed line that is more than the end of another. [mm] */
const leastNoted = 0.5;

/** Greatest number of lines of a kind with their places. */
const mostNotes = 5;

/** "they are 12 x 8 cm at (3, 4) cm; 2 x 2 cm at (9, 4) cm": sizes and places of closed lines. */
export function placesOf<T extends ClosedLine>(
  lines: readonly T[],
  axis: YAxis,
  also: (line: T) => string = () => '',
): string {
  const largest = [...lines].sort((a, b) => b.area - a.area).slice(0, mostNotes);
  const subject =
    lines.length === 1 ? 'it is' : lines.length > mostNotes ? 'the largest are' : 'they are';
  return `${subject} ${largest.map((line) => `${placeOf(line, axis)}${also(line)}`).join('; ')}`;
}

/** One sentence for each kind of line that is left out. */
export function leftOutNotes<T extends Candidate>(
  {frames, titleBoxes, copies, grids, small}: Roles<T>,
  {open, layerOf, axis}: LeftOutLines,
): string[] {
  const on = (line: Candidate): string => onLayer(layerOf?.(line));
  const noted = (lines: readonly Candidate[], rest: string): string[] => {
    if (lines.length === 0) return [];
    return [`${closedLines(lines.length)} ${rest}: left out; ${placesOf(lines, axis, on)}.`];
  };
  return [
    ...noted(frames, '(frame around pieces)'),
    ...noted(titleBoxes, '(title box)'),
    ...(grids.length > 0 ? [`A grid of ${closedLines(grids.length)} is left out.`] : []),
    ...(copies.length > 0
      ? [
          `${closedLines(copies.length)} of the same size as others at the same place ${copies.length === 1 ? 'is' : 'are'} left out.`,
        ]
      : []),
    ...noted(
      small.filter(({box}) => longerSide(box) >= leastNoted),
      'outside of pieces, marks or below 4 cm²',
    ),
    ...openNotes(open, axis),
  ];
}

const closedLines = (count: number): string => `${count} closed ${count === 1 ? 'line' : 'lines'}`;

const onLayer = (layer: string | undefined): string =>
  layer === undefined ? '' : ` on layer ${layer}`;

/** Notes on open lines that bound the area of a piece. */
export function openNotes(open: readonly OpenOutline[], axis: YAxis): string[] {
  const outlines = open
    .filter(({points}) => Math.abs(signedArea(points)) >= leastOutline)
    .sort((a, b) => lengthOf(b.points) - lengthOf(a.points));
  const notes = outlines.slice(0, mostNotes).map(({points, layer}) => {
    const from: Point = points[0] ?? [0, 0];
    const to = points.at(-1) ?? from;
    return `An outline${onLayer(layer)} does not close: its ends lie ${distance(from, to).toFixed(1)} mm apart at ${pointText(from, axis)}; join them.`;
  });
  const more = outlines.length - notes.length;
  return more > 0 ? [...notes, `${more} more outlines do not close.`] : notes;
}

/** The note on a gap that was closed; undefined if it is within the precision of files. */
export function gapNote(
  piece: string,
  gap: {readonly width: number; readonly at: Point} | undefined,
  axis: YAxis,
): string | undefined {
  if (!gap || gap.width <= reportedGap) return undefined;
  return `A gap of ${gap.width.toFixed(2)} mm in the outline of '${piece}' at ${pointText(gap.at, axis)} was closed.`;
}

/** Greatest gap that is closed without a note. */
const reportedGap = 0.1;

/** The note on cut-outs that may be drawn lines instead. */
export function cutOutNote(
  piece: string,
  lines: readonly ClosedLine[],
  axis: YAxis,
): string | undefined {
  const [first] = lines;
  if (!first) return undefined;
  const subject =
    lines.length === 1
      ? `The closed line inside '${piece}' is`
      : `${lines.length} closed lines inside '${piece}' are`;
  return `${subject} taken as cut out (${placeOf(first, axis)}); if not, draw ${lines.length === 1 ? 'it' : 'them'} on a layer or in a colour of its own.`;
}

/** The indices of doubtful cut-outs, if there are any. */
export function doubtfulHoles<T>(
  cutOuts: readonly T[],
  doubtful: readonly T[],
): Pick<DrawnPiece, 'doubtfulHoles'> {
  const indices = cutOuts.flatMap((one, k) => (doubtful.includes(one) ? [k] : []));
  return indices.length > 0 ? {doubtfulHoles: indices} : {};
}

/** The name and the reason of a line that may be a piece, and is not taken as one. */
export function doubtOf(
  line: Candidate,
  isNested: boolean,
  layer: string | undefined,
  axis: YAxis,
): {readonly name: string; readonly reason: string} {
  const reason = isNested
    ? 'it lies in another piece'
    : line.isAside === true
      ? 'its name, or its dashed or grey stroke, is that of a line for help'
      : 'it is a square or a grid for checking the size';
  return {
    name: layer === undefined ? 'closed line' : `closed line on layer ${layer}`,
    reason: `${reason} (${placeOf(line, axis)})`,
  };
}

/** Greatest number of lines that are shown as possible pieces. */
export const mostDoubts = 40;
