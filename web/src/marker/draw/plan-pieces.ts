/**
 * The pieces of a layout, prepared for drawing: number, name, and crosses that align them with the
 * print. Lengths in cm on the fabric.
 */
import type {MarkerGarment} from '../../model/design/marker-garment.js';
import {finer, type CutPiece} from '../../cutting/cut-piece.js';
import type {LaidPiece} from '../../cutting/cut-sheet.js';
import {cutPieces, laidPiece} from '../../cutting/garment-pieces.js';
import {matchMarks} from '../../cutting/match-marks.js';
import {decidedOf} from '../../model/design/design.js';
import {panelMarks, type PanelMarks} from '../../model/garment/panel-marks.js';
import {signedArea} from '../../model/geometry/polyline.js';
import {
  combined,
  coordinates,
  plus,
  towards,
  type Alignment,
  type Point,
} from '../../model/geometry/vectors.js';
import type {LaidPlacement, LayPlan} from '../../model/result/marker-plan.js';
import {readable} from '../../model/garment/piece-names.js';
import type {SolveResult} from '../../model/result/result.js';
import {innermost} from '../../scene/marks.js';

/** Data about the pieces in addition to the layout. */
export interface KnownPieces {
  /** Returns the displayed name of a piece. Default: its own name, made readable. */
  readonly names?: (result: number, piece: string) => string;
  /** The garments that were laid. Their pieces have the same marks as on the cutting sheets. */
  readonly results?: readonly (SolveResult | MarkerGarment)[];
}

export interface PlanPiece {
  /** Counted from 1 in the order of the layout. */
  readonly number: number;
  readonly name: string;
  readonly cut: readonly Point[];
  /** Up to three points; none if the layout ignores the print. */
  readonly crosses: readonly Point[];
  /** The grain line; parallel to the selvedge if the grain is unknown. */
  readonly grain: readonly [Point, Point];
  /** The piece with all marks of the cutting sheet; undefined if its garment is unknown. */
  readonly laid?: LaidPiece;
}

/** The alignment of the print on the fabric. */
export const printOnFabric = (origin: Point): Alignment => ({angle: 0, translation: origin});

/**
 * Half the length of a default grain line, as a share of the radius of the piece's largest
 * inscribed circle.
 */
const grainShare = 0.8;

/** The point of a piece farthest from its cut line and from other points, with that distance. */
export const inmost = (
  cut: readonly Point[],
  others: readonly Point[] = [],
): ReturnType<typeof innermost> => innermost(finer([...cut, ...cut.slice(0, 1)]), others);

/** A grain line of a piece about which nothing else is known: along the selvedge. */
function upright(cut: readonly Point[]): readonly [Point, Point] {
  const {at, room} = inmost(cut);
  const up = towards(Math.PI / 2);
  return [plus(at, up, -grainShare * room), plus(at, up, grainShare * room)];
}

/** The pieces of a laid garment by name, in coordinates of their shapes. */
function piecesOf(
  one: SolveResult | MarkerGarment,
  {allowanceCm, hemCm, printOrigin}: LayPlan,
): ReadonlyMap<string, CutPiece> {
  const {result, garment, names, options = {}} = 'result' in one ? one : {result: one};
  const panels = garment
    ? panelMarks(garment, decidedOf({options, ...(names && {names})}))
    : new Map<string, PanelMarks>();
  const pieces = cutPieces(result, printOrigin ? result.print : undefined, panels, {
    ...{allowanceCm, delivered: result.print.delivered},
    ...(hemCm !== undefined && {hemCm}),
    ...(options.plain && {plain: options.plain}),
  });
  return new Map(pieces.map((piece) => [piece.name, piece]));
}

/** The piece where it lies. Its outer cut line is that of the layout, which decides. */
function laidAt(placement: LaidPlacement, piece: CutPiece, name: string): LaidPiece {
  const laid = laidPiece(piece, placement, {print: undefined, words: [name], material: undefined});
  return {...laid, cut: [placement.cut, ...laid.cut.filter((loop) => signedArea(loop) < 0)]};
}

/** Names of pieces, with the garment's number if there are several garments. */
export function namesIn(
  {placements, unplaced}: LayPlan,
  {names = (_, piece) => readable(piece)}: KnownPieces,
  ofGarment: (piece: string, garment: number) => string,
): (one: Pick<LaidPlacement, 'result' | 'copy' | 'piece'>) => string {
  const garments = [
    ...new Set([...placements, ...unplaced].map(({result, copy}) => `${result}.${copy}`)),
  ].sort((a, b) => a.localeCompare(b, 'en', {numeric: true}));
  return ({result, copy, piece}) => {
    const name = names(result, piece);
    return garments.length > 1 ? ofGarment(name, garments.indexOf(`${result}.${copy}`) + 1) : name;
  };
}

export function planPieces(
  plan: LayPlan,
  {results = []}: KnownPieces,
  nameOf: (one: LaidPlacement) => string,
): readonly PlanPiece[] {
  const {placements, print, printOrigin} = plan;
  const known = results.map((one) => piecesOf(one, plan));
  return placements.map((placement, k): PlanPiece => {
    const {cut} = placement;
    const piece = known[placement.result]?.get(placement.piece);
    const one = {number: k + 1, name: nameOf(placement), cut};
    if (piece) {
      const laid = laidAt(placement, piece, one.name);
      return {...one, laid, grain: laid.grain, crosses: laid.matchPoints.map(({at}) => at)};
    }
    const crosses = printOrigin ? matchMarks(print, printOnFabric(printOrigin), [cut]) : [];
    return {...one, crosses, grain: upright(cut)};
  });
}

/**
 * The corner of the print's repeat that is nearest to the fabric's lower left corner and on the
 * fabric.
 */
export function repeatCorner({
  print: {w1, w2},
  printOrigin,
  widthCm,
  lengthCm,
}: LayPlan): Point | undefined {
  if (!printOrigin) return undefined;
  const basis = [w1, w2] as const;
  const [s, t] = coordinates(basis, printOrigin);
  const steps = [-2, -1, 0, 1, 2];
  const onFabric = steps
    .flatMap((i) =>
      steps.map((j) => plus(printOrigin, combined(basis, i - Math.floor(s), j - Math.floor(t)))),
    )
    .filter(([x, y]) => x >= 0 && x <= widthCm && y >= 0 && y <= lengthCm);
  const off = ([x, y]: Point): number => x + y;
  return onFabric.length === 0
    ? undefined
    : onFabric.reduce((best, p) => (off(p) < off(best) ? p : best));
}
