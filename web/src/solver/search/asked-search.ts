/** Problems that ask for several solves, and the problems of the single solves. */
import type {PrintSizes, ProblemOptions, SolveOptions} from '../../model/design/options.js';
import type {Problem, SingleProblem} from '../../model/design/solve-problem.js';
import {atScale, scaleLimits} from '../../model/print/print-scale.js';
import type {Print} from '../../model/print/repeating-print.js';
import {SolverError} from '../../model/result/failure.js';
import type {SolveResult} from '../../model/result/result.js';
import {checkScaled} from '../../model/result/unscaled-print.js';
import {plainNames} from '../requests/requests.js';

/** A problem of several solves. */
export interface AskedSearch {
  /** The problem of one solve, in this size of the print. */
  readonly problemAt: (scale: number) => SingleProblem;
  /** The first seed. */
  readonly seed: number;
  /** Sizes to compare, the print's own first. */
  readonly scales: readonly number[];
  /** True if other seeds are tried, too. */
  readonly isLong: boolean;
}

/** Number of sizes of a range: steps of 2 % from 90 to 110 %. */
const sizesOfRange = 11;
const mostSizes = 32;

/** The part as an object; undefined if it is none, which the core reports. */
function objectOf<T extends object>(part: T | string | undefined): T | undefined {
  if (typeof part !== 'string') return typeof part === 'object' ? part : undefined;
  try {
    const value: unknown = JSON.parse(part);
    return typeof value === 'object' && value !== null ? (value as T) : undefined;
  } catch {
    return undefined;
  }
}

/**
 * The problem's options, if they ask for more than one solve or for another size. Undefined for
 * text without the words in question, so that other options are not parsed twice.
 */
function askingOptions({options}: Problem): ProblemOptions | undefined {
  if (typeof options === 'string' && !/"(printSize|auto)"/.test(options)) return undefined;
  const asked = objectOf(options);
  return asked?.printSize !== undefined || asked?.effort === 'auto' ? asked : undefined;
}

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
  const wrong = (what: string): SolverError =>
    new SolverError({code: 'options', message: `${called}: ${what}`});
  const [least, most] = scaleLimits;
  const scale = (value: unknown, at: string): number => {
    if (typeof value === 'number' && value >= least && value <= most) {
      return Number(value.toFixed(9));
    }
    throw wrong(
      `${at} is ${JSON.stringify(value)}, but must be a number from ${String(least)} to ${String(most)}.`,
    );
  };
  if (typeof sizes === 'number') return [scale(sizes, 'printSize')];
  const fields = Object.keys(objectOf(sizes) ?? {}).sort();
  if ('sizes' in sizes && fields.length === 1 && Array.isArray(sizes.sizes)) {
    if (sizes.sizes.length < 1 || sizes.sizes.length > mostSizes) {
      throw wrong(`printSize.sizes must list 1 to ${String(mostSizes)} sizes.`);
    }
    return withOwn(sizes.sizes.map((size) => scale(size, 'a size of printSize')));
  }
  if ('from' in sizes && 'to' in sizes && fields.length === 2) {
    const [from, to] = [scale(sizes.from, 'printSize.from'), scale(sizes.to, 'printSize.to')];
    if (from > to) throw wrong('printSize.from is greater than printSize.to; exchange them.');
    const step = (to - from) / (sizesOfRange - 1);
    const all = Array.from({length: sizesOfRange}, (_, k) => from + k * step);
    return withOwn(all.map((size) => Number(size.toFixed(3))));
  }
  throw wrong('printSize must be a number, {"from": 0.9, "to": 1.1} or {"sizes": [0.9, 1]}.');
}

/** The sizes once each, the print's own first. */
const withOwn = (scales: readonly number[]): readonly number[] => [...new Set([1, ...scales])];

/** The same problem without the options of a search. */
function single(problem: Problem, options: ProblemOptions): SingleProblem {
  const kept = Object.entries(options).filter(
    ([name, value]) => name !== 'printSize' && value !== 'auto',
  );
  return {...problem, options: Object.fromEntries(kept)};
}

/**
 * The problem in another size of its print.
 * @throws {SolverError} if the print has no known size
 */
function resized<P extends Pick<Problem, 'print'>>(problem: P, scale: number): P {
  if (scale === 1) return problem;
  const print = objectOf<Print>(problem.print);
  if (!print || ![print.w1, print.w2].every(Array.isArray)) return problem; // the core reports it
  checkScaled(print);
  return {...problem, print: atScale(print, scale)};
}

/**
 * The search that a problem asks for; undefined if it asks for one solve.
 * @throws {SolverError} for invalid options
 */
export function askedSearch(problem: Problem, called?: string): AskedSearch | undefined {
  const options = askingOptions(problem);
  if (!options) return undefined;
  const scales = scalesOf(options.printSize, called);
  // other methods have no effort, and their seeds are random starts
  const isLong = options.effort === 'auto' && (problem.method ?? 'best') === 'best';
  if (scales.length === 1 && !isLong) return undefined;
  const plain = single(problem, options);
  const problemAt = (scale: number): SingleProblem => resized(plain, scale);
  return {problemAt, seed: problem.seed ?? 1, scales, isLong};
}

/**
 * The problem of one solve: in the print's own size if several are asked for.
 * @throws {SolverError} for invalid options
 */
export function singleProblem(problem: Problem, called?: string): SingleProblem {
  const options = askingOptions(problem);
  if (!options) return problem as SingleProblem;
  const [scale = 1] = scalesOf(options.printSize, called);
  return resized(single(problem, options), scale);
}

/**
 * The problem of one solve that gives this result, byte for byte: with the size and seed that were
 * chosen for it.
 */
export function chosenProblem(
  problem: Problem,
  {print, metrics}: Pick<SolveResult, 'print' | 'metrics'>,
): SingleProblem {
  const options = askingOptions(problem);
  if (!options) return problem as SingleProblem;
  const own = objectOf<Print>(problem.print)?.scale ?? 1;
  const plain = {...single(problem, options), seed: metrics.seed};
  return resized(plain, Number(((print.scale ?? 1) / own).toFixed(9)));
}

/** The result with the size and effort of its problem, which the core does not know. */
export function described(result: SolveResult, problem: SingleProblem): SolveResult {
  const known = <T extends object>(part: T | string | undefined, field: string): T | undefined =>
    typeof part !== 'string' || part.includes(`"${field}"`) ? objectOf(part) : undefined;
  const scale = known<Print>(problem.print, 'scale')?.scale ?? 1;
  const effort = known<SolveOptions>(problem.options, 'effort')?.effort ?? 1;
  if (scale === 1 && effort === 1) return result;
  return {
    ...result,
    ...(scale !== 1 && {print: {...result.print, scale}}),
    ...(effort !== 1 && {metrics: {...result.metrics, effort}}),
  };
}
