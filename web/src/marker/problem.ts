/** Combines solved garments into one layout problem: pieces, fabric and settings. Lengths in cm. */
import type {MarkerGarment} from '../model/design/marker-garment.js';
import {SolverError} from '../model/base/failure.js';
import {rotated} from '../model/geometry/vectors.js';
import {layNote, type LayNote} from '../model/result/lay-note.js';
import type {MarkerPiece, MarkerProblem} from '../model/result/marker-search.js';
import type {Print} from '../model/print/repeating-print.js';
import {ruleOf} from '../cutting/allowance-rule.js';
import {checkScaled, type PrintScale} from '../model/result/unscaled-print.js';
import type {Repeat} from '../model/print/wallpaper.js';
import {uprightPieces} from './nap.js';
import {calledBy, commonPrint} from './one-print.js';
import {laidPieces, type LaidOf, type PieceOfMarker} from './pieces.js';
import {acrossRepeat, equalShifts, hasHalfTurn, warpRepeat} from './repeats.js';
import {checkedSettings, markerLimits, type MarkerSettings} from './settings.js';

/** A problem with the data to interpret its answer. */
export interface MarkerOrder {
  readonly problem: MarkerProblem;
  /** Source of each piece of the problem. */
  readonly pieces: readonly PieceOfMarker[];
  /**
   * Indices of pieces whose print moves only together, per garment with the largest group first.
   */
  readonly components: readonly (readonly number[])[];
  readonly allowanceCm: number;
  readonly hemCm: number;
  /** Notes for people. */
  readonly notes: readonly LayNote[];
}

/** Print properties in addition to its repeat. */
export type LaidPrint = Pick<Print, 'oneWay'> & PrintScale;

/** Greatest number of pieces that people cut at once and wait for. */
const mostPieces = 500;
/** Number of positions tried across the fabric for the print's origin, if it is not given. */
const phaseCount = 8;
const wrong = (message: string): SolverError => new SolverError({code: 'options', message});

/** Number of garments of each result. @throws {SolverError} unless it is a whole number in range */
function copiesOf(garments: readonly MarkerGarment[], all: number): readonly number[] {
  const [least, most] = markerLimits.copies;
  return garments.map((garment, k) => {
    const {copies = all} = garment;
    if (Number.isInteger(copies) && copies >= least && copies <= most) return copies;
    throw wrong(
      `The number of copies of ${calledBy(garment, k)} is ${String(copies)}, but must be a whole number from ${least} to ${most}.`,
    );
  });
}

/**
 * Checks the direction of napped fabric and one-way prints: an upside-down piece requires a half
 * turn of the print.
 */
function checkUpright({print, pieces, nap, ignoresPrint}: MarkerProblem): void {
  if (nap !== 'one-way' || ignoresPrint || hasHalfTurn(print)) return;
  const down = pieces.find(({alignment, up}) => rotated(up, -alignment.angle)[1] < 0);
  if (!down) return;
  throw wrong(
    `Piece '${down.name}' was solved upside down, and ${print.group} has no half turn to put it right; solve it again with a print that is one-way, or leave the nap out.`,
  );
}

function notesOf(
  garments: readonly MarkerGarment[],
  {plies = 1, startCm, flaws = [], fold = false, shift}: MarkerSettings,
  repeat: number | undefined,
): readonly LayNote[] {
  const plain = garments.flatMap(({result, options}) =>
    result.pieces.flatMap(({name}) => (options?.plain?.includes(name) ? [name] : [])),
  );
  const known: readonly (LayNote | false)[] = [
    plain.length > 0 && layNote('plainPieces', {pieces: [...new Set(plain)]}),
    plies > 1 &&
      (repeat === undefined
        ? layNote('pliesUnlike')
        : layNote('pliesWhole', {counts: [plies], lengthsCm: [repeat]})),
    flaws.length > 0 && startCm === undefined && layNote('flawsFromCut'),
    fold && shift === 'component' && layNote('foldKeepsPrint'),
  ];
  return known.filter((note) => note !== false);
}

/**
 * Builds the problem of a layout.
 * @param fabric print properties in addition to the repeat
 * @throws {SolverError} if settings, garments or pieces cannot be laid, with their name and a
 *   remedy
 */
