/** The cut lines of the pieces of a solved garment, cached. Lengths in cm. */
import type {AllowanceRule} from '../cutting/allowance-rule.js';
import {ownShare, type OwnShare} from '../cutting/allowances.js';
import {cutLineSteps} from '../cutting/cut-line.js';
import {decidedOf} from '../model/design/design.js';
import type {MarkerGarment} from '../model/design/marker-garment.js';
import {drained} from '../model/base/drained.js';
import {SolverError} from '../model/base/failure.js';
import {panelMarks, type PanelMarks} from '../model/garment/panel-marks.js';
import {cross, minus, type Point} from '../model/geometry/vectors.js';
import type {SolveResult} from '../model/result/result.js';
import {boxOf, signedArea} from '../model/geometry/polyline.js';

// The cut line of a piece in a layout. Lengths in cm.

/** The outermost of a piece's cut lines, counter-clockwise; undefined if it has none. */
function outerRing(cut: readonly (readonly Point[])[]): readonly Point[] | undefined {
  const [largest] = [...cut].sort(
    (one, other) => Math.abs(signedArea(other)) - Math.abs(signedArea(one)),
  );
  if (!largest || largest.length < 3) return undefined;
  return signedArea(largest) < 0 ? [...largest].reverse() : largest;
}

/** A segment of a line with its bounding box. */
interface Step {
  readonly from: Point;
  readonly to: Point;
  readonly low: Point;
  readonly high: Point;
}

const stepOf = (from: Point, to: Point): Step => ({from, to, ...boxOf([from, to])});

const isApart = (one: Step, other: Step): boolean =>
  one.high[0] < other.low[0] ||
  other.high[0] < one.low[0] ||
  one.high[1] < other.low[1] ||
  other.high[1] < one.low[1];

/** Returns whether two segments cross; touching is not crossing. */
function passThrough({from: a, to: b}: Step, {from: c, to: d}: Step): boolean {
  const side = (p: Point, q: Point, r: Point): number => cross(minus(q, p), minus(r, p));
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/** The start of a segment where a closed line crosses itself; undefined if it does not. */
export function selfCrossing(ring: readonly Point[]): Point | undefined {
  const steps = ring.map((from, k) => stepOf(from, ring[(k + 1) % ring.length] ?? from));
  // sorted from left to right, so that each segment meets only those that begin before it ends
  const sorted = [...steps].sort((one, other) => one.low[0] - other.low[0]);
  for (const [k, step] of sorted.entries()) {
    for (let n = k + 1; n < sorted.length; n++) {
      const other = sorted[n];
      if (!other || other.low[0] > step.high[0]) break;
      if (!isApart(step, other) && passThrough(step, other)) return step.from;
    }
  }
  return undefined;
}

interface CutRings {
  /** Marks of each piece. */
  readonly marks: readonly PanelMarks[];
  /** Cut lines of the printed pieces, by piece index. */
  readonly rings: ReadonlyMap<number, readonly Point[]>;
  readonly ownAllowances: OwnShare;
}

/** The name of a piece in messages. */
export const calledIn = ({name: file}: MarkerGarment, piece: string): string =>
  file === undefined ? piece : `${piece} of ${file}`;

/**
 * The outermost cut line.
 * @throws {SolverError} if the piece cannot be laid, with its name
 */
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

/** The latest cut lines of each result: a layout and its suggestions all start with them. */
const known = new WeakMap<SolveResult, Known>();

/**
 * Computes the cut lines in steps of about ten milliseconds, so that a page stays responsive.
 * Cached lines need no steps.
 * @throws {SolverError} if a cut line crosses itself, with the piece's name
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

/** Computes the cut lines in one call. */
export const cutRings = (...asked: Parameters<typeof cutRingSteps>): CutRings =>
  drained(cutRingSteps(...asked));
