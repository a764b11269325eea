/**
 * The pieces of a layout, prepared for drawing: number, name, and crosses that align them with the
 * print. Lengths in cm on the fabric.
 */
import {finer} from '../../cutting/cut-piece.js';
import {matchMarks} from '../../cutting/match-marks.js';
import {
  combined,
  coordinates,
  onPiece,
  plus,
  towards,
  type Alignment,
  type Point,
} from '../../model/geometry/vectors.js';
import type {LaidPlacement, LayPlan} from '../../model/result/marker-plan.js';
import {readable} from '../../model/garment/piece-names.js';
import type {Print} from '../../model/print/repeating-print.js';
import type {ResultPiece, SolveResult} from '../../model/result/result.js';
import {carried} from '../../model/geometry/triangles.js';
import {innermost, lineAt, pick} from '../../scene/marks.js';

/** Data about the pieces in addition to the layout. */
export interface KnownPieces {
  /** Returns the displayed name of a piece. Default: its own name, made readable. */
  readonly names?: (result: number, piece: string) => string;
  /** Results that supply the grain, and the same numbered crosses as on the cutting sheets. */
  readonly results?: readonly Pick<SolveResult, 'pieces'>[];
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
}

/** The alignment of the print on the fabric. */
export const printOnFabric = (origin: Point): Alignment => ({angle: 0, translation: origin});

/**
 * Half the length of a default grain line, as a share of the radius of the piece's largest
 * inscribed circle.
 */
const grainShare = 0.8;

function crossesOf(
  place: LaidPlacement,
  known: ResultPiece | undefined,
  print: Pick<Print, 'w1' | 'w2'>,
  origin: Point,
): readonly Point[] {
  if (!known) return matchMarks(print, printOnFabric(origin), [place.cut]);
  const loops = [known.outline, ...known.holes].map((loop) => pick(known.shape, loop));
  return matchMarks(print, known.alignment, loops).map((p) => onPiece(place, p));
}

/** The point of a piece farthest from its cut line and from other points, with that distance. */
export const inmost = (
  cut: readonly Point[],
  others: readonly Point[] = [],
): ReturnType<typeof innermost> => innermost(finer([...cut, ...cut.slice(0, 1)]), others);

function grainOf(place: LaidPlacement, known: ResultPiece | undefined): readonly [Point, Point] {
  if (known?.grainAngle === undefined) {
    const {at, room} = inmost(place.cut);
    const up = towards(Math.PI / 2);
    return [plus(at, up, -grainShare * room), plus(at, up, grainShare * room)];
  }
  const {triangles, rest, shape} = known;
  const onFabric = (p: Point): Point => onPiece(place, carried(triangles, rest, shape, p));
  const [foot, head] = lineAt(known, known.grainAngle);
  return [onFabric(foot), onFabric(head)];
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
  {placements, print, printOrigin}: LayPlan,
  {results}: KnownPieces,
  nameOf: (one: LaidPlacement) => string,
): readonly PlanPiece[] {
  return placements.map((placement, k) => {
    const known = results?.[placement.result]?.pieces.find(({name}) => name === placement.piece);
    return {
      ...{number: k + 1, name: nameOf(placement), cut: placement.cut},
      crosses: printOrigin ? crossesOf(placement, known, print, printOrigin) : [],
      grain: grainOf(placement, known),
    };
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
