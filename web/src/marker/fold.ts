/** Cloth that is folded lengthwise, and cut through both plies at once. Lengths in cm, angles in radians. */
import {SolverError} from '../model/failure.js';
import {
  minus,
  onPiece,
  plus,
  rotated,
  wrapped,
  type Alignment,
  type MirrorMap,
  type Point,
} from '../model/geometry.js';
import {layNote} from '../model/lay-note.js';
import type {LaidPlacement, LayPlan} from '../model/lay-plan.js';
import {mirrorLines} from '../model/mirror-lines.js';
import {signedArea} from '../model/polyline.js';
import type {SolveResult} from '../model/result.js';
import type {Repeat} from '../model/wallpaper.js';
import {leastExtents} from './extents.js';
import {cutPairs, type CutPair} from './pairs.js';
import type {MarkerOrder} from './problem.js';
import {acrossRepeat} from './repeats.js';

interface FoldedOrder {
  /** One piece of each pair, on the ply to the right of the fold. */
  readonly order: MarkerOrder;
  /** Of its plan that of both plies, the cloth spread again. */
  readonly spread: (half: LayPlan) => LayPlan;
}

const wrong = (message: string): SolverError => new SolverError({code: 'options', message});

/** Mirror lines along the cloth: where one of them crosses it, from an origin of the print, and how far it is to the next. */
function linesAlong(repeat: Repeat): {readonly at: number; readonly spacing: number} {
  const lines = mirrorLines(repeat).find(({along}) => Math.abs(along[0]) < 1e-6);
  if (!lines) {
    throw wrong(
      `Along this cloth ${repeat.group} has no mirror line, so the lower ply of folded cloth would show the print wrongly; lay single cloth, or a print of pm, pmm, pmg, cm, cmm, p3m1, p31m, p4m, p4g or p6m that mirrors from side to side.`,
    );
  }
  // `offset` counts along the normal of `along`, which is across the cloth
  return {at: 0 - lines.along[1] * lines.offset, spacing: lines.spacing};
}

/** Where the fold lies on the cloth, and where the print's origin may lie from it. */
interface FoldPlaces {
  readonly foldCm: number;
  /** From the fold to an origin of the print. */
  readonly origins: readonly number[];
}

/** In the middle where the place of the print is open; else on the line of the print that is nearest to that. */
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

/** Where the mirror image of a piece lies, in the line x = 0, if the piece lies there. */
function mirroredPlace({angle, translation}: Alignment, map: MirrorMap): Alignment {
  const turned = wrapped(0 - angle - map.angle);
  const [x, y] = translation;
  return {
    angle: turned,
    translation: minus([0 - x, y], rotated(map.translation, turned)),
  };
}

/** @throws {SolverError} naming a piece that is wider than a ply, and how wide the cloth has to be */
function checkWidths({problem}: MarkerOrder, spreadOf: (width: number) => number): void {
  const {widthCm, selvedgeCm} = problem;
  for (const piece of problem.pieces) {
    const least = leastExtents(piece, problem)[0];
    const room = widthCm - 2 * selvedgeCm;
    if (least <= room + 1e-5) continue;
    const [wide, between, whole] = [least, room, spreadOf(least + 2 * selvedgeCm)];
    throw wrong(
      `${piece.name} is ${upwards(wide)} cm wide, more than the ${Math.max(0, between).toFixed(1)} cm between selvedge and fold; folded cloth has to be at least ${upwards(whole)} cm wide.`,
    );
  }
}

/** To the next millimetre. */
const upwards = (cm: number): string => (Math.ceil(10 * cm - 1e-4) / 10).toFixed(1);

/**
 * An order for folded cloth: half of its pieces, on half of the cloth.
 * @param phaseCm of the print's origin from the left edge of the cloth spread; undefined where that is open
 * @throws {SolverError} where the print has no mirror line for the fold, or a piece no mirror image
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
  // pieces keep half the gap from the fold, which takes the place of a selvedge
  const beyond = selvedgeCm - gapCm / 2;
  const halfOf = (width: number): number => width + beyond;
  const spreadOf = (width: number): number => 2 * (width - beyond);
  const ontoHalf = ([x, y]: Point): Point => [x - foldCm + beyond, y];
  const across = ([x, y]: Point): Point => [2 * foldCm - x, y];
  const half: MarkerOrder = {
    ...order,
    // the lower ply mirrors the print where it is
    ...{components: [], pieces: pairs.flatMap(({first}) => pieces[first] ?? [])},
    problem: {
      ...problem,
      pieces: pairs.flatMap(({first}) => {
        const piece = problem.pieces[first];
        // copies are cut together, so that they lie the same way
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

/** The other piece of a pair, on the lower ply once that is spread. */
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
