/**
 * Checks a layout by its geometry, from the results and the print alone, independently of the
 * plan's own figures.
 */
import {between, minus} from '@/model/geometry/vectors.js';
import type {LaidPlacement, LayPlan} from '@/model/result/marker-plan.js';
import type {SolveResult} from '@/model/result/result.js';
import {aroundLoop, at, sum} from '../plane.js';
import {checkPhases, checkPrint, checkTurns} from './laid-print.js';
import {warpPeriod} from './plan-print.js';
import {nameOf, pieceOf, ringOnPiece, type PlanRules} from './plan-rules.js';
import {
  extentOf,
  holds,
  outlineOf,
  ringArea,
  ringDistance,
  ringsApart,
  sharedArea,
  toRing,
} from './rings.js';

/** Tolerances. [cm] */
const tolerance = {print: 1e-6, inside: 1e-4, gap: 0.01, length: 1e-6, proof: 0.05, line: 0.06};
/** Step along cut lines at which distances are measured. [cm] */
const sampled = 0.5;
/** Overlaps below this count as none. [cm2] */
const leastShared = 1e-3;

/** Faults of a plan, a message each; empty if it is valid. */
export function planComplaints(
  plan: LayPlan,
  results: readonly SolveResult[],
  rules: PlanRules,
): readonly string[] {
  if (!isFinite(plan)) return ['a coordinate or figure is not finite'];
  const {print, placements} = plan;
  const strangers = placements.filter(({result, piece}) => !pieceOf(results, result, piece));
  if (strangers.length > 0) return strangers.map((one) => `${nameOf(one)}: no such piece`);
  return [
    ...results.flatMap((result, k) =>
      isSamePrint(result.print, print) ? [] : [`result ${k} is aligned on another print`],
    ),
    ...checkRoll(plan, results, rules),
    ...placements.flatMap((one) => checkCut(plan, one, results, rules)),
    ...checkPrint(plan, results, rules),
    ...checkTurns(plan, results, rules),
    ...checkPlaces(plan, rules),
    ...checkPairs(plan),
    ...checkFigures(plan, rules),
  ];
}

const isFinite = (value: unknown): boolean => {
  if (typeof value === 'number') return Number.isFinite(value);
  return typeof value !== 'object' || value === null || Object.values(value).every(isFinite);
};

const isSamePrint = (a: LayPlan['print'], b: LayPlan['print']): boolean =>
  a.group === b.group && ringsApart([a.w1, a.w2], [b.w1, b.w2]) <= 1e-9;

/** Checks that each piece of each garment is there once: placed, or listed as unplaced. */
function checkRoll(
  {placements, unplaced}: LayPlan,
  results: readonly SolveResult[],
  {copies = 1, plain = []}: PlanRules,
): string[] {
  const wanted = results.flatMap(({pieces}, result) =>
    Array.from({length: copies}, (_, copy) =>
      pieces
        .filter(({name}) => !plain.includes(name))
        .map(({name}) => nameOf({result, copy, piece: name})),
    ).flat(),
  );
  const found = [...placements, ...unplaced].map(nameOf);
  return [
    ...wanted.filter((name) => !found.includes(name)).map((name) => `${name} is missing`),
    ...found.filter((name) => !wanted.includes(name)).map((name) => `${name}: nobody asked for it`),
    ...found.filter((name, k) => found.indexOf(name) < k).map((name) => `${name} is laid twice`),
  ];
}

/** Checks that the cut line is that of the piece, face up, moved to its place. */
function checkCut(
  {allowanceCm, placements}: LayPlan,
  placement: LaidPlacement,
  results: readonly SolveResult[],
  {hasOwnAllowances = false}: PlanRules,
): string[] {
  const {shape = [], outline = []} = pieceOf(results, placement.result, placement.piece) ?? {};
  const name = nameOf(placement);
  const ring = ringOnPiece(placement);
  const sewn = outline.map((v) => at(shape, v));
  const broken: string[] = [];
  if (!(ringArea(ring) > 0)) broken.push(`${name}: the cut line runs clockwise`);
  const inside = sewn.map((p) => (holds(ring, p) ? 0 : toRing(p, ring)));
  if (Math.max(...inside) > tolerance.line) broken.push(`${name}: sewn lines leave the cut line`);
  if (!hasOwnAllowances) {
    const apart = aroundLoop(ring)
      .flatMap(([from, to]) => {
        const steps = Math.ceil(Math.hypot(...minus(to, from)) / sampled);
        return Array.from({length: steps}, (_, k) => between(from, to, (k + 0.5) / steps));
      })
      .map((p) => toRing(p, sewn))
      .sort((a, b) => a - b);
    const usual = at(apart, Math.floor(apart.length / 2));
    if (at(apart, 0) < allowanceCm - tolerance.line) {
      broken.push(`${name}: an allowance of ${at(apart, 0)} cm, not of ${allowanceCm}`);
    }
    if (Math.abs(usual - allowanceCm) > tolerance.line) {
      broken.push(`${name}: allowances of ${usual} cm, not of ${allowanceCm}`);
    }
  }
  const first = placements.find(
    ({result, piece}) => result === placement.result && piece === placement.piece,
  );
  const other = first ? ringsApart(ringOnPiece(first), ring) : 0;
  if (other > tolerance.print) broken.push(`${name}: copies are cut ${other} cm apart`);
  return broken;
}

