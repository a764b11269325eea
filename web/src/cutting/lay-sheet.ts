/** Lays all pieces of a garment out on one cutting sheet at true scale. Lengths in cm. */
import type {GarmentTitle, PanelMarks} from '../model/garment/panel-marks.js';
import {
  angleOf,
  onPiece,
  onPrint,
  wrapped,
  type Alignment,
  type Point,
} from '../model/geometry/vectors.js';
import type {Print} from '../model/print/repeating-print.js';
import {checkScaled} from '../model/result/unscaled-print.js';
import type {Pattern} from '../model/result/result.js';
import type {SheetPlace} from '../model/geometry/sheet-place.js';
import {layOut, type Layout} from '../layout/layout.js';
import {placementsIn, type Placements} from '../layout/on-body.js';
import {seamLetters} from '../scene/seam-letters.js';
import {ownShare} from './allowances.js';
import {cutPiece, type CutPiece} from './cut-piece.js';
import {cutLinesOf} from './cut-line.js';
import type {CutSheet, LaidPiece} from './cut-sheet.js';
import {garmentNotches} from './notches.js';
import {pieceMarks} from './piece-marks.js';
import {matchTicks} from './ticks.js';
import {factsOf, pieceWords, type WordsOptions} from './words.js';

export interface CuttingMarks extends GarmentTitle {
  readonly panels: ReadonlyMap<string, PanelMarks>;
}

export interface SheetOptions extends WordsOptions {
  /** Names of pieces that are cut from plain fabric. */
  readonly plain?: readonly string[];
}

/** The part of a result that the cutting sheet uses. */
type SolvedPattern = Omit<Pattern, 'print'>;

/** Distance from a sewn line to the centre of its letter. */
const letterRoom = 0.6;
/** Distance between cut lines. */
const gap = 1.5;
const usualAspect = 1.4;

/** The mirror image of each piece, by index. */
const twins = ({symmetries}: SolvedPattern): ReadonlyMap<number, number> =>
  new Map(
    symmetries.flatMap((symmetry) => {
      if (symmetry.kind !== 'pair') return [];
      const [first, second] = symmetry.pieces;
      return [
        [first, second],
        [second, first],
      ] as const;
    }),
  );

/** Lays the pieces out by their cut lines. */
function laidOut(
  result: SolvedPattern,
  cuts: readonly CutPiece[],
  placements: Placements,
  aspect: number,
): Layout {
  const pieces = result.pieces.map((piece, k) => {
    const rest = cuts[k]?.cut.flat() ?? [];
    return {...piece, rest, outline: rest.map((_, n) => n)};
  });
  const spacing = {gap, below: () => gap, least: () => 0};
  return layOut({...result, pieces}, aspect, spacing, placements, {isPacked: true});
}

const placeOf = ({offset, isTurned}: SheetPlace): Alignment => ({
  angle: isTurned ? Math.PI : 0,
  translation: offset,
});

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

function laidPiece(
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
    drillHoles: line(piece.drillHoles),
    marks: pieceMarks(piece, {print, words, onto}),
  };
}

/** The pieces of a garment with all of their marks. */
function cutPieces(
  result: SolvedPattern,
  print: Print | undefined,
  {panels}: CuttingMarks,
  options: SheetOptions,
): readonly CutPiece[] {
  const {plain = []} = options;
  const letters = seamLetters(result, letterRoom);
  const {marks, garment, allowances, loops: all, cut} = cutLinesOf(result, panels, options);
  const notches = garmentNotches(garment, result.pieces, marks, allowances.widths);
  const cuts = result.pieces.map((piece, k) => {
    const loops = all[k] ?? [];
    const edges = loops.flat();
    return cutPiece(piece, marks[k] ?? {label: piece.name}, {
      print: plain.includes(piece.name) ? undefined : print,
      ...{letters: letters[k] ?? [], notches: notches[k] ?? []},
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
  return cuts.map((cut, k) => ({...cut, ticks: ticks[k] ?? []}));
}

/**
 * Cutting sheets of a result for a desired ratio of width to height, which a sheet approximates.
 * @param print undefined for plain fabric only
 * @throws {SolverError} for a print of unknown size
 */
export function sheetsOf(
  result: SolvedPattern,
  print: Print | undefined,
  marks: CuttingMarks,
  options: SheetOptions,
): (aspect: number) => CutSheet {
  if (print) checkScaled(print);
  const {plain = []} = options;
  const {title, size, panels} = marks;
  const cuts = cutPieces(result, print, marks, options);
  const twinOf = twins(result);
  const heading = [title, size].filter((word) => word !== undefined).join(', ');
  const facts = factsOf(cuts, print, options);
  return (aspect) => {
    const {places, width, height} = laidOut(result, cuts, placementsIn(panels), aspect);
    return {
      ...{widthCm: width, heightCm: height, heading, facts},
      ownAllowances: ownShare(cuts.flatMap(({allowances}) => allowances.map(({isOwn}) => isOwn))),
      ...(title !== undefined && {title}),
      ...(size !== undefined && {size}),
      pieces: cuts.map((piece, k) => {
        const cloth = plain.includes(piece.name) ? undefined : print;
        const twin = cuts[twinOf.get(k) ?? -1]?.label;
        return laidPiece(piece, placeOf(places[k] ?? {offset: [0, 0]}), {
          print: cloth,
          words: pieceWords(piece, {print: cloth, twin, heading}, options),
          material: panels.get(piece.name)?.drafted?.material,
        });
      }),
    };
  };
}

/** A sheet of usual proportions; see `sheetsOf`. */
export const cutSheet = (...asked: Parameters<typeof sheetsOf>): CutSheet =>
  sheetsOf(...asked)(usualAspect);
