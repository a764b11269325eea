/** Proposes changes that may improve seams with a mismatch. `remedies.ts` tests whether they do. */
import type {GrainLock, GrainRule} from '../model/garment/grain.js';
import {dot, unit} from '../model/geometry/vectors.js';
import type {SolveOptions} from '../model/design/options.js';
import type {GroupName, Print} from '../model/print/repeating-print.js';
import type {Problem} from '../model/design/solve-problem.js';
import type {SeamReason, SolveResult} from '../model/result/result.js';
import type {Repeat} from '../model/print/wallpaper.js';
import {finalMismatch, isGathered, meanOf} from '../scene/mismatch.js';
import {bandsOf} from './bands.js';
import {parsed, type Proposal} from './remedy.js';

/** Greatest number of proposals, since each takes a solve. */
const most = 4;
/** Greatest number of pieces of a garment for which a solve is fast enough. */
const mostPieces = 60;

/** Proposals in the order in which they are tried. */
export function proposals(problem: Problem, result: SolveResult): readonly Proposal[] {
  if (result.pieces.length > mostPieces) return [];
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
