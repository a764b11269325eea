/**
 * Layouts on fabric that is folded lengthwise, with both plies cut at once. Lengths in cm, angles
 * in radians.
 */
import {SolverError} from '../model/base/failure.js';
import {
  minus,
  onPiece,
  plus,
  rotated,
  wrapped,
  type Alignment,
  type MirrorMap,
  type Point,
} from '../model/geometry/vectors.js';
import {layNote} from '../model/result/lay-note.js';
import type {LaidPlacement, LayPlan} from '../model/result/marker-plan.js';
import {mirrorLines} from '../model/print/mirror-lines.js';
import {signedArea} from '../model/geometry/polyline.js';
import type {SolveResult} from '../model/result/result.js';
import type {Repeat} from '../model/print/wallpaper.js';
import {leastExtents} from './places.js';
import {cutPairs, type CutPair} from './pairs.js';
import type {MarkerOrder} from './problem.js';
import {acrossRepeat} from './repeats.js';

interface FoldedOrder {
  /** One piece of each pair, on the ply to the right of the fold. */
  readonly order: MarkerOrder;
  /** Converts the layout of one ply to that of both plies, with the fabric unfolded. */
  readonly spread: (half: LayPlan) => LayPlan;
}

const wrong = (message: string): SolverError => new SolverError({code: 'options', message});

/**
 * Mirror lines along the fabric: the position of one across the fabric, relative to an origin of
 * the print, and their spacing.
 */
function linesAlong(repeat: Repeat): {readonly at: number; readonly spacing: number} {
  const lines = mirrorLines(repeat).find(({along}) => Math.abs(along[0]) < 1e-6);
  if (!lines) {
    throw wrong(
      `Along this fabric ${repeat.group} has no mirror line, so the lower ply of folded fabric would show the print wrongly; lay single fabric, or a print of pm, pmm, pmg, cm, cmm, p3m1, p31m, p4m, p4g or p6m that mirrors from side to side.`,
    );
  }
  // `offset` is measured along the normal of `along`, which points across the fabric
  return {at: 0 - lines.along[1] * lines.offset, spacing: lines.spacing};
}

/** The position of the fold on the fabric, and the possible positions of the print's origin. */
interface FoldPlaces {
  readonly foldCm: number;
  /** Distances from the fold to an origin of the print. */
  readonly origins: readonly number[];
}

/**
 * Places the fold in the middle if the print's position is open, otherwise on the print's mirror
 * line nearest to the middle.
 */
function foldPlaces(
  {problem: {print, widthCm, ignoresPrint, startCm}}: MarkerOrder,
  phaseCm: number | undefined,
): FoldPlaces {
  if (ignoresPrint) return {foldCm: widthCm / 2, origins: [0]};
  const {at, spacing} = linesAlong(print);
  if (phaseCm !== undefined) {
    const steps = Math.round((widthCm / 2 - phaseCm - at) / spacing);
    const foldCm = phaseCm + at + steps * spacing;
    return {foldCm, origins: [phaseCm - foldCm]};
  }
  const repeat = acrossRepeat(print, startCm !== undefined);
  const count = Math.max(1, Math.round(repeat / spacing));
  return {
    foldCm: widthCm / 2,
    origins: Array.from({length: count}, (_, k) => {
      const phase = widthCm / 2 - at - k * spacing;
      return phase - repeat * Math.floor(phase / repeat) - widthCm / 2;
    }),
  };
}

/** The place of a piece's mirror image in the line x = 0, for a given place of the piece. */
function mirroredPlace({angle, translation}: Alignment, map: MirrorMap): Alignment {
  const turned = wrapped(0 - angle - map.angle);
  const [x, y] = translation;
  return {
    angle: turned,
    translation: minus([0 - x, y], rotated(map.translation, turned)),
  };
}

/**
 * Checks that each piece fits one ply.
 * @throws {SolverError} with the name of a piece that is too wide and the fabric width it needs
 */
function checkWidths({problem}: MarkerOrder, spreadOf: (width: number) => number): void {
  const {widthCm, selvedgeCm} = problem;
  for (const piece of problem.pieces) {
    const least = leastExtents(piece, problem)[0];
    const room = widthCm - 2 * selvedgeCm;
    if (least <= room + 1e-5) continue;
    const [wide, between, whole] = [least, room, spreadOf(least + 2 * selvedgeCm)];
    throw wrong(
      `${piece.name} is ${upwards(wide)} cm wide, more than the ${Math.max(0, between).toFixed(1)} cm between selvedge and fold; folded fabric has to be at least ${upwards(whole)} cm wide.`,
    );
  }
}

