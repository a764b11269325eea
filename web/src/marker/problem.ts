/** Solved garments as one problem: which pieces lie on which cloth, and how. Lengths in cm. */
import {SolverError} from '../model/failure.js';
import {distance, norm, rotated} from '../model/geometry.js';
import {layNote, type LayNote} from '../model/lay-note.js';
import type {MarkerProblem} from '../model/marker.js';
import type {Print} from '../model/print.js';
import {checkScaled, type PrintScale} from '../model/scaled.js';
import type {Repeat} from '../model/wallpaper.js';
import {laidPieces, type MarkerGarment, type PieceOfMarker} from './pieces.js';
import {acrossRepeat, equalShifts, hasHalfTurn, warpRepeat} from './repeats.js';
import {checkedSettings, type MarkerSettings} from './settings.js';

/** A problem with what it takes to read its answer. */
export interface MarkerOrder {
  readonly problem: MarkerProblem;
  /** Of each piece of the problem, which it is. */
  readonly pieces: readonly PieceOfMarker[];
  /** Numbers of pieces whose print moves only together; of each garment those of most pieces first. */
  readonly components: readonly (readonly number[])[];
  readonly allowanceCm: number;
  /** What people should know. */
  readonly notes: readonly LayNote[];
}

/** What is to be known of a print besides its repeat. */
export type LaidPrint = Pick<Print, 'oneWay'> & PrintScale;

const usualAllowance = 1;
const usualHem = 3;

/** As many as anybody cuts at once, and waits for. */
const mostPieces = 500;
/** How many places across the cloth are tried for the print's origin where nobody says it. */
const phaseCount = 8;
/** By which repeats of two results differ that are the same, as a share. */
const sameRepeat = 1e-5;

const wrong = (message: string): SolverError => new SolverError({code: 'options', message});

const calledBy = ({name}: MarkerGarment, k: number): string => name ?? `result ${k + 1}`;

/** The print of all. @throws {SolverError} where results have several */
function commonPrint(garments: readonly MarkerGarment[]): Repeat {
  const [first, ...others] = garments;
  if (!first) throw wrong('There is no result to lay; name at least one.');
  const {print} = first.result;
  const isSame = (other: Repeat): boolean =>
    other.group === print.group &&
    (['w1', 'w2'] as const).every(
      (w) => distance(other[w], print[w]) < sameRepeat * norm(print[w]),
    );
  const k = others.findIndex(({result}) => !isSame(result.print));
  const [differs] = others.slice(k);
  if (k >= 0 && differs) {
    throw wrong(
      `${calledBy(differs, k + 1)} was solved for another group or repeat than ${calledBy(first, 0)}; lay results of one print together.`,
    );
  }
  return {group: print.group, w1: print.w1, w2: print.w2};
}

/** Where a pile or a print has an upside, pieces that stand on their heads have to be turned by a half turn of the print. */
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
 * @param print what is known of it besides its repeat
 * @throws {SolverError} for settings, garments and pieces that cannot be laid, naming which and what to do
 */
export function markerOrder(
  garments: readonly MarkerGarment[],
  asked: MarkerSettings,
  cloth: LaidPrint = {},
): MarkerOrder {
  checkScaled(cloth);
  const {oneWay = false} = cloth;
  const settings = checkedSettings(asked);
  const {allowanceCm = usualAllowance, hemCm = asked.allowanceCm ?? usualHem} = settings;
  const {copies, phaseCm, plies, ignoresPrint, flaws, nap = oneWay ? 'one-way' : 'none'} = settings;
  const print = commonPrint(garments);
  const startCm = settings.startCm ?? (flaws.length > 0 ? 0 : undefined);
  const repeat = warpRepeat(print);
  const shifts = settings.shift === 'component' && !ignoresPrint ? equalShifts(print) : [];
  const laid = garments.flatMap((garment, k) => {
    const pieces = laidPieces(garment, k, {allowanceCm, hemCm, nap, shifts});
    return Array.from({length: copies}, (_, copy) =>
      pieces.map((piece) => ({...piece, copy, garment: k * copies + copy})),
    ).flat();
  });
  if (laid.length === 0) throw wrong('All pieces are of plain cloth; there is nothing to lay.');
  if (laid.length > mostPieces) {
    throw wrong(
      `There are ${laid.length} pieces, but at most ${mostPieces} are laid at once; lay fewer garments.`,
    );
  }
  const problem: MarkerProblem = {
    print,
    pieces: laid.map(({asked: piece, garment}) => ({...piece, garment})),
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
    allowanceCm,
    notes: notesOf(garments, settings, repeat),
  };
}

/** Numbers of pieces by what their print moves with: garment by garment, as `movablePieces` orders them. */
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
