/** Pleats, tucks and creases on the cutting sheet. Lengths in cm. */
import type {DraftedFold, FoldKind} from '../model/garment/garment-document.js';
import {hidesFabric, mappedFold} from '../model/garment/folds.js';
import {distance, middle, minus, plus, unit, type Point} from '../model/geometry/vectors.js';
import {distanceTo, linesInside} from '../model/geometry/polyline.js';
import {formatLength, type Units} from '../model/base/length-text.js';

/** A fold of a piece, in coordinates of its shape. */
export interface CutFold extends Pick<DraftedFold, 'kind' | 'line' | 'to'> {
  /** Such as "Inverted pleat, 20 cm", with the width of the fabric between the lines. */
  readonly name: string;
}

type Loops = readonly (readonly Point[])[];

/** Units and locale of lengths. */
export interface LengthStyle {
  readonly units: Units;
  readonly locale: string;
}

const kindNames: Readonly<Record<FoldKind, string>> = {
  knife: 'Knife pleat',
  box: 'Box pleat',
  inverted: 'Inverted pleat',
  tuck: 'Tuck',
  roll: 'Roll line',
  press: 'Press line',
};

/** Length of an arrowhead. */
const head = 0.6;

const middleOf = ([from, to]: readonly [Point, Point]): Point => middle(from, to);

/** A fold of the garment on a solved piece; its lines stay straight. */
export function cutFold(
  drafted: DraftedFold,
  onShape: (p: Point) => Point,
  {units, locale}: LengthStyle,
): CutFold {
  const {kind, line, to} = mappedFold(drafted, onShape);
  const width = to && hidesFabric(drafted) ? distance(middleOf(line), middleOf(to)) : 0;
  const name = kindNames[kind];
  return {
    ...{kind, line},
    ...(to && {to}),
    name: width > 0 ? `${name}, ${formatLength(width, units, locale)}` : name,
  };
}

/** The lines of a fold. */
export const foldLines = ({line, to}: CutFold): readonly (readonly [Point, Point])[] =>
  to ? [line, to] : [line];

/**
 * Arrows between the lines of a pleat, each as a shaft and a head. A knife pleat and a tuck are
 * laid from one line onto the other; the lines of other pleats meet in the middle.
 */
export function foldArrows(fold: CutFold): readonly (readonly Point[])[] {
  const {kind, line, to} = fold;
  if (!to || !hidesFabric(fold)) return [];
  const [from, end] = [middleOf(line), middleOf(to)];
  const meeting = middle(from, end);
  const shafts =
    kind === 'knife' || kind === 'tuck'
      ? [[from, end] as const]
      : [[from, meeting] as const, [end, meeting] as const];
  return shafts.flatMap(([tail, tip]) => {
    const [ux, uy] = unit(minus(tip, tail));
    const side: Point = [-uy, ux];
    const foot = plus(tip, [ux, uy], -head);
    return [
      [tail, tip],
      [plus(foot, side, head / 2), tip, plus(foot, side, -head / 2)],
    ];
  });
}

/** An end of a fold line at most this far from the sewn line is on it. */
const onSewn = 0.1;
/** Width of the widest allowance, with room for slanting lines. */
const farthest = 40;

/** A fold line with the ends that are on the sewn line moved outwards to the cut line. */
export function toCutLine(
  ends: readonly [Point, Point],
  {sewn, cut}: {readonly sewn: Loops; readonly cut: Loops},
): readonly [Point, Point] {
  const [from, to] = ends;
  const along = unit(minus(to, from));
  const centre = middleOf(ends);
  const within = linesInside(cut, plus(from, along, -farthest), plus(to, along, farthest)).find(
    ([start, end]) => distance(start, centre) + distance(centre, end) < distance(start, end) + 1e-6,
  );
  const isSewn = (p: Point): boolean => sewn.some((loop) => distanceTo(loop, p) < onSewn);
  return [isSewn(from) ? (within?.[0] ?? from) : from, isSewn(to) ? (within?.[1] ?? to) : to];
}

/** Text beside a line of a fold in a DXF file, such as "inverted fold 1" or "inverted fold 1 to". */
export const foldText = (kind: FoldKind, number: number, isSecond: boolean): string =>
  `${kind} fold ${number}${isSecond ? ' to' : ''}`;
