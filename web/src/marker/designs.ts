/** Layouts of a result's other designs that match as well, on the same fabric. Lengths in cm. */
import type {MarkerGarment} from '../model/design/marker-garment.js';
import type {CheaperDesign, CheaperLay} from '../model/result/marker-plan.js';
import {cutAlignment} from '../model/print/as-cut.js';
import type {MarkerHooks} from '../model/result/marker-search.js';
import type {ProblemOptions} from '../model/design/options.js';
import type {Problem} from '../model/design/solve-problem.js';
import type {OtherAlignment, SolveResult} from '../model/result/result.js';
import type {MarkerOrder} from './problem.js';
import {unlessFailed, type Lay} from './shifted.js';

/** Solves a design like `solve`, in any thread. */
export type SolveDesign = (
  problem: Problem,
  hooks: Pick<MarkerHooks, 'signal'>,
) => Promise<SolveResult>;

/** A design matches as well if its mismatch is no larger than this share more, plus `asGoodCm`. */
const asGood = 0.1;
const asGoodCm = 0.01;
/**
 * Number of designs that are laid roughly, with the outlines unchanged; and effort for each, as a
 * share of the layout's.
 */
const mostLaid = 16;
const roughShare = 0.05;
/** Number of the shortest that are then solved and laid again. */
const mostSolved = 3;
/** Allowance for the error of a rough layout, since solving moves the outlines. [cm] */
const roughError = 1;

type Pins = CheaperDesign['pins'];

/** Alignments of a design by piece name, as the pins of a solve. */
const pinsOf = ({pieces}: SolveResult, {pieces: at}: OtherAlignment): Pins =>
  Object.fromEntries(
    pieces.flatMap(({name}, k) => {
      const alignment = at[k];
      return alignment ? [[name, alignment]] : [];
    }),
  );

/** The order with one garment's pieces aligned as in another of its designs. */
function placedAs(
  order: MarkerOrder,
  {result: {pieces, print}}: MarkerGarment,
  which: number,
  {pieces: at}: OtherAlignment,
): MarkerOrder {
  const byName = new Map(pieces.map(({name}, k) => [name, at[k]]));
  const placed = order.problem.pieces.map((piece, k) => {
    const {result, piece: name} = order.pieces[k] ?? {};
    const alignment = result === which && name !== undefined ? byName.get(name) : undefined;
    return alignment ? {...piece, alignment: cutAlignment(alignment, print.delivered)} : piece;
  });
  return {...order, problem: {...order.problem, pieces: placed}};
}

const meanOf = ({metrics}: SolveResult): number => metrics.localCm?.final ?? Infinity;

/** The problem with changed options. */
export function withOptions(problem: Problem, changed: ProblemOptions): Problem {
  const {options = {}} = problem;
  const given = typeof options === 'string' ? (JSON.parse(options) as ProblemOptions) : options;
  return {...problem, options: {...given, ...changed}};
}

interface Offered {
  readonly garments: readonly MarkerGarment[];
  /** Length of the current layout. */
  readonly lengthCm: number;
  /** Smallest difference that counts as a saving. */
  readonly leastSaving: number;
  /**
   * The layout order of garments.
   * @param share effort, as a share of the layout's
   */
  readonly orderOf: (garments: readonly MarkerGarment[], share: number) => MarkerOrder;
  readonly share: number;
  readonly lay: Lay;
  readonly solve: SolveDesign;
}

/**
 * The shortest other design that matches as well as the current one, solved and laid again;
 * undefined if none is shorter.
 */
export async function cheaperDesign(
  {garments, lengthCm, leastSaving, orderOf, share, lay, solve}: Offered,
  {signal}: Pick<MarkerHooks, 'signal'>,
): Promise<CheaperLay | undefined> {
  const hooks = signal ? {signal} : {};
  const lengthOf = async ({problem}: MarkerOrder): Promise<number> => {
    const laid = await unlessFailed(lay(problem, hooks), signal);
    return laid?.lengthCm ?? Infinity;
  };
  const rough: {readonly which: number; readonly other: OtherAlignment; readonly length: number}[] =
    [];
  for (const [which, garment] of garments.entries()) {
    const {result, others = result.otherAlignments ?? [], problem} = garment;
    if (!problem || others.length === 0) continue;
    const order = orderOf(garments, roughShare);
    for (const other of others.slice(0, mostLaid)) {
      const length = await lengthOf(placedAs(order, garment, which, other));
      if (length < lengthCm - leastSaving + roughError) rough.push({which, other, length});
    }
  }
  rough.sort((one, other) => one.length - other.length);
  let best: CheaperLay | undefined;
  for (const {which, other} of rough.slice(0, mostSolved)) {
    const garment = garments[which];
    if (!garment?.problem) continue;
    const pins = pinsOf(garment.result, other);
    const asked = withOptions(garment.problem, {pins, otherAlignments: false});
    const solved = await unlessFailed(solve(asked, hooks), signal);
    if (!solved) continue;
    const [meanCm, insteadOfCm] = [meanOf(solved), meanOf(garment.result)];
    if (!(meanCm <= insteadOfCm * (1 + asGood) + asGoodCm)) continue;
    const changed = garments.map((one, g) => (g === which ? {...one, result: solved} : one));
    const length = await lengthOf(orderOf(changed, share));
    if (length >= Math.min(lengthCm - leastSaving, best?.lengthCm ?? Infinity)) continue;
    const design = {result: which, pins, meanCm, insteadOfCm};
    best = {kind: 'design', lengthCm: length, design};
  }
  return best;
}
