/** The pieces of solved garments, prepared for a layout. Lengths in cm, angles in radians. */
import type {MarkerGarment} from '../model/design/marker-garment.js';
import type {GrainLock} from '../model/garment/grain.js';
import type {AllowanceRule} from '../cutting/allowance-rule.js';
import type {GarmentPiece} from '../model/garment/garment-document.js';
import type {PanelMarks} from '../model/garment/panel-marks.js';
import {dot, radians, towards, type Point} from '../model/geometry/vectors.js';
import type {LaidTurns, MarkerPiece, Nap} from '../model/result/marker-search.js';
import {cutAlignment, cutMap} from '../model/print/as-cut.js';
import type {SolveOptions} from '../model/design/options.js';
import type {ResultPiece, SolveResult} from '../model/result/result.js';
import {calledIn, cutRings} from './cut-rings.js';
import {leastRise, warpOf} from './nap.js';

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

export interface LaidOf extends PieceOfMarker {
  readonly asked: Omit<MarkerPiece, 'garment'>;
  /** The piece has no grain. */
  readonly isFree: boolean;
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

/**
 * The upward direction of a piece: from foot to head of its grain line, or as drawn without one.
 * The warp of the solved alignment replaces a grain line that runs across the fabric and stays so.
 */
function upOf(
  {alignment, grainAngle = Math.PI / 2}: ResultPiece,
  {grainDeg}: Pick<PanelMarks, 'grainDeg'>,
  lock: GrainLock,
): Point {
  const warp = warpOf(alignment);
  const grain = towards(grainDeg === undefined ? grainAngle : radians(grainDeg));
  return turnsBy[lock] === 'half' && Math.abs(dot(warp, grain)) < leastRise ? warp : grain;
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
 * The pieces of one garment, each as often as it is cut, larger by the shrinkage of the fabric.
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
    const larger = cutMap(piece.alignment, solved.print.delivered);
    const asked = {
      name: calledIn(laid, piece.name),
      outline: outline.map(larger),
      alignment: cutAlignment(piece.alignment, solved.print.delivered),
      turns,
      up: larger(upOf(piece, mark, lock)),
      shifts: loose.has(k) ? thinned(shifts, mostShifts / loose.size) : [],
    };
    const component = joined.findIndex((group) => group.includes(k));
    return Array.from({length: quantity}, (_, nth) => ({
      ...{result, piece: piece.name, asked, isFree: lock === 'free'},
      ...(component >= 0 && {component}),
      ...(quantity > 1 && {nth}),
    }));
  });
}

/** Pieces that have to keep their relative places on the print. */
type Joined = Pick<SolveResult, 'pieces' | 'seams' | 'symmetries' | 'matches'>;

/**
 * Groups of piece indices, joined directly or indirectly by matched seams, matches or mirror
 * symmetry.
 */
function components({
  pieces,
  seams,
  symmetries,
  matches = [],
}: Joined): readonly (readonly number[])[] {
  const above = pieces.map((_, k) => k);
  const top = (k: number): number => {
    const next = above[k] ?? k;
    return next === k ? k : top(next);
  };
  const join = (one: number, other: number): void => {
    const [first, last] = [top(one), top(other)].sort((a, b) => a - b);
    if (first !== undefined && last !== undefined) above[last] = first;
  };
  for (const {a, b, matched} of seams) if (matched) join(a.piece, b.piece);
  for (const {a, b} of matches) join(a.piece, b.piece);
  for (const symmetry of symmetries) if (symmetry.kind === 'pair') join(...symmetry.pieces);
  const groups = new Map<number, number[]>();
  for (const k of above.keys()) groups.set(top(k), [...(groups.get(top(k)) ?? []), k]);
  return [...groups.values()];
}

/**
 * Pieces under which the print may move alone, and those under which it moves together; by index.
 */
interface Movable {
  /** Pieces that nothing ties to their place on the print. */
  readonly loose: ReadonlySet<number>;
  /** Groups that move only together, the largest first. */
  readonly joined: readonly (readonly number[])[];
}

/**
 * Divides pieces into loose and joined ones. Single pieces are loose, except the first if all are
 * single.
 */
function movablePieces(garment: Joined, printed: readonly number[]): Movable {
  const groups = components(garment)
    .map((group) => group.filter((k) => printed.includes(k)))
    .filter((group) => group.length > 0)
    .sort((one, other) => other.length - one.length);
  const isLoose = (group: readonly number[], n: number): boolean => n > 0 && group.length === 1;
  return {
    loose: new Set(groups.filter(isLoose).flat()),
    joined: groups.filter((group, n) => !isLoose(group, n)),
  };
}
