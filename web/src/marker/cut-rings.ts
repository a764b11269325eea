/** The lines along which the pieces of a solved garment are cut, each made once. Lengths in cm. */
import {ownShare, type AllowanceRule, type OwnShare} from '../cutting/allowances.js';
import {cutLineSteps} from '../cutting/cut-lines.js';
import {decidedOf} from '../model/design.js';
import {drained} from '../model/drained.js';
import {SolverError} from '../model/failure.js';
import type {GarmentDocument} from '../model/garment-document.js';
import {panelMarks, type PanelMarks} from '../model/garment-marks.js';
import type {Point} from '../model/geometry.js';
import type {SolveOptions} from '../model/options.js';
import type {PieceNames} from '../model/piece-names.js';
import type {Problem} from '../model/problem.js';
import type {OtherAlignment, SolveResult} from '../model/result.js';
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
  /** Other designs of it that fit as well. Default: those that the result tells of. */
  readonly others?: readonly OtherAlignment[];
}

interface CutRings {
  /** By piece. */
  readonly marks: readonly PanelMarks[];
  /** Of the pieces that are printed, by number. */
  readonly rings: ReadonlyMap<number, readonly Point[]>;
  readonly ownAllowances: OwnShare;
}

/** What messages call a piece. */
export const calledIn = ({name: file}: MarkerGarment, piece: string): string =>
  file === undefined ? piece : `${piece} of ${file}`;

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

interface Known {
  readonly asked: readonly unknown[];
  readonly made: CutRings;
}

/** Of each result, as it was asked for last: a layout and its offers all begin with them. */
const known = new WeakMap<SolveResult, Known>();

/**
 * Takes some ten milliseconds a step, so that it can be done beside a page; none where they are known.
 * @throws {SolverError} naming a piece whose cut line crosses itself
 */
export function* cutRingSteps(
  laid: MarkerGarment,
  {allowanceCm, hemCm}: AllowanceRule,
): Generator<undefined, CutRings> {
  const {result, name, garment, options = {}, names} = laid;
  const asked = [name, garment, laid.options, names, allowanceCm, hemCm];
  const before = known.get(result);
  if (before?.asked.every((one, k) => one === asked[k])) return before.made;
  const decided = decidedOf({options, ...(names && {names})});
  const panels = garment ? panelMarks(garment, decided) : new Map<string, PanelMarks>();
  const rule = {allowanceCm, ...(hemCm !== undefined && {hemCm})};
  const {marks, allowances, cut} = yield* cutLineSteps(result, panels, rule);
  const {own, widths} = allowances;
  const rings = new Map<number, readonly Point[]>();
  for (const [k, piece] of result.pieces.entries()) {
    if (options.plain?.includes(piece.name)) continue;
    yield;
    rings.set(k, ringOf(cut[k] ?? [], calledIn(laid, piece.name), k));
  }
  const ownAllowances = ownShare([...widths.keys()].map((key) => own.has(key)));
  const made = {marks, rings, ownAllowances};
  known.set(result, {asked, made});
  return made;
}

/** The same at once. */
export const cutRings = (...asked: Parameters<typeof cutRingSteps>): CutRings =>
  drained(cutRingSteps(...asked));
