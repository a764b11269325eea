/**
 * Ticks along matched seams, at which both sides show the same point of the print. Lengths in cm.
 */
import {apply, type PlaneMap} from '../model/geometry/plane-map.js';
import {
  between,
  combined,
  coordinates,
  cross,
  distance,
  minus,
  onPiece,
  onPrint,
  plus,
  rotated,
  unit,
  type Alignment,
  type Point,
} from '../model/geometry/vectors.js';
import {letters, seamLetter} from '../model/garment/letters.js';
import type {ResultSeam, SeamSide, SolveResult} from '../model/result/result.js';
import {joining, printElements, reduced, type Repeat} from '../model/print/wallpaper.js';
import {pick} from '../scene/marks.js';

export interface SeamTick {
  /** Letter of the seam, then a small one: shared by both sides of a tick, otherwise unique. */
  readonly label: string;
  /** Position on the sewn line, or beside it at the point that shows the same as the other side. */
  readonly at: Point;
  /** Unit vector along the line of the print. */
  readonly along: Point;
  readonly seam: number;
}

/** Least distance between ticks of a seam, and from its ends. */
const apart = 4;
const endRoom = 1;
/**
 * Greatest distance, at a tick, between the sewn point and the point that shows the same print as
 * the other side.
 */
const greatestMiss = 0.1;

/**
 * A crossing of a sewn line with a lattice line through `motif`: the segment, and the fraction of
 * it.
 */
interface Crossing {
  readonly step: number;
  readonly part: number;
}

/**
 * Crossings of a sewn line with whole repeats.
 * @param shares coordinates of the line's points, in repeats from the motif
 */
function crossings(shares: readonly number[]): readonly Crossing[] {
  return shares.slice(1).flatMap((to, step) => {
    const from = shares[step] ?? to;
    const [low, high] = from < to ? [from, to] : [to, from];
    const first = Math.ceil(low);
    return Array.from({length: Math.max(0, Math.ceil(high) - first)}, (_, k) => ({
      step,
      part: (first + k - from) / (to - from),
    })).sort((a, b) => a.part - b.part);
  });
}

/**
 * The image of a print point under the symmetry that brings it nearest to another point, with that
 * symmetry.
 */
function imageNear(
  elements: readonly PlaneMap[],
  repeat: Repeat,
  from: Point,
  to: Point,
): {readonly at: Point; readonly element: PlaneMap} | undefined {
  const images = elements.map((element) => {
    const image = apply(element, from);
    const at = plus(to, reduced(repeat, minus(image, to)));
    return {at, element};
  });
  return images.reduce<(typeof images)[number] | undefined>(
    (best, one) => (best && distance(best.at, to) <= distance(one.at, to) ? best : one),
    undefined,
  );
}

interface Sewn {
  readonly line: readonly Point[];
  readonly alignment: Alignment;
}

/** The ticks of one seam, each for both sides. */
function seamTicks(
  number: number,
  [a, b]: readonly [Sewn, Sewn],
  {
    repeat,
    elements,
    motif,
  }: {
    readonly repeat: Repeat;
    readonly elements: readonly PlaneMap[];
    readonly motif: Point;
  },
): readonly (readonly [SeamTick, SeamTick])[] {
  const {w1, w2} = repeat;
  const [start, end] = [a.line[0], a.line.at(-1)];
  if (!start || !end) return [];
  // use the family of lattice lines that crosses the seam more squarely
  const chord = unit(minus(onPrint(a.alignment, end), onPrint(a.alignment, start)));
  const lines = Math.abs(cross(unit(w1), chord)) > Math.abs(cross(unit(w2), chord)) ? w1 : w2;
  const across = lines === w1 ? 1 : 0;
  const onLine = a.line.map(
    (p) => coordinates([w1, w2], minus(onPrint(a.alignment, p), motif))[across],
  );
  const found: (readonly [SeamTick, SeamTick])[] = [];
  for (const {step, part} of crossings(onLine)) {
    const [p, q] = [a, b].map(({line}) => {
      const [from, to] = line.slice(step, step + 2);
      return from && to && between(from, to, part);
    });
    const image =
      p && q && imageNear(elements, repeat, onPrint(a.alignment, p), onPrint(b.alignment, q));
    if (!image) continue;
    const at = onPiece(b.alignment, image.at);
    const isNearOther = found.some(([one]) => distance(one.at, p) < apart);
    const isAtEnd = distance(p, start) < endRoom || distance(p, end) < endRoom;
    if (distance(at, q) > greatestMiss || isNearOther || isAtEnd) continue;
    const label = `${seamLetter(number)}${letters(found.length).toLowerCase()}`;
    const origin = apply(image.element, [0, 0]);
    const [way, otherWay] = [lines, minus(apply(image.element, lines), origin)];
    const turned = ({angle}: Alignment, line: Point): Point => unit(rotated(line, angle));
    found.push([
      {...{label, seam: number, at: p}, along: turned(a.alignment, way)},
      {...{label, seam: number, at}, along: turned(b.alignment, otherWay)},
    ]);
  }
  return found;
}

/**
 * The ticks of each piece.
 * @param motifOf the point of the print at a piece's crosses; undefined for plain fabric
 */
export function matchTicks(
  {pieces, seams, continuousOnly}: Pick<SolveResult, 'pieces' | 'seams' | 'continuousOnly'>,
  repeat: Repeat,
  motifOf: (piece: number) => Point | undefined,
): readonly (readonly SeamTick[])[] {
  const elements = printElements(joining(repeat, continuousOnly));
  const ticks = pieces.map((): SeamTick[] => []);
  const sewn = ({piece, vertices}: SeamSide): Sewn | undefined => {
    const {shape, alignment} = pieces[piece] ?? {};
    return shape && alignment && {line: pick(shape, vertices), alignment};
  };
  const add = (number: number, {a, b, matched}: ResultSeam): void => {
    const [motif, other, one, two] = [motifOf(a.piece), motifOf(b.piece), sewn(a), sewn(b)];
    if (!matched || !motif || !other || !one || !two) return;
    for (const [first, second] of seamTicks(number, [one, two], {repeat, elements, motif})) {
      ticks[a.piece]?.push(first);
      ticks[b.piece]?.push(second);
    }
  };
  for (const [number, seam] of seams.entries()) add(number, seam);
  return ticks;
}

/** Lattice directions nearest to across and along a line, in piece coordinates. */
export function stripeWays(
  {w1, w2}: Repeat,
  {angle}: Alignment,
  grain: Point,
): {readonly across: Point; readonly along: Point} {
  const ways = [
    [1, 0],
    [0, 1],
    [1, 1],
    [-1, 1],
  ].map(([s = 0, t = 0]) => unit(rotated(combined([w1, w2], s, t), angle)));
  const skew = (way: Point): number => Math.abs(cross(way, grain));
  const [first = grain] = ways;
  const along = ways.reduce((best, way) => (skew(way) < skew(best) - 1e-9 ? way : best), first);
  const across = ways.reduce((best, way) => (skew(way) > skew(best) + 1e-9 ? way : best), first);
  return {across, along};
}
