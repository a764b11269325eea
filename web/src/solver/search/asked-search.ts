/** Problems that ask for several solves, and the problems of the single solves. */
import {groupTable} from '../../model/base/core-tables.js';
import type {PrintSizes, PrintTurns, ProblemOptions} from '../../model/design/options.js';
import type {Problem, SingleProblem} from '../../model/design/solve-problem.js';
import {scaleLimits} from '../../model/print/print-scale.js';
import {asVariant, mostTurn, type PrintVariant} from '../../model/print/print-variant.js';
import type {Print} from '../../model/print/repeating-print.js';
import {SolverError} from '../../model/base/failure.js';
import {shown} from '../../model/base/read.js';
import type {SolveResult} from '../../model/result/result.js';
import type {SeamWeights} from '../../model/result/seam-groups.js';
import {checkScaled} from '../../model/result/unscaled-print.js';
import {plainNames} from '../requests/requests.js';
import {askingOptions, objectOf} from './asked-parts.js';

/** A problem of several solves. */
export interface AskedSearch {
  /** The problem of one solve, in this size and turn of the print. */
  readonly problemAt: (variant: PrintVariant) => SingleProblem;
  /** The first seed. */
  readonly seed: number;
  /** Sizes to compare, the print's own first. */
  readonly scales: readonly number[];
  /** Turns to compare, no turn first. [degrees] */
  readonly turns: readonly number[];
  /** True if other seeds are tried, too. */
  readonly isLong: boolean;
  /** The user's weights of seams, which decide which of them count as visible. */
  readonly weights?: SeamWeights;
}

/** Number of sizes of a range: steps of 2 % from 90 to 110 %. */
const sizesOfRange = 11;
const mostSizes = 32;
const mostTurns = 8;

/** @throws {SolverError} unless a value of the options is a number within limits */
function checkedNumber(
  value: unknown,
  [least, most]: readonly [number, number],
  at: string,
): number {
  if (typeof value === 'number' && value >= least && value <= most) {
    return Number(value.toFixed(9));
  }
  throw wrongOption(
    `${at} is ${shown(value)}, but must be a number from ${String(least)} to ${String(most)}.`,
  );
}

const wrongOption = (message: string): SolverError => new SolverError({code: 'options', message});

/**
 * The sizes that a problem compares; without an option, the print's own.
 * @param called name of the options in messages
 * @throws {SolverError} for invalid sizes
 */
export function scalesOf(
  sizes: PrintSizes | undefined,
  called: string = plainNames.options,
): readonly number[] {
  if (sizes === undefined) return [1];
  const wrong = (what: string): SolverError => wrongOption(`${called}: ${what}`);
  const scale = (value: unknown, at: string): number =>
    checkedNumber(value, scaleLimits, `${called}: ${at}`);
  if (typeof sizes === 'number') return [scale(sizes, 'printSize')];
  const given = objectOf(sizes) ?? {};
  const fields = Object.keys(given).sort();
  if ('sizes' in given && fields.length === 1 && Array.isArray(given.sizes)) {
    if (given.sizes.length < 1 || given.sizes.length > mostSizes) {
      throw wrong(`printSize.sizes must list 1 to ${String(mostSizes)} sizes.`);
    }
    return withOwn(
      1,
      given.sizes.map((size: unknown) => scale(size, 'a size of printSize')),
    );
  }
  if ('from' in given && 'to' in given && fields.length === 2) {
    const [from, to] = [scale(given.from, 'printSize.from'), scale(given.to, 'printSize.to')];
    if (from > to) throw wrong('printSize.from is greater than printSize.to; exchange them.');
    const step = (to - from) / (sizesOfRange - 1);
    const all = Array.from({length: sizesOfRange}, (_, k) => from + k * step);
    return withOwn(
      1,
      all.map((size) => Number(size.toFixed(3))),
    );
  }
  throw wrong('printSize must be a number, {"from": 0.9, "to": 1.1} or {"sizes": [0.9, 1]}.');
}

/**
 * The turns that a problem compares; without an option, none.
 * @param called name of the options in messages
 * @throws {SolverError} for invalid turns
 */
