/** Whether a picture goes on where its copies touch, and where it does not. */
import type {TileRepeat} from '../model/print-tile.js';
import type {Pixels} from './tile-cloth.js';

export type Side = 'left' | 'right' | 'top' | 'bottom';

/** A part of a side at which the picture breaks off; shares of that side, from its left or upper end. */
export interface OpenEdge {
  readonly side: Side;
  readonly from: number;
  readonly to: number;
}

/** Lines of pixels side by side, each from its left or upper end: red, green and blue in turn, on white. */
interface Lines {
  readonly count: number;
  readonly length: number;
  readonly colours: Float32Array;
}

/** How much the colours change from one line to another. [0, 255] */
interface Step {
  /** What all of the line changes by, as at the side of a stripe. */
  readonly whole: number;
  /** What single pixels change by beyond that, on average. */
  readonly beyond: number;
}

/** Places along a side that are marked or not. */
const places = 48;
/** What nobody sees. [0, 255] */
const leastStep = 3;
const leastLine = 12;
const leastMark = 14;
/**
 * The greatest step at a border, as a share of the greatest within. Flowers and leaves change steadily, and are
 * cut by a border that changes half as much again; squares and bands may well begin and end at it.
 */
const steady = 0.6;
const sharp = 1.1;
/** Beyond so many times the usual step, the greatest one is that of something straight. */
const straight = 5;

function linesOf({width, height, data}: Pixels, direction: 'columns' | 'rows'): Lines {
  const isColumns = direction === 'columns';
  const [count, length] = isColumns ? [width, height] : [height, width];
  const colours = new Float32Array(3 * count * length);
  for (let line = 0; line < count; line++) {
    for (let at = 0; at < length; at++) {
      const from = 4 * (isColumns ? at * width + line : line * width + at);
      const to = 3 * (line * length + at);
      const opaque = (data[from + 3] ?? 0) / 255;
      for (let k = 0; k < 3; k++) {
        colours[to + k] = opaque * (data[from + k] ?? 0) + 255 * (1 - opaque);
      }
    }
  }
  return {count, length, colours};
}

/** Colour by colour, from line `one` to line `other`, which lies `shift` pixels further along. */
function difference(lines: Lines, one: number, other: number, shift = 0): Float32Array {
  const {length, colours} = lines;
  const [from, to] = [3 * length * one, 3 * length * other];
  return Float32Array.from(
    {length: 3 * length},
    (_, k) => (colours[to + ((k + 3 * shift) % (3 * length))] ?? 0) - (colours[from + k] ?? 0),
  );
}

function stepOf(steps: Float32Array): Step {
  const length = steps.length / 3;
  const means = [0, 0, 0];
  steps.forEach((step, k) => {
    means[k % 3] = (means[k % 3] ?? 0) + step / length;
  });
  const [red = 0, green = 0, blue = 0] = means;
  let beyond = 0;
  for (let k = 0; k < steps.length; k += 3) {
    const [r = 0, g = 0, b = 0] = [steps[k], steps[k + 1], steps[k + 2]];
    beyond += Math.hypot(r - red, g - green, b - blue);
  }
  const root3 = Math.sqrt(3);
  return {whole: Math.hypot(red, green, blue) / root3, beyond: beyond / length / root3};
}

/** Of the lines within. What is sharp may lie between two lines of pixels, so every other one is compared. */
function stepsWithin(lines: Lines): {
  readonly whole: number;
  readonly beyond: number;
  readonly usual: number;
} {
  const steps = Array.from({length: Math.max(0, lines.count - 2)}, (_, k) =>
    stepOf(difference(lines, k, k + 2)),
  );
  const sorted = steps.map(({beyond}) => beyond).sort((a, b) => a - b);
  return {
    whole: Math.max(0, ...steps.map(({whole}) => whole)),
    beyond: sorted.at(-1) ?? 0,
    usual: sorted[Math.floor(sorted.length / 2)] ?? 0,
  };
}

/** The places where the last line does not go on into the first; none if it does as well as lines do within. */
function openPlaces(lines: Lines, shift: number): readonly boolean[] {
  const steps = difference(lines, lines.count - 1, 0, shift);
  const border = stepOf(steps);
  const within = stepsWithin(lines);
  const allowed = within.beyond > straight * within.usual ? sharp : steady;
  const isLine = border.whole > leastLine + sharp * within.whole;
  const isCut = border.beyond > leastStep + allowed * within.beyond;
  const count = Math.min(places, lines.length);
  if (!isLine && !isCut) return Array.from({length: count}, () => false);
  const marks = new Float32Array(count);
  for (let at = 0; at < lines.length; at++) {
    const place = Math.floor((at * count) / lines.length);
    const step = Math.hypot(...steps.subarray(3 * at, 3 * at + 3)) / Math.sqrt(3);
    marks[place] = Math.max(marks[place] ?? 0, step);
  }
  const least = Math.min(leastMark, Math.max(...marks) / 2);
  return Array.from(marks, (step) => step > least);
}

/** Neighbouring places as one. */
function stretches(side: Side, open: readonly boolean[]): readonly OpenEdge[] {
  const found: {side: Side; from: number; to: number}[] = [];
  open.forEach((isOpen, place) => {
    if (!isOpen) return;
    const [from, to] = [place / open.length, (place + 1) / open.length];
    const last = found.at(-1);
    if (last?.to === from) last.to = to;
    else found.push({side, from, to});
  });
  return found;
}

/** What lies on the other side of a border where the copy there begins half a side further on. */
const halfAside = <T>(along: readonly T[]): readonly T[] => {
  const half = Math.floor(along.length / 2);
  return [...along.slice(half), ...along.slice(0, half)];
};

/** Where a picture does not meet its copies when it is repeated in that way. None: it does everywhere. */
export function openEdges(pixels: Pixels, repeat: TileRepeat = 'straight'): readonly OpenEdge[] {
  const between = (first: Side, last: Side, isAside: boolean): readonly OpenEdge[] => {
    const lines = linesOf(pixels, first === 'left' ? 'columns' : 'rows');
    const open = openPlaces(lines, isAside ? Math.round(lines.length / 2) : 0);
    return [...stretches(first, isAside ? halfAside(open) : open), ...stretches(last, open)];
  };
  const isMirrored = {
    across: repeat === 'mirrored' || repeat === 'mirroredAcross',
    up: repeat === 'mirrored' || repeat === 'mirroredUp',
  };
  return [
    ...(isMirrored.across ? [] : between('left', 'right', repeat === 'halfDrop')),
    ...(isMirrored.up ? [] : between('top', 'bottom', repeat === 'brick')),
  ];
}
