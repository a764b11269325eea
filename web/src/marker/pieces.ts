/** The pieces of solved garments as they are laid on cloth. Lengths in cm, angles in radians. */
import type {AllowanceRule} from '../cutting/allowances.js';
import {cutLinesOf} from '../cutting/cut-lines.js';
import {decidedOf} from '../model/design.js';
import {SolverError} from '../model/failure.js';
import type {GarmentDocument, GarmentPiece} from '../model/garment-document.js';
import {panelMarks, type PanelMarks} from '../model/garment-marks.js';
import {dot, radians, towards, type Point} from '../model/geometry.js';
import type {LaidTurns, MarkerPiece, Nap} from '../model/marker.js';
import type {GrainLock, SolveOptions} from '../model/options.js';
import type {PieceNames} from '../model/piece-names.js';
import type {Problem} from '../model/problem.js';
import type {ResultPiece, SolveResult} from '../model/result.js';
import {movablePieces} from './components.js';
import {outerRing, selfCrossing} from './outline.js';

/** A solved garment, and what is known of it besides. */
export interface MarkerGarment {
  readonly result: SolveResult;
  /** What messages call it: the name of its file. */
  readonly name?: string;
  /** What the garment's file says of its pieces: allowances, grain, how many of each are cut. */
  readonly garment?: GarmentDocument;
  /** What it was solved with: grain rules, and pieces of plain cloth. */
  readonly options?: Pick<SolveOptions, 'grain' | 'plain'>;
  /** What pieces are called, where that was chosen. */
  readonly names?: PieceNames;
  /** What it answers, so that other designs of it can be solved. */
  readonly problem?: Problem;
}

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

/** Of the cut lines' rings, the outer ones. @throws {SolverError} naming a piece that cannot be laid */
function ringOf(cut: readonly (readonly Point[])[], name: string, piece: number): readonly Point[] {
  const ring = outerRing(cut);
  if (!ring) {
    const message = `Piece '${name}' has no cut line; correct its outline.`;
    throw new SolverError({code: 'outlineOpen', message, piece});
  }
  const crossing = selfCrossing(ring);
  if (crossing) {
    const [x, y] = crossing.map((part) => part.toFixed(1));
    const message = `The cut line of piece '${name}' crosses itself near (${x}, ${y}); change its outline or its allowance.`;
    throw new SolverError({code: 'outlineSelfIntersects', message, piece});
  }
  return ring;
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
  {result: solved, name: file, garment, options = {}, names}: MarkerGarment,
  result: number,
  {nap, shifts, ...rule}: Laying,
): readonly Omit<LaidOf, 'copy'>[] {
  const {plain = []} = options;
  const decided = decidedOf({options, ...(names && {names})});
  const {marks, cut} = cutLinesOf(solved, garment ? panelMarks(garment, decided) : new Map(), rule);
  const printed = [...solved.pieces.keys()].filter(
    (k) => !plain.includes(solved.pieces[k]?.name ?? ''),
  );
  const {loose, joined} = movablePieces(solved, printed);
  return printed.flatMap((k) => {
    const {[k]: piece} = solved.pieces;
    const {[k]: mark = {label: ''}} = marks;
    if (!piece) return [];
    const called = file === undefined ? piece.name : `${piece.name} of ${file}`;
    const quantity = mark.drafted?.quantity ?? 1;
    const lock = lockOf(options, mark.drafted, piece.name) ?? 'on';
    // what stands on its head is turned back by half a turn, and by no other
    const turns = nap === 'one-way' ? 'half' : turnsBy[lock];
    const asked = {
      name: called,
      outline: ringOf(cut[k] ?? [], called, k),
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
