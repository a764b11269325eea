/** One piece as it is cut, with all that a maker wants to find on it. Lengths in cm. */
import type {PanelMarks} from '../model/garment-marks.js';
import {between, plus, towards, type Alignment, type Point} from '../model/geometry.js';
import type {Print} from '../model/print.js';
import type {ResultPiece} from '../model/result.js';
import {carried} from '../model/triangles.js';
import {grainLine, lineAt} from '../scene/grain-line.js';
import {innermost, pick} from '../scene/marks.js';
import {cutLine} from './cut-line.js';
import {notchMark, type OutlineMark} from './follow.js';
import {matchMarks} from './match-marks.js';
import type {SeamLetter} from '../scene/seam-letters.js';

/** Points are in the coordinates of the piece's shape. */
export interface CutPiece {
  readonly name: string;
  readonly label: string;
  readonly alignment: Alignment;
  /** The outline, then the holes. */
  readonly sewn: readonly (readonly Point[])[];
  readonly cut: readonly (readonly Point[])[];
  readonly notches: readonly OutlineMark[];
  readonly grain: readonly [Point, Point];
  readonly letters: readonly SeamLetter[];
  /** Where the print shows one and the same point of it; none on plain cloth. */
  readonly matches: readonly Point[];
  /** A place for words, and how far it is from everything else. */
  readonly words: {readonly at: Point; readonly room: number};
}

interface CutOptions {
  readonly allowanceCm: number;
  /** Cut from unprinted cloth. */
  readonly isPlain: boolean;
  readonly letters: readonly SeamLetter[];
}

/** Points that stand for the grain line when something looks for room. */
const grainSteps = 20;
/** Words keep away from matching marks by this much. */
const markRoom = 1;

const along = ([from, to]: readonly [Point, Point]): Point[] =>
  Array.from({length: grainSteps + 1}, (_, k) => between(from, to, k / grainSteps));

const around = (p: Point): Point[] =>
  [0, 1, 2, 3, 4, 5].map((k) => plus(p, towards((k * Math.PI) / 3), markRoom));

export function cutPiece(
  piece: ResultPiece,
  print: Print,
  marks: PanelMarks,
  {allowanceCm, isPlain, letters}: CutOptions,
): CutPiece {
  const {name, shape, alignment} = piece;
  const outline = pick(shape, piece.outline);
  const holes = piece.holes.map((hole) => pick(shape, hole));
  // where nobody says how the grain runs, the length of the cloth does as the piece lies on the print
  const [foot, head] = grainLine(piece, marks) ?? lineAt(piece, alignment.angle + Math.PI / 2);
  const onShape = (p: Point): Point => carried(piece.triangles, piece.rest, shape, p);
  const grain = [onShape(foot), onShape(head)] as const;
  const matches = isPlain ? [] : matchMarks(print, alignment, [outline, ...holes]);
  return {
    ...{name, alignment, matches, grain, letters},
    label: marks.label,
    sewn: [outline, ...holes],
    cut: cutLine(outline, holes, allowanceCm),
    notches: (marks.notches ?? []).flatMap((notch) => {
      const mark = notchMark(piece, notch);
      return mark ? [mark] : [];
    }),
    words: innermost(outline, [
      ...along(grain),
      ...matches.flatMap(around),
      ...letters.map(({at}) => at),
      ...holes.flat(),
    ]),
  };
}
