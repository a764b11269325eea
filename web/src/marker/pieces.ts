/** The pieces of solved garments, prepared for a layout. Lengths in cm, angles in radians. */
import type {GrainLock} from '../model/garment/grain.js';
import type {AllowanceRule} from '../cutting/allowances.js';
import type {GarmentPiece} from '../model/garment/garment-document.js';
import type {PanelMarks} from '../model/garment/panel-marks.js';
import {dot, radians, towards, type Point} from '../model/geometry/vectors.js';
import type {LaidTurns, MarkerPiece, Nap} from '../model/result/marker-search.js';
import type {SolveOptions} from '../model/design/options.js';
import type {ResultPiece} from '../model/result/result.js';
import {movablePieces} from './components.js';
import {calledIn, cutRings, type MarkerGarment} from './cut-rings.js';

export type {MarkerGarment} from './cut-rings.js';

/** Identifies the source of a problem's piece: its garment and its name there. */
export interface PieceOfMarker {
  readonly result: number;
  readonly copy: number;
  readonly piece: string;
  /** Index among several copies of the piece in one garment, from 0. */
  readonly nth?: number;
}

interface Laying extends AllowanceRule {
  readonly nap: Nap;
  readonly shifts: readonly Point[];
}

interface LaidOf extends PieceOfMarker {
  readonly asked: Omit<MarkerPiece, 'garment'>;
  /** Index of the component with which the piece's print moves, if any. */
  readonly component?: number;
}

const turnsBy: Readonly<Record<GrainLock, LaidTurns>> = {
  ...{on: 'half', across: 'half', bias: 'quarter', free: 'any'},
};

const own = <T>(record: Readonly<Record<string, T>>, name: string): T | undefined =>
  Object.hasOwn(record, name) ? record[name] : undefined;

/**
 * The grain rule of a piece, with the solver's precedence: chosen for the piece, from its file,
 * chosen for all pieces.
 */
function lockOf(
  {grain: {default: all, pieces = {}} = {}}: Pick<SolveOptions, 'grain'>,
  drafted: GarmentPiece | undefined,
  name: string,
): GrainLock | undefined {
  const given = own(pieces, name);
  const chosen = typeof given === 'object' ? given.lock : given;
  return chosen ?? drafted?.grain?.lock ?? all;
}

/** A grain line has no upper end if it rises by less than this share of its length. */
const leastRise = 0.2;

/**
 * The upward direction of a piece: from foot to head of its grain line. The warp of the solved
 * alignment replaces a grain line that runs across the fabric and stays so.
 */
function upOf(
  {alignment, grainAngle = Math.PI / 2}: ResultPiece,
  {grainDeg}: Pick<PanelMarks, 'grainDeg'>,
  turns: LaidTurns,
): Point {
  const warp = towards(alignment.angle + Math.PI / 2);
  const grain = towards(grainDeg === undefined ? grainAngle : radians(grainDeg));
  return turns === 'half' && Math.abs(dot(warp, grain)) < leastRise ? warp : grain;
}

/**
 * Greatest number of shifts of all pieces of a garment together, since each is compared with all
 * others.
 */
const mostShifts = 60;

/** A subset at even intervals. */
function thinned<T>(all: readonly T[], most: number): readonly T[] {
  const every = Math.max(1, Math.ceil(all.length / Math.max(1, most)));
  return all.filter((_, k) => k % every === 0);
}

/**
 * The pieces of one garment, each as often as it is cut.
 * @param result index of the garment
 * @param laying nap, allowances, and shifts of the print under loose pieces
 * @throws {SolverError} if a cut line crosses itself, with the piece's name
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
    // only a half turn corrects an upside-down piece
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
