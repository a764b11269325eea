/**
 * Points of a paper piece by which it is placed on printed fabric: notches and corners, each with
 * the motif nearest to it. Lengths in cm on the sheet.
 */
import type {LaidPiece} from '../cutting/cut-sheet.js';
import {
  distance,
  minus,
  plus,
  towards,
  turnBetween,
  type Alignment,
  type Point,
} from '../model/geometry/vectors.js';
import {boxOf, isInside, type Box} from '../model/geometry/polyline.js';
import {seamLetter} from '../model/garment/letters.js';
import type {SheetTexts} from '../texts/sheet-texts.js';
import {onSheet} from './cell.js';
import {nearestMotif, type Motifs} from './guide-motifs.js';

export interface PlacingPoint {
  /** The place on the piece, such as `Notch of seam B`. */
  readonly name: string;
  readonly at: Point;
  /** The middle of the motif. */
  readonly motif: Point;
  readonly radius: number;
}

/** Least turn of the cut line at a corner. [rad] */
const corner = 0.6;
/** A motif beneath the paper counts as further away by this factor. */
const beneath = 1.5;
/** Distances to motifs weigh this much against the distance between two points. */
const weight = 2;
/** Least distance of a third point from the others, as a share of that between them. */
const thirdShare = 0.3;

interface Anchor {
  readonly name: string;
  readonly at: Point;
}

/** The part of a box that contains a point, such as `upper left`. */
function partOf({low, high}: Box, [x, y]: Point, {places}: SheetTexts): string {
  const word = (value: number, [least, most]: Point, words: readonly [string, string]): string => {
    const share = (value - least) / (most - least);
    return share < 1 / 3 ? words[0] : share > 2 / 3 ? words[1] : '';
  };
  const parts = [
    word(y, [low[1], high[1]], [places.lower, places.upper]),
    word(x, [low[0], high[0]], [places.left, places.right]),
  ].filter((part) => part !== '');
  return parts.length === 0 ? places.middle : parts.join(' ');
}

function anchorsOf({cut, notches, grain}: LaidPiece, texts: SheetTexts): readonly Anchor[] {
  const {points} = texts;
  const [outline = []] = cut;
  const around = boxOf(outline);
  const corners = outline.filter((p, k) => {
    const [before, next] = [outline.at(k - 1) ?? p, outline[(k + 1) % outline.length] ?? p];
    return Math.abs(turnBetween(minus(p, before), minus(next, p))) > corner;
  });
  const marked = [
    ...notches.map(({at, angle, allowanceCm, seam}) => ({
      name: seam === undefined ? points.notch : points.seamNotch(seamLetter(seam)),
      at: plus(at, towards(angle), allowanceCm),
    })),
    ...corners.map((at) => ({name: points.corner(partOf(around, at, texts)), at})),
  ];
  return marked.length > 1
    ? marked
    : [...marked, ...grain.map((at) => ({name: points.grainTip, at}))];
}

/**
 * Two or three points, far from each other and near motifs.
 * @param count greatest number of points
 */
export function placingPoints(
  piece: LaidPiece,
  alignment: Alignment,
  motifs: Motifs,
  {count, texts}: {readonly count: number; readonly texts: SheetTexts},
): readonly PlacingPoint[] {
  const lying = onSheet(piece.place, alignment);
  const [outline = []] = piece.cut;
  const {low, high} = boxOf(outline);
  const points = anchorsOf(piece, texts).map(({name, at}) => {
    const cost = (p: Point): number => distance(p, at) * (isInside(outline, p) ? beneath : 1);
    const {at: motif, radius} = nearestMotif(motifs, lying, at, cost);
    return {point: {name, at, motif, radius}, cost: weight * cost(motif)};
  });
  const worth = (from: readonly PlacingPoint[], {point, cost}: (typeof points)[number]): number =>
    Math.min(distance(low, high), ...from.map(({at}) => distance(at, point.at))) - cost;
  const bestFrom = (from: readonly PlacingPoint[]): PlacingPoint | undefined =>
    points
      .filter(({point}) => !from.includes(point))
      .reduce<(typeof points)[number] | undefined>(
        (best, one) => (best && worth(from, best) >= worth(from, one) ? best : one),
        undefined,
      )?.point;
  let pair: readonly PlacingPoint[] = points.slice(0, 1).map(({point}) => point);
  let most = -Infinity;
  points.forEach((one, k) => {
    for (const other of points.slice(k + 1)) {
      const value = worth([one.point], other) - one.cost;
      if (value <= most) continue;
      most = value;
      pair = [one.point, other.point];
    }
  });
  const [first, second] = pair;
  const third = count > 2 && first && second ? bestFrom(pair) : undefined;
  if (!first || !second || !third) return pair;
  const apart = Math.min(distance(first.at, third.at), distance(second.at, third.at));
  return apart > thirdShare * distance(first.at, second.at) ? [first, second, third] : pair;
}