/** Checks that pieces are on the fabric, within its selvedges, off its flaws. */
function checkPlaces(
  {placements, widthCm, selvedgeCm, lengthCm}: LayPlan,
  {flaws = []}: PlanRules,
): string[] {
  return placements.flatMap((placement) => {
    const name = nameOf(placement);
    const [left, lower, right, upper] = extentOf(placement.cut);
    const over = {
      'the left selvedge': selvedgeCm - left,
      'the right selvedge': right - (widthCm - selvedgeCm),
      'the start': -lower,
      'the end': upper - lengthCm,
    };
    return [
      ...Object.entries(over).flatMap(([what, by]) =>
        by > tolerance.inside ? [`${name} is ${by} cm over ${what}`] : [],
      ),
      ...flaws.flatMap((flaw, k) =>
        sharedArea(placement.cut, flaw) > leastShared ? [`${name} lies on flaw ${k}`] : [],
      ),
    ];
  });
}

/** Checks the gap between pieces. */
function checkPairs({placements, gapCm}: LayPlan): string[] {
  const outlines = placements.map(({cut}) => outlineOf(cut));
  return placements.flatMap((placement, k) =>
    placements.slice(0, k).flatMap((other, n) => {
      const most = Math.max(gapCm, 1e-9);
      const apart = ringDistance(at(outlines, k), at(outlines, n), [0, 0], {most});
      const names = `${nameOf(placement)} and ${nameOf(other)}`;
      if (apart === 0) {
        const area = sharedArea(placement.cut, other.cut);
        if (area > leastShared) return [`${names} overlap by ${area} cm2`];
      }
      return apart < gapCm - tolerance.gap ? [`${names} are ${apart} cm apart, not ${gapCm}`] : [];
    }),
  );
}

/** Checks the plan's figures against its placements. */
function checkFigures(plan: LayPlan, rules: PlanRules): string[] {
  const {print, placements, lengthCm, widthCm, boundCm, proven, useShare, freeLengthCm} = plan;
  const broken: string[] = [];
  const must = (isSo: boolean, sentence: string) => {
    if (!isSo) broken.push(sentence);
  };
  const [, lower, , upper] = extentOf(placements.flatMap(({cut}) => cut));
  const isFixed = rules.isStartFixed === true || (rules.flaws ?? []).length > 0;
  const extent = isFixed ? upper : upper - lower;
  if (rules.wholeRepeats) {
    const period = warpPeriod(print) ?? NaN;
    const count = Math.round(lengthCm / period);
    const off = Math.abs(lengthCm - count * period);
    must(off <= tolerance.length, `${lengthCm} cm are not whole repeats of ${period} cm`);
    must(extent > lengthCm - period - tolerance.length, 'a whole repeat lies empty');
    must(extent <= lengthCm + tolerance.length, `the pieces take ${extent} cm`);
  } else {
    const off = Math.abs(extent - lengthCm);
    must(off <= tolerance.length, `the pieces take ${extent} cm, not ${lengthCm}`);
  }
  const used = sum(placements.map(({cut}) => ringArea(cut))) / (widthCm * lengthCm);
  must(Math.abs(used - useShare) <= 1e-6, `${used} of the fabric is used, not ${useShare}`);
  must(boundCm <= lengthCm + tolerance.length, `the bound, ${boundCm}, is above the length`);
  const open = Math.abs(boundCm - lengthCm);
  must(!proven || open <= tolerance.proof, `said to be proven, but ${open} cm are open`);
  const isFreeLonger = freeLengthCm !== null && freeLengthCm > lengthCm + tolerance.length;
  must(!isFreeLonger, 'without the print it is said to be longer');
  return [...broken, ...checkPhases(plan)];
}
