/** Proposes changes that may improve seams with a mismatch. `remedies.ts` tests whether they do. */
import type {GrainLock, GrainRule} from '../model/garment/grain.js';
import {distance, dot, unit} from '../model/geometry/vectors.js';
import type {SolveOptions} from '../model/design/options.js';
import type {GroupName, Print} from '../model/print/repeating-print.js';
import type {SingleProblem} from '../model/design/solve-problem.js';
import type {Pattern, ResultSeam, SeamReason, SolveResult} from '../model/result/result.js';
import type {Repeat} from '../model/print/wallpaper.js';
import {finalMismatch, isGathered, meanOf} from '../scene/mismatch.js';
import {parsed, type Proposal} from './remedy.js';
import {boxOf, lengthOf, signedArea} from '../model/geometry/polyline.js';
import {pick} from '../scene/marks.js';

/** Greatest number of proposals, since each takes a solve. */
const most = 4;
/** Greatest number of pieces of a garment for which a solve is fast enough. */
const mostPieces = 60;

/** Proposals in the order in which they are tried. */
export function proposals(problem: SingleProblem, result: SolveResult): readonly Proposal[] {
  // the published methods are for comparison, and take minutes
  if (result.pieces.length > mostPieces || result.metrics.method !== 'best') return [];
  const options = parsed(problem.options);
  const known = reasons(result);
  const off = (...some: readonly SeamReason[]): number[] =>
    known.flatMap((why, seam) => (why && some.includes(why) ? [seam] : []));
  return [
    ...turns(options, result, off('grain')),
    ...ungathered(options, off('gather')),
    ...mirrored(parsed(problem.print), off('group')),
    ...smaller(parsed(problem.print), off('size', 'others')),
  ].slice(0, most);
}

/** Greatest mean mismatch of a seam that needs no reason. [cm] */
const meets = 0.3;

/**
 * The reason of each seam's mismatch, if any. If the result states none, gathers are recognised by
 * the lengths of both sides, and other seams are attributed to the grain; proposals without effect
 * are not offered.
 */
function reasons(result: SolveResult): readonly (SeamReason | undefined)[] {
  const {seams} = finalMismatch(result);
  return result.seams.map((seam, k) => {
    const {why, local} = seam;
    const mismatch = seams[k];
    if (why ?? local ?? !mismatch?.counts) return why;
    if (meanOf(mismatch) <= meets) return undefined;
    return isGathered(seam) ? 'gather' : 'grain';
  });
}

/** The grain rule of a piece in the options. */
function lockOf({grain}: SolveOptions, name: string): GrainLock | undefined {
  const rule = grain?.pieces?.[name];
  return (typeof rule === 'object' ? rule.lock : rule) ?? grain?.default;
}

/** The grain rule after a rotation by 90 degrees. */
const quarter: Readonly<Partial<Record<GrainLock, GrainLock>>> = {on: 'across', across: 'on'};

function turns(
  options: SolveOptions,
  result: SolveResult,
  crossed: readonly number[],
): readonly Proposal[] {
  const {pieces} = result;
  const nameOf = (piece: number): string => pieces[piece]?.name ?? '';
  // a piece without a rule has the grain of its file: it is on grain, since its seam would not be
  // crossed otherwise
  const turnedLock = (name: string): GrainLock | undefined =>
    quarter[lockOf(options, name) ?? 'on'];
  const canTurn = (piece: number): boolean => {
    const name = nameOf(piece);
    return turnedLock(name) !== undefined && options.pins?.[name] === undefined;
  };
  return bandsOf(result, crossed, canTurn).map((band): Proposal => {
    const names = band.pieces.map(nameOf);
    const rules = names.map((name): [string, GrainRule] => {
      const rule = options.grain?.pieces?.[name];
      const lock = turnedLock(name) ?? 'across';
      return [name, typeof rule === 'object' ? {...rule, lock} : lock];
    });
    const all = {...options.grain?.pieces, ...Object.fromEntries(rules)};
    return {
      ...{kind: 'turn', pieces: names, seams: band.seams},
      change: {options: {grain: {...options.grain, pieces: all}}},
    };
  });
}

function ungathered({unmatched = []}: SolveOptions, seams: readonly number[]): readonly Proposal[] {
  if (seams.length === 0) return [];
  const change = {options: {unmatched: [...unmatched, ...seams]}};
  return [{kind: 'ungather', pieces: [], seams, change}];
}

