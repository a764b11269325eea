/** One piece as it is cut, with all that a maker wants to find on it. Lengths in cm. */
import type {PanelMarks} from '../model/garment-marks.js';
import {
  between,
  distance,
  minus,
  plus,
  towards,
  unit,
  type Alignment,
  type Point,
} from '../model/geometry.js';
import {boxOf, linesInside} from '../model/polyline.js';
import type {Print} from '../model/print.js';
import type {ResultPiece} from '../model/result.js';
import {carried} from '../model/triangles.js';
import {grainLine, lineAt} from '../scene/grain-line.js';
import {innermost, pick} from '../scene/marks.js';
import {matchMarks} from './match-marks.js';
import type {CutNotch} from './notches.js';
import {stripeWays, type SeamTick} from './ticks.js';
import type {SeamLetter} from '../scene/seam-letters.js';

/** How much is cut beyond an edge. */
export interface EdgeAllowance {
  readonly widthCm: number;
  readonly isHem: boolean;
  /** The garment says it. */
  readonly isOwn: boolean;
}

/** Points are in the coordinates of the piece's shape. */
export interface CutPiece {
  readonly name: string;
  readonly label: string;
  readonly alignment: Alignment;
  /** The outline, then the holes. */
  readonly sewn: readonly (readonly Point[])[];
  readonly cut: readonly (readonly Point[])[];
  /** Where edges of the sewn lines meet. */
  readonly corners: readonly Point[];
  readonly notches: readonly CutNotch[];
  readonly grain: readonly [Point, Point];
  readonly letters: readonly SeamLetter[];
  /** Where the print shows one and the same point of it; none on plain cloth. */
  readonly matches: readonly Point[];
  readonly ticks: readonly SeamTick[];
  /** Lines of the print through the first of them, across and along the grain, from outline to outline. */
  readonly stripe?: readonly [Point, Point];
  readonly plaid?: readonly [Point, Point];
  /** Drawn on the piece, neither cut nor sewn. */
  readonly internalLines: readonly (readonly Point[])[];
  readonly drillHoles: readonly Point[];
  /** How many are cut. */
  readonly quantity: number;
  /** Of each of its edges. */
  readonly allowances: readonly EdgeAllowance[];
  /** A place for words, and how far it is from everything else. */
  readonly words: {readonly at: Point; readonly room: number};
}

interface CutOptions {
  readonly sewn: readonly (readonly Point[])[];
  readonly cut: readonly (readonly Point[])[];
  /** Of printed cloth. */
  readonly print: Print | undefined;
  readonly allowances: readonly EdgeAllowance[];
  readonly letters: readonly SeamLetter[];
  readonly corners: readonly Point[];
  readonly notches: readonly CutNotch[];
}

/** Lines inside follow the shape at steps of this length. */
const lineStep = 1;
/** Points that stand for the grain line when something looks for room. */
const grainSteps = 20;
/** Words keep away from matching marks by this much. */
const markRoom = 1;

const along = ([from, to]: readonly [Point, Point]): Point[] =>
  Array.from({length: grainSteps + 1}, (_, k) => between(from, to, k / grainSteps));

const around = (p: Point): Point[] =>
  [0, 1, 2, 3, 4, 5].map((k) => plus(p, towards((k * Math.PI) / 3), markRoom));

/** The stretch of a line through a point of the piece that holds that point. */
function throughPiece(
  loops: readonly (readonly Point[])[],
  at: Point,
  along: Point,
): readonly [Point, Point] | undefined {
  const {low, high} = boxOf(loops[0] ?? []);
  const far = distance(low, high);
  const onIt = (stretch: readonly [Point, Point]): number =>
    distance(stretch[0], at) + distance(at, stretch[1]) - distance(...stretch);
  return linesInside(loops, plus(at, along, -far), plus(at, along, far)).find(
    (stretch) => onIt(stretch) < 1e-6,
  );
}

/** A line with more points on it. */
export const finer = (line: readonly Point[]): readonly Point[] =>
  line.flatMap((to, k) => {
    const from = line[k - 1];
    const steps = from ? Math.max(1, Math.ceil(distance(from, to) / lineStep)) : 1;
    return Array.from({length: steps}, (_, n) => between(from ?? to, to, (n + 1) / steps));
  });

export function cutPiece(
  piece: ResultPiece,
  marks: PanelMarks,
  {print, ...given}: CutOptions,
): CutPiece {
  const {name, shape, alignment} = piece;
  const outline = pick(shape, piece.outline);
  const holes = piece.holes.map((hole) => pick(shape, hole));
  // where nobody says how the grain runs, the length of the cloth does as the piece lies on the print
  const [foot, head] = grainLine(piece, marks) ?? lineAt(piece, alignment.angle + Math.PI / 2);
  const onShape = (p: Point): Point => carried(piece.triangles, piece.rest, shape, p);
  const grain = [onShape(foot), onShape(head)] as const;
  const loops = [outline, ...holes];
  const matches = print ? matchMarks(print, alignment, loops) : [];
  const [first] = matches;
  const ways = print && stripeWays(print, alignment, unit(minus(grain[1], grain[0])));
  const [stripe, plaid] = [ways?.across, ways?.along].map((way) =>
    first && way ? throughPiece(loops, first, way) : undefined,
  );
  const {internalLines = [], drillHoles = [], quantity = 1} = marks.drafted ?? {};
  return {
    ...{name, alignment, matches, grain, ...given},
    ...(stripe && {stripe}),
    ...(plaid && {plaid}),
    label: marks.label,
    ticks: [],
    internalLines: internalLines.map((line) => finer(line).map(onShape)),
    drillHoles: drillHoles.map(onShape),
    quantity,
    words: innermost(outline, [
      ...along(grain),
      ...matches.flatMap(around),
      ...given.letters.map(({at}) => at),
      ...holes.flat(),
    ]),
  };
}
