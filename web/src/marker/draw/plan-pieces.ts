/** Pieces of a lay plan as they are drawn: numbered, called by a name, with crosses to lay them by. Lengths in cm, on the cloth. */
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
} from '../../model/geometry.js';
import type {LaidPlacement, LayPlan} from '../../model/lay-plan.js';
import {readable} from '../../model/piece-names.js';
import type {Print} from '../../model/print.js';
import type {ResultPiece, SolveResult} from '../../model/result.js';
import {carried} from '../../model/triangles.js';
import {lineAt} from '../../scene/grain-line.js';
import {innermost, pick} from '../../scene/marks.js';

/** What is known of the pieces that are laid, beside the plan. */
export interface KnownPieces {
  /** What people call a piece. Default: its name, made readable. */
  readonly names?: (result: number, piece: string) => string;
  /** With them, crosses are those of the pieces to cut, by the same numbers, and the grain is known. */
  readonly results?: readonly Pick<SolveResult, 'pieces'>[];
}

export interface PlanPiece {
  /** From 1, in the order of the plan. */
  readonly number: number;
  readonly name: string;
  readonly cut: readonly Point[];
  /** Up to three; none where the print does not matter. */
  readonly crosses: readonly Point[];
  /** Along the cloth where nobody says how it runs. */
  readonly grain: readonly [Point, Point];
}

/** The print as it lies on the cloth. */
export const printOnCloth = (origin: Point): Alignment => ({angle: 0, translation: origin});

/** Of the greatest circle in a piece, half of a grain line where nobody knows of it. */
const grainShare = 0.8;

function crossesOf(
  place: LaidPlacement,
  known: ResultPiece | undefined,
  print: Pick<Print, 'w1' | 'w2'>,
  origin: Point,
): readonly Point[] {
  if (!known) return matchMarks(print, printOnCloth(origin), [place.cut]);
  const loops = [known.outline, ...known.holes].map((loop) => pick(known.shape, loop));
  return matchMarks(print, known.alignment, loops).map((p) => onPiece(place, p));
}

/** The point of a piece that lies furthest from its cut line and from other points, and how far. */
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
  const onCloth = (p: Point): Point => onPiece(place, carried(triangles, rest, shape, p));
  const [foot, head] = lineAt(known, known.grainAngle);
  return [onCloth(foot), onCloth(head)];
}

/** How pieces are called: with their garment where there are several. */
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

/** A corner of the print's repeat near the lower left corner of the cloth, on it. */
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
  const onCloth = steps
    .flatMap((i) =>
      steps.map((j) => plus(printOrigin, combined(basis, i - Math.floor(s), j - Math.floor(t)))),
    )
    .filter(([x, y]) => x >= 0 && x <= widthCm && y >= 0 && y <= lengthCm);
  const off = ([x, y]: Point): number => x + y;
  return onCloth.length === 0
    ? undefined
    : onCloth.reduce((best, p) => (off(p) < off(best) ? p : best));
}
