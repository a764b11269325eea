/** One piece of the cutting sheet with all of its marks. Lengths in cm. */
import {foldLines} from '../model/garment/folds.js';
import {lineNamesOf} from '../model/garment/line-names.js';
import type {PanelMarks} from '../model/garment/panel-marks.js';
import {
  between,
  distance,
  minus,
  plus,
  towards,
  unit,
  type Alignment,
  type Point,
} from '../model/geometry/vectors.js';
import {boxOf, linesInside} from '../model/geometry/polyline.js';
import type {Print} from '../model/print/repeating-print.js';
import type {ResultPiece} from '../model/result/result.js';
import {carried} from '../model/geometry/triangles.js';
import {grainLine, innermost, lineAt, pick} from '../scene/marks.js';
import {cutFold, type CutFold, type LengthStyle} from './fold-marks.js';
import {matchMarks} from './match-marks.js';
import type {CutNotch} from './notches.js';
import {stripeWays, type SeamTick} from './ticks.js';
import type {SeamLetter} from '../scene/seam-letters.js';

/** The allowance of an edge. */
export interface EdgeAllowance {
  readonly widthCm: number;
  readonly isHem: boolean;
  /** Specified by the garment. */
  readonly isOwn: boolean;
}

/** A piece to cut. Points are in coordinates of its shape. */
export interface CutPiece {
  readonly name: string;
  readonly label: string;
  readonly alignment: Alignment;
  /** The outline, then the holes. */
  readonly sewn: readonly (readonly Point[])[];
  readonly cut: readonly (readonly Point[])[];
  /** Corners between edges of the sewn lines. */
  readonly corners: readonly Point[];
  readonly notches: readonly CutNotch[];
  readonly grain: readonly [Point, Point];
  readonly letters: readonly SeamLetter[];
  /** Points that show the same point of the print; empty on plain fabric. */
  readonly matches: readonly Point[];
  readonly ticks: readonly SeamTick[];
  /**
   * Lines of the print through the first match point, across and along the grain, between the
   * outlines.
   */
  readonly stripe?: readonly [Point, Point];
  readonly plaid?: readonly [Point, Point];
  /** Internal lines, which are neither cut nor sewn. */
  readonly internalLines: readonly (readonly Point[])[];
  /** Names of internal lines, such as `waist`, by their numbers. */
  readonly lineNames: readonly (string | undefined)[];
  /** Name of the grain line, if the maker draws several. */
  readonly grainName?: string;
  /** Pleats, tucks and creases. */
  readonly folds: readonly CutFold[];
  readonly drillHoles: readonly Point[];
  /** Number of copies to cut. */
  readonly quantity: number;
  /** One allowance per edge. */
  readonly allowances: readonly EdgeAllowance[];
  /** The position of the text, and its distance from all marks. */
  readonly words: {readonly at: Point; readonly room: number};
}

interface CutOptions {
  readonly sewn: readonly (readonly Point[])[];
  readonly cut: readonly (readonly Point[])[];
  /** Undefined for plain fabric. */
  readonly print: Print | undefined;
  readonly allowances: readonly EdgeAllowance[];
  readonly letters: readonly SeamLetter[];
  readonly corners: readonly Point[];
  readonly notches: readonly CutNotch[];
  readonly lengths: LengthStyle;
}

/** Step at which internal lines follow the deformed shape. */
const lineStep = 1;
/** Sample points of the grain line in the search for free space. */
const grainSteps = 20;
/** Distance of text from match points. */
const markRoom = 1;

const along = ([from, to]: readonly [Point, Point]): Point[] =>
  Array.from({length: grainSteps + 1}, (_, k) => between(from, to, k / grainSteps));

const around = (p: Point): Point[] =>
  [0, 1, 2, 3, 4, 5].map((k) => plus(p, towards((k * Math.PI) / 3), markRoom));

/** The segment of a line inside the piece that contains a given point. */
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

/** The line with additional points. */
export const finer = (line: readonly Point[]): readonly Point[] =>
  line.flatMap((to, k) => {
    const from = line[k - 1];
    const steps = from ? Math.max(1, Math.ceil(distance(from, to) / lineStep)) : 1;
    return Array.from({length: steps}, (_, n) => between(from ?? to, to, (n + 1) / steps));
  });

export function cutPiece(
  piece: ResultPiece,
  marks: PanelMarks,
  {print, lengths, ...given}: CutOptions,
): CutPiece {
  const {name, shape, alignment} = piece;
  const outline = pick(shape, piece.outline);
  const holes = piece.holes.map((hole) => pick(shape, hole));
  // without a stated grain, the warp of the alignment on the print is used
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
  const folds = (marks.drafted?.folds ?? []).map((fold) => cutFold(fold, onShape, lengths));
  return {
    ...{name, alignment, matches, grain, ...given},
    ...(stripe && {stripe}),
    ...(plaid && {plaid}),
    label: marks.label,
    ...(marks.grainName !== undefined && {grainName: marks.grainName}),
    ticks: [],
    internalLines: internalLines.map((line) => finer(line).map(onShape)),
    lineNames: lineNamesOf(marks.drafted),
    folds,
    drillHoles: drillHoles.map(onShape),
    quantity,
    words: innermost(outline, [
      ...along(grain),
      ...matches.flatMap(around),
      ...given.letters.map(({at}) => at),
      ...folds.flatMap((fold) => foldLines(fold).flatMap(along)),
      ...holes.flat(),
    ]),
  };
}
