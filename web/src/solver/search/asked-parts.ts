/** The parts of a problem that the solver's module does not know: read before, added after. */
import type {ProblemOptions, SolveOptions} from '../../model/design/options.js';
import type {Problem, SingleProblem} from '../../model/design/solve-problem.js';
import type {Print} from '../../model/print/repeating-print.js';
import type {SolveResult} from '../../model/result/result.js';
import {checkProblem} from '../requests/requests.js';

/** The part as an object; undefined if it is none, which the core reports. */
export function objectOf<T extends object>(part: T | string | undefined): T | undefined {
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
export function askingOptions(problem: Problem): ProblemOptions | undefined {
  checkProblem(problem);
  const {options} = problem;
  if (typeof options === 'string' && !/"(printSize|printTurn|auto)"/.test(options)) {
    return undefined;
  }
  const asked = objectOf(options);
  const {printSize, printTurn, effort} = asked ?? {};
  return (printSize ?? printTurn) !== undefined || effort === 'auto' ? asked : undefined;
}

/**
 * The print of a problem if its file states shrinkage or a measured repeat that are yet to be
 * applied; undefined for any other.
 */
export function unsewnPrint({print}: Pick<Problem, 'print'>): Print | undefined {
  if (typeof print === 'string' && !/"(shrinkage|measured)"/.test(print)) return undefined;
  const asked = objectOf<Print>(print);
  const {fabric, delivered} = asked ?? {};
  return !delivered && (fabric?.shrinkage ?? fabric?.measured) ? asked : undefined;
}

/** The result with size, turn, fabric and effort of its problem, which the core does not know. */
export function described(result: SolveResult, problem: SingleProblem): SolveResult {
  const known = <T extends object>(part: T | string | undefined, field: string): T | undefined =>
    typeof part !== 'string' || part.includes(`"${field}"`) ? objectOf(part) : undefined;
  const scale = known<Print>(problem.print, 'scale')?.scale ?? 1;
  const turnDeg = known<Print>(problem.print, 'turnDeg')?.turnDeg ?? 0;
  const delivered = known<Print>(problem.print, 'delivered')?.delivered;
  const effort = known<SolveOptions>(problem.options, 'effort')?.effort ?? 1;
  return {
    ...result,
    print: {
      ...result.print,
      ...(scale !== 1 && {scale}),
      ...(turnDeg !== 0 && {turnDeg}),
      ...(delivered && {delivered}),
    },
    ...(effort !== 1 && {metrics: {...result.metrics, effort}}),
  };
}
