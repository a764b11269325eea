/** The pieces of a garment as they are cut: in their own coordinates, and laid. Lengths in cm. */
import {mappedFold} from '../model/garment/folds.js';
import type {PanelMarks} from '../model/garment/panel-marks.js';
import {
  angleOf,
  onPiece,
  onPrint,
  wrapped,
  type Alignment,
  type Point,
} from '../model/geometry/vectors.js';
import type {Delivered, Print} from '../model/print/repeating-print.js';
import type {Pattern} from '../model/result/result.js';
import {seamLetters} from '../scene/seam-letters.js';
import type {AllowanceRule} from './allowance-rule.js';
import {cutPiece, type CutPiece} from './cut-piece.js';
import {largerPiece} from './larger-piece.js';
import {cutLinesOf} from './cut-line.js';
import type {LaidPiece} from './cut-sheet.js';
import type {LengthStyle} from './fold-marks.js';
import {garmentNotches} from './notches.js';
import {pieceMarks} from './piece-marks.js';
import {matchTicks} from './ticks.js';

/** The part of a result that its pieces need. */
export type SolvedPattern = Omit<Pattern, 'print'>;

interface PieceOptions extends AllowanceRule, Partial<LengthStyle> {
  /** Names of pieces that are cut from plain fabric. */
  readonly plain?: readonly string[];
  /** The printed fabric before its wash, for which pieces are cut larger. */
  readonly delivered?: Delivered | undefined;
}

/** Distance from a sewn line to the centre of its letter. */
const letterRoom = 0.6;

/** Transforms from piece coordinates to the sheet. */
const placed = (place: Alignment) => {
  const onto = (p: Point): Point => onPiece(place, p);
  return {
    onto,
    line: (points: readonly Point[]): readonly Point[] => points.map(onto),
    pair: ([from, to]: readonly [Point, Point]): readonly [Point, Point] => [onto(from), onto(to)],
    angle: (way: Point): number => wrapped(angleOf(way) + place.angle),
  };
};

/** A piece in its place on a cutting sheet, or on fabric. */
export function laidPiece(
  piece: CutPiece,
  place: Alignment,
  {
    print,
    words,
    material,
  }: {
    readonly print: Print | undefined;
    readonly words: readonly string[];
    readonly material: string | undefined;
  },
): LaidPiece {
  const {onto, line, pair, angle} = placed(place);
  const {stripe, plaid} = piece;
  return {
    ...{name: piece.name, label: piece.label, copy: 1, place, words, quantity: piece.quantity},
    ...(print && {alignment: piece.alignment}),
    ...(material !== undefined && {material}),
    cut: piece.cut.map(line),
    sewn: piece.sewn.map(line),
    corners: line(piece.corners),
    notches: piece.notches.map(({at, outward, width, depth, seam}) => ({
      ...{at: onto(at), angle: angle(outward), allowanceCm: width, depthCm: depth},
      ...(seam !== undefined && {seam}),
    })),
    grain: pair(piece.grain),
    matchPoints: piece.matches.map((p, k) => ({at: onto(p), number: k + 1})),
    ticks: piece.ticks.map(({at, along, label, seam}) => ({
      ...{at: onto(at), angle: angle(along), label, seam},
    })),
    ...(stripe && {stripe: pair(stripe)}),
    ...(plaid && {plaid: pair(plaid)}),
    letters: piece.letters.map(({letter, at}) => ({letter, at: onto(at)})),
    internalLines: piece.internalLines.map(line),
    folds: piece.folds.map((fold) => mappedFold(fold, onto)),
    drillHoles: line(piece.drillHoles),
    marks: pieceMarks(piece, {print, words, onto}),
  };
}

/**
 * The pieces of a garment with all of their marks, in coordinates of their shapes.
 * @param print undefined for plain fabric only
 * @param panels marks from the garment file, by piece name
 */
export function cutPieces(
  result: SolvedPattern,
  print: Print | undefined,
  panels: ReadonlyMap<string, PanelMarks>,
  {plain = [], units = 'cm', locale = 'en', delivered, ...rule}: PieceOptions,
): readonly CutPiece[] {
  const letters = seamLetters(result, letterRoom);
  const {marks, garment, allowances, loops: all, cut} = cutLinesOf(result, panels, rule);
  const notches = garmentNotches(garment, result.pieces, marks, allowances.widths);
  const cuts = result.pieces.map((piece, k) => {
    const loops = all[k] ?? [];
    const edges = loops.flat();
    return cutPiece(piece, marks[k] ?? {label: piece.name}, {
      print: plain.includes(piece.name) ? undefined : print,
      ...{letters: letters[k] ?? [], notches: notches[k] ?? [], lengths: {units, locale}},
      sewn: loops.map((loop) => loop.flatMap(({points}) => points.slice(0, -1))),
      cut: cut[k] ?? [],
      corners: edges.flatMap(({points}) => points.slice(0, 1)),
      allowances: edges.map(({key}) => ({
        widthCm: allowances.widths.get(key) ?? 0,
        isHem: allowances.hems.has(key),
        isOwn: allowances.own.has(key),
      })),
    });
  });
  const ticks = print
    ? matchTicks(result, print, (k) => {
        const {alignment, matches: [first] = []} = cuts[k] ?? {};
        return alignment && first && onPrint(alignment, first);
      })
    : [];
  return cuts.map((cut, k) => {
    const whole = {...cut, ticks: ticks[k] ?? []};
    return plain.includes(cut.name) ? whole : largerPiece(whole, delivered);
  });
}