/** For groups without mirrors or with fewer ones, a group with more mirrors on the same lattice. */
const mirrorsOf: Readonly<Partial<Record<GroupName, GroupName>>> = {
  ...{pm: 'pmm', pg: 'pmm', pmg: 'pmm', pgg: 'pmm', cm: 'cmm'},
  ...{p4: 'p4m', p4g: 'p4m', p3: 'p6m', p3m1: 'p6m', p31m: 'p6m', p6: 'p6m'},
};

/** The group with more mirrors on the same lattice; undefined if there is none. */
export function groupWithMirrors({group, w1, w2}: Repeat): GroupName | undefined {
  if (group !== 'p1' && group !== 'p2') return mirrorsOf[group];
  return Math.abs(dot(unit(w1), unit(w2))) < 1e-6 ? 'pmm' : undefined;
}

function mirrored(print: Print, seams: readonly number[]): readonly Proposal[] {
  const group = seams.length > 0 ? groupWithMirrors(print) : undefined;
  return group ? [{kind: 'mirrors', pieces: [], seams, change: {print: {group}}}] : [];
}

function smaller({w1, w2}: Print, seams: readonly number[]): readonly Proposal[] {
  if (seams.length === 0) return [];
  const print = {w1: [w1[0] / 2, w1[1] / 2], w2: [w2[0] / 2, w2[1] / 2]} as const;
  return [{kind: 'smaller', pieces: [], seams, change: {print}}];
}

/**
 * Selects the pieces to rotate where grains cross at seams: bands, rather than the pieces they are
 * sewn to.
 */
const seamLength = ({pieces}: Pattern, {a: {piece, vertices}}: ResultSeam): number =>
  lengthOf(pick(pieces[piece]?.rest ?? [], vertices));

/**
 * The width of a drafted piece across its length: its area divided by the diagonal of its bounding
 * box. [cm]
 */
function breadthOf({pieces}: Pattern, piece: number): number {
  const {rest = [], outline = []} = pieces[piece] ?? {};
  const loop = pick(rest, outline);
  const {low, high} = boxOf(loop);
  return Math.abs(signedArea(loop)) / distance(low, high);
}

/**
 * Sets of pieces to rotate together, each with its crossed seams. At every crossed seam, the
 * narrower side is rotated; of two equal ones, the one with less other seam length. Its mirror
 * image and pieces of its kind that are joined to it without crossed grains are included: a band in
 * two halves would otherwise no longer match at its joint.
 * @param crossed indices of the seams with crossed grains
 * @param canTurn returns whether a piece's grain can be rotated
 */
function bandsOf(
  pattern: Pattern,
  crossed: readonly number[],
  canTurn: (piece: number) => boolean,
): readonly {readonly pieces: readonly number[]; readonly seams: readonly number[]}[] {
  const {seams, symmetries} = pattern;
  const at = crossed.flatMap((number) => {
    const seam = seams[number];
    return seam && seam.a.piece !== seam.b.piece ? [{number, seam}] : [];
  });
  const other = new Map<number, number>();
  seams.forEach((seam, number) => {
    if (crossed.includes(number)) return;
    for (const {piece} of [seam.a, seam.b]) {
      other.set(piece, (other.get(piece) ?? 0) + seamLength(pattern, seam));
    }
  });
  const breadth = (piece: number): number => breadthOf(pattern, piece);
  const bands = new Set(
    at.flatMap(({seam: {a, b}}) => {
      const sides = [a.piece, b.piece].filter(canTurn);
      return sides
        .toSorted((p, q) => breadth(p) - breadth(q) || (other.get(p) ?? 0) - (other.get(q) ?? 0))
        .slice(0, 1);
    }),
  );
  const twins = symmetries.flatMap((one) => (one.kind === 'pair' ? [one.pieces] : []));
  for (const [first, second] of twins) {
    if (bands.has(first) || bands.has(second)) bands.add(first).add(second);
  }
  const uncrossed = seams.filter((_, number) => !crossed.includes(number));
  const joins = [...twins, ...uncrossed.map(({a, b}) => [a.piece, b.piece] as const)];
  return connected([...bands], joins).map((pieces) => ({
    pieces,
    seams: at
      .filter(({seam: {a, b}}) => pieces.includes(a.piece) !== pieces.includes(b.piece))
      .map(({number}) => number),
  }));
}

/** The connected sets of pieces under the given joins. */
function connected(
  pieces: readonly number[],
  joins: readonly (readonly [number, number])[],
): readonly (readonly number[])[] {
  const sets: number[][] = pieces.map((piece) => [piece]);
  for (const [first, second] of joins) {
    const one = sets.find((set) => set.includes(first));
    const other = sets.find((set) => set.includes(second));
    if (!one || !other || one === other) continue;
    one.push(...other);
    sets.splice(sets.indexOf(other), 1);
  }
  return sets;
}