export function markerOrder(
  garments: readonly MarkerGarment[],
  asked: MarkerSettings,
  fabric: LaidPrint = {},
): MarkerOrder {
  checkScaled(fabric);
  const {oneWay = false} = fabric;
  const settings = checkedSettings(asked);
  const {allowanceCm, hemCm} = ruleOf(asked);
  const {phaseCm, plies, ignoresPrint, flaws, nap = oneWay ? 'one-way' : 'none'} = settings;
  const copies = copiesOf(garments, settings.copies);
  const print = commonPrint(garments);
  const startCm = settings.startCm ?? (flaws.length > 0 ? 0 : undefined);
  const repeat = warpRepeat(print);
  const shifts = settings.shift === 'component' && !ignoresPrint ? equalShifts(print) : [];
  let count = 0;
  const laid = garments.flatMap((garment, k) => {
    const pieces = laidPieces(garment, k, {allowanceCm, hemCm, nap, shifts});
    return Array.from({length: copies[k] ?? 1}, (_, copy) => {
      const number = count++;
      return pieces.map((piece) => ({...piece, copy, garment: number}));
    }).flat();
  });
  if (laid.length === 0) throw wrong('All pieces are of plain fabric; there is nothing to lay.');
  if (laid.length > mostPieces) {
    throw wrong(
      `There are ${laid.length} pieces, but at most ${mostPieces} are laid at once; lay fewer garments.`,
    );
  }
  const problem: MarkerProblem = {
    print,
    pieces: nap === 'one-way' && !asked.fold ? napped(laid, print) : laid.map(pieceOf),
    ...{widthCm: settings.widthCm, selvedgeCm: settings.selvedgeCm, gapCm: settings.gapCm},
    ...{repeatTolerance: settings.repeatTolerance, nap, ignoresPrint, flaws},
    wholeRepeats: plies > 1 && repeat !== undefined && !ignoresPrint,
    phasesCm: ignoresPrint ? [0] : phasesOf(phaseCm, acrossRepeat(print, startCm !== undefined)),
    ...(startCm !== undefined && {startCm}),
    ...{widthsCm: settings.widthsCm, alsoFree: !ignoresPrint},
    ...{effort: settings.effort, seed: settings.seed},
  };
  checkUpright(problem);
  return {
    components: componentsOf(laid),
    problem,
    pieces: laid.map(({result, copy, piece, nth}) => ({
      ...{result, copy, piece},
      ...(nth !== undefined && {nth}),
    })),
    ...{allowanceCm, hemCm},
    notes: notesOf(garments, settings, repeat),
  };
}

interface Laid extends LaidOf {
  readonly garment: number;
}

const pieceOf = ({asked, garment}: Laid): MarkerPiece => ({...asked, garment});

/**
 * The pieces of a problem; those without a grain lie the same way up as far as the print allows. On
 * folded fabric, mirror images lie as the fold demands.
 */
function napped(laid: readonly Laid[], print: Repeat): readonly MarkerPiece[] {
  const upright = new Map(
    uprightPieces(
      laid.flatMap((one, k) => (one.isFree ? [{...pieceOf(one), k}] : [])),
      print,
    ).map(({k, ...piece}) => [k, piece]),
  );
  return laid.map((one, k) => upright.get(k) ?? pieceOf(one));
}

/** Indices of pieces whose print moves together: by garment, in the order of `movablePieces`. */
function componentsOf(
  laid: readonly {readonly garment: number; readonly component?: number}[],
): readonly (readonly number[])[] {
  const groups = new Map<number, number[]>();
  for (const [k, {garment, component}] of laid.entries()) {
    if (component === undefined) continue;
    const key = garment * laid.length + component;
    groups.set(key, [...(groups.get(key) ?? []), k]);
  }
  return [...groups].sort(([one], [other]) => one - other).map(([, group]) => group);
}

const phasesOf = (phase: number | undefined, repeat: number): readonly number[] =>
  phase === undefined
    ? Array.from({length: phaseCount}, (_, k) => (k * repeat) / phaseCount)
    : [phase];