function turnsOf(turns: PrintTurns | undefined, called: string): readonly number[] {
  if (turns === undefined) return [0];
  const turn = (value: unknown, at: string): number =>
    checkedNumber(value, [-mostTurn, mostTurn], `${called}: ${at}`);
  if (typeof turns === 'number') return [turn(turns, 'printTurn')];
  const fields = Object.keys(objectOf(turns) ?? {});
  if (fields.length !== 1 || !Array.isArray(turns.turns)) {
    throw wrongOption(`${called}: printTurn must be a number, or {"turns": [45, 90]}.`);
  }
  if (turns.turns.length < 1 || turns.turns.length > mostTurns) {
    throw wrongOption(`${called}: printTurn.turns must list 1 to ${String(mostTurns)} turns.`);
  }
  return withOwn(
    0,
    turns.turns.map((value) => turn(value, 'a turn of printTurn')),
  );
}

/** The values once each, the print's own first. */
const withOwn = (own: number, values: readonly number[]): readonly number[] => [
  ...new Set([own, ...values]),
];

/** The same problem without the options of a search. */
function single(problem: Problem, options: ProblemOptions): SingleProblem {
  const kept = Object.entries(options).filter(
    ([name, value]) => name !== 'printSize' && name !== 'printTurn' && value !== 'auto',
  );
  return {...problem, options: Object.fromEntries(kept)};
}

/**
 * The problem in another size and turn of its print.
 * @throws {SolverError} for another size of a print that has no known one
 */
function varied<P extends Pick<Problem, 'print'>>(problem: P, variant: PrintVariant): P {
  const {scale, turnDeg} = variant;
  if (scale === 1 && turnDeg === 0) return problem;
  const print = objectOf<Print>(problem.print);
  const isPrint = print && print.group in groupTable && [print.w1, print.w2].every(Array.isArray);
  if (!isPrint) return problem; // the core reports it
  if (scale !== 1) checkScaled(print);
  if (print.fabric?.measured ?? print.delivered?.measured) {
    throw wrongOption(
      'The repeat was measured on fabric that is printed already, so its print has no other size or turn; leave out printSize and printTurn, or the measured repeat.',
    );
  }
  return {...problem, print: asVariant(print, variant)};
}

/**
 * The search that a problem asks for; undefined if it asks for one solve.
 * @throws {SolverError} for invalid options
 */
export function askedSearch(
  problem: Problem,
  called: string = plainNames.options,
): AskedSearch | undefined {
  const options = askingOptions(problem);
  if (!options) return undefined;
  const scales = scalesOf(options.printSize, called);
  const turns = turnsOf(options.printTurn, called);
  // other methods have no effort, and their seeds are random starts
  const isLong = options.effort === 'auto' && (problem.method ?? 'best') === 'best';
  if (scales.length === 1 && turns.length === 1 && !isLong) return undefined;
  const plain = single(problem, options);
  const problemAt = (variant: PrintVariant): SingleProblem => varied(plain, variant);
  const {weights} = options;
  return {problemAt, seed: problem.seed ?? 1, scales, turns, isLong, ...(weights && {weights})};
}

/**
 * The problem of one solve: in the print's own size and turn if several are asked for.
 * @throws {SolverError} for invalid options
 */
export function singleProblem(
  problem: Problem,
  called: string = plainNames.options,
): SingleProblem {
  const options = askingOptions(problem);
  if (!options) return problem as SingleProblem;
  const [scale = 1] = scalesOf(options.printSize, called);
  const [turnDeg = 0] = turnsOf(options.printTurn, called);
  return varied(single(problem, options), {scale, turnDeg});
}

/**
 * The problem of one solve that gives this result, byte for byte: with the size, turn and seed that
 * were chosen for it.
 */
export function chosenProblem(
  problem: Problem,
  {print, metrics}: Pick<SolveResult, 'print' | 'metrics'>,
): SingleProblem {
  const options = askingOptions(problem);
  if (!options) return problem as SingleProblem;
  const own = objectOf<Print>(problem.print);
  const plain = {...single(problem, options), seed: metrics.seed};
  return varied(plain, {
    scale: Number(((print.scale ?? 1) / (own?.scale ?? 1)).toFixed(9)),
    turnDeg: (print.turnDeg ?? 0) - (own?.turnDeg ?? 0),
  });
}
