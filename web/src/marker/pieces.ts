/** The pieces of solved garments as they are laid on cloth. Lengths in cm, angles in radians. */
import type {AllowanceRule} from '../cutting/allowances.js';
import type {GarmentPiece} from '../model/garment-document.js';
import type {PanelMarks} from '../model/garment-marks.js';
import {dot, radians, towards, type Point} from '../model/geometry.js';
import type {LaidTurns, MarkerPiece, Nap} from '../model/marker.js';
import type {GrainLock, SolveOptions} from '../model/options.js';
import type {ResultPiece} from '../model/result.js';
import {movablePieces} from './components.js';
import {calledIn, cutRings, type MarkerGarment} from './cut-rings.js';

export type {MarkerGarment} from './cut-rings.js';

/** Which piece of which garment lies where a problem has one. */
export interface PieceOfMarker {
  readonly result: number;
  readonly copy: number;
  readonly piece: string;
  /** Which of several that are cut of it for one garment, from 0. */
  readonly nth?: number;
}

interface Laying extends AllowanceRule {
  readonly nap: Nap;
  readonly shifts: readonly Point[];
}

interface LaidOf extends PieceOfMarker {
  readonly asked: Omit<MarkerPiece, 'garment'>;
  /** Of a piece whose print moves only with that of others: which of these. */
  readonly component?: number;
}

const turnsBy: Readonly<Record<GrainLock, LaidTurns>> = {
  ...{on: 'half', across: 'half', bias: 'quarter', free: 'any'},
};

const own = <T>(record: Readonly<Record<string, T>>, name: string): T | undefined =>
  Object.hasOwn(record, name) ? record[name] : undefined;

/** As the solver takes it: what was chosen for the piece, what its file says, what was chosen for all. */
function lockOf(
  {grain: {default: all, pieces = {}} = {}}: Pick<SolveOptions, 'grain'>,
  drafted: GarmentPiece | undefined,
  name: string,
): GrainLock | undefined {
  const given = own(pieces, name);
  const chosen = typeof given === 'object' ? given.lock : given;
  return chosen ?? drafted?.grain?.lock ?? all;
}

/** A grain line that rises by less of its length has no upper end. */
const leastRise = 0.2;

/** From foot to head of the grain line; up the cloth as the piece was solved, where that runs across it and stays so. */
function upOf(
  {alignment, grainAngle = Math.PI / 2}: ResultPiece,
  {grainDeg}: Pick<PanelMarks, 'grainDeg'>,
  turns: LaidTurns,
): Point {
  const warp = towards(alignment.angle + Math.PI / 2);
  const grain = towards(grainDeg === undefined ? grainAngle : radians(grainDeg));
  return turns === 'half' && Math.abs(dot(warp, grain)) < leastRise ? warp : grain;
}

/** Of all pieces of a garment together: each has to be compared with all others. */
const mostShifts = 60;

/** Evenly chosen. */
function thinned<T>(all: readonly T[], most: number): readonly T[] {
  const every = Math.max(1, Math.ceil(all.length / Math.max(1, most)));
  return all.filter((_, k) => k % every === 0);
}

/**
 * Those of one garment, once each time that they are cut.
 * @param result its number
 * @param laying how, and shifts of the print under pieces that nothing holds to it
 * @throws {SolverError} naming a piece whose cut line crosses itself
 */
export function laidPieces(
  laid: MarkerGarment,
  result: number,
  {nap, shifts, ...rule}: Laying,
): readonly Omit<LaidOf, 'copy'>[] {
  const {result: solved, options = {}} = laid;
  const {marks, rings} = cutRings(laid, rule);
  const {loose, joined} = movablePieces(solved, [...rings.keys()]);
  return [...rings].flatMap(([k, outline]) => {
    const {[k]: piece} = solved.pieces;
    const {[k]: mark = {label: ''}} = marks;
    if (!piece) return [];
    const quantity = mark.drafted?.quantity ?? 1;
    const lock = lockOf(options, mark.drafted, piece.name) ?? 'on';
    // what stands on its head is turned back by half a turn, and by no other
    const turns = nap === 'one-way' ? 'half' : turnsBy[lock];
    const asked = {
      name: calledIn(laid, piece.name),
      outline,
      alignment: piece.alignment,
      turns,
      up: upOf(piece, mark, turns),
      shifts: loose.has(k) ? thinned(shifts, mostShifts / loose.size) : [],
    };
    const component = joined.findIndex((group) => group.includes(k));
    return Array.from({length: quantity}, (_, nth) => ({
      ...{result, piece: piece.name, asked},
      ...(component >= 0 && {component}),
      ...(quantity > 1 && {nth}),
    }));
  });
}
