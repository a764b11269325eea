/** Lays all pieces of a garment out on one cutting sheet at true scale. Lengths in cm. */
import type {GarmentTitle, PanelMarks} from '../model/garment/panel-marks.js';
import type {Alignment} from '../model/geometry/vectors.js';
import {asCut} from '../model/print/as-cut.js';
import type {Print} from '../model/print/repeating-print.js';
import {checkScaled} from '../model/result/unscaled-print.js';
import type {SheetPlace} from '../model/geometry/sheet-place.js';
import {layOut, type Layout} from '../layout/layout.js';
import {placementsIn, type Placements} from '../layout/on-body.js';
import {ownShare} from './allowances.js';
import type {CutPiece} from './cut-piece.js';
import type {CutSheet} from './cut-sheet.js';
import {cutPieces, laidPiece, type SolvedPattern} from './garment-pieces.js';
import {nestedPlaces} from './nested-places.js';
import {factsOf, pieceWords, type WordsOptions} from './words.js';

export interface CuttingMarks extends GarmentTitle {
  readonly panels: ReadonlyMap<string, PanelMarks>;
}

export interface SheetOptions extends WordsOptions {
  /** Names of pieces that are cut from plain fabric. */
  readonly plain?: readonly string[];
}

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

/** A ratio of width to height, which a sheet approximates, or a sheet of another size to lie on. */
type SheetForm = number | CutSheet;

/**
 * Cutting sheets of a result in a form.
 * @param print undefined for plain fabric only; the print after the wash of its fabric
 * @throws {SolverError} for a print of unknown size
 */
export function sheetsOf(
  result: SolvedPattern,
  print: Print | undefined,
  marks: CuttingMarks,
  options: SheetOptions,
): (form: SheetForm) => CutSheet {
  if (print) checkScaled(print);
  const {plain = []} = options;
  const {title, size, panels} = marks;
  const cuts = cutPieces(result, print, panels, {...options, delivered: print?.delivered});
  const onFabric = print && asCut(print);
  const twinOf = twins(result);
  const heading = [title, size].filter((word) => word !== undefined).join(', ');
  const facts = factsOf(cuts, onFabric, options);
  const arranged = (form: SheetForm) => {
    if (typeof form !== 'number') {
      const {widthCm, heightCm} = form;
      return {places: nestedPlaces(cuts, form), widthCm, heightCm};
    }
    const {places, width, height} = laidOut(result, cuts, placementsIn(panels), form);
    return {places: places.map(placeOf), widthCm: width, heightCm: height};
  };
  return (form) => {
    const {places, ...extent} = arranged(form);
    return {
      ...{...extent, heading, facts},
      ownAllowances: ownShare(cuts.flatMap(({allowances}) => allowances.map(({isOwn}) => isOwn))),
      ...(title !== undefined && {title}),
      ...(size !== undefined && {size}),
      ...(options.locale !== undefined && {locale: options.locale}),
      pieces: cuts.map((piece, k) => {
        const fabric = plain.includes(piece.name) ? undefined : onFabric;
        const twin = cuts[twinOf.get(k) ?? -1]?.label;
        return laidPiece(piece, places[k] ?? {angle: 0, translation: [0, 0]}, {
          print: fabric,
          words: pieceWords(piece, {print: fabric, twin, heading}, options),
          material: panels.get(piece.name)?.drafted?.material,
        });
      }),
    };
  };
}

/** A sheet of usual proportions; see `sheetsOf`. */
export const cutSheet = (...asked: Parameters<typeof sheetsOf>): CutSheet =>
  sheetsOf(...asked)(usualAspect);