/** Rounds a length up to the next millimetre. */
const upwards = (cm: number): string => (Math.ceil(10 * cm - 1e-4) / 10).toFixed(1);

/**
 * The order for folded fabric: half of the pieces on half of the width.
 * @param phaseCm distance of the print's origin from the left edge of the unfolded fabric;
 *   undefined if open
 * @throws {SolverError} if the print has no mirror line for the fold, or a piece has no mirror
 *   image
 */
export function foldedOrder(
  order: MarkerOrder,
  results: readonly SolveResult[],
  phaseCm: number | undefined,
): FoldedOrder {
  const {problem, pieces} = order;
  const {widthCm, selvedgeCm, gapCm} = problem;
  const {foldCm, origins} = foldPlaces(order, phaseCm);
  const pairs = cutPairs(order, results);
  // pieces keep half the gap from the fold, which replaces a selvedge
  const beyond = selvedgeCm - gapCm / 2;
  const halfOf = (width: number): number => width + beyond;
  const spreadOf = (width: number): number => 2 * (width - beyond);
  const ontoHalf = ([x, y]: Point): Point => [x - foldCm + beyond, y];
  const across = ([x, y]: Point): Point => [2 * foldCm - x, y];
  const half: MarkerOrder = {
    ...order,
    // the lower ply mirrors the print where it is, so the print cannot move under components
    ...{components: [], pieces: pairs.flatMap(({first}) => pieces[first] ?? [])},
    problem: {
      ...problem,
      pieces: pairs.flatMap(({first}) => {
        const piece = problem.pieces[first];
        // copies are cut together and therefore keep the same direction
        return piece ? [{...piece, shifts: [], garment: pieces[first]?.result ?? 0}] : [];
      }),
      widthCm: halfOf(Math.min(foldCm, widthCm - foldCm)),
      phasesCm: origins.map((origin) => origin + beyond),
      flaws: problem.flaws.flatMap((flaw) =>
        [flaw, flaw.map(across)].map((one) => one.map(ontoHalf)),
      ),
      widthsCm: phaseCm === undefined ? problem.widthsCm.map((width) => halfOf(width / 2)) : [],
    },
    notes: [...order.notes, layNote('folded', {lengthsCm: [foldCm]})],
  };
  checkWidths(half, spreadOf);
  return {
    order: half,
    spread: (plan) => {
      const right: Point = [foldCm - beyond, 0];
      const upper = plan.placements.map((one) => movedBy(one, right));
      const placements = upper.flatMap((one) => {
        const pair = pairs.find(({first}) => isPiece(order, first, one));
        return pair ? [one, lowerPly(order, pair, one, foldCm)] : [one];
      });
      const unplaced = plan.unplaced.flatMap((one) => {
        const pair = pairs.find(({first}) => isPiece(order, first, one));
        return [one, ...pieces.slice(pair?.second, pair && pair.second + 1)];
      });
      const area = placements.reduce((sum, {cut}) => sum + signedArea(cut), 0);
      return {
        ...plan,
        ...{widthCm, placements, unplaced, foldCm},
        printOrigin: plan.printOrigin && plus(plan.printOrigin, right),
        useShare: area / (widthCm * plan.lengthCm),
        phases: plan.phases.map((one) => ({...one, phaseCm: one.phaseCm + right[0]})),
        widths: plan.widths.map((one) => ({...one, widthCm: spreadOf(one.widthCm)})),
      };
    },
  };
}

type Named = Pick<LaidPlacement, 'result' | 'copy' | 'piece' | 'nth'>;

const isPiece = ({pieces}: MarkerOrder, k: number, {result, copy, piece, nth}: Named): boolean => {
  const one = pieces[k];
  return one?.result === result && one.copy === copy && one.piece === piece && one.nth === nth;
};

const movedBy = (one: LaidPlacement, by: Point): LaidPlacement => ({
  ...one,
  translation: plus(one.translation, by),
  cut: one.cut.map((p) => plus(p, by)),
});

/** The other piece of a pair, on the lower ply of the unfolded fabric. */
function lowerPly(
  {pieces, problem}: MarkerOrder,
  {second, map}: CutPair,
  upper: LaidPlacement,
  foldCm: number,
): LaidPlacement {
  const place = mirroredPlace(
    {angle: upper.angle, translation: minus(upper.translation, [foldCm, 0])},
    map,
  );
  const whole = {...place, translation: plus(place.translation, [foldCm, 0])};
  const {outline = []} = problem.pieces[second] ?? {};
  return {
    ...(pieces[second] ?? upper),
    ...whole,
    cut: outline.map((p) => onPiece(whole, p)),
  };
}
