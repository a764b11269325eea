import type {SolveResult} from '../model/result.js';
import type {Remedy} from '../node/index.js';
import {finalFit, fitOf, worstOf} from '../picture/fit.js';

const millimetres = (cm: number): string => `${(10 * cm).toFixed(1)} mm`;

/** How far the print misses at the seams: the mean, the worst of their means, and the mean as drafted. */
function mismatch(result: SolveResult): string[] {
  const fit = finalFit(result);
  const worst = worstOf(fit);
  if (!worst) return ['no seams to match'];
  const before = result.drafted && fitOf(result, 'rest', result.drafted).mean;
  return [
    `seams meet within ${millimetres(fit.mean)} on average, the worst within ${millimetres(worst.mean)}`,
    ...(before === undefined ? [] : [`before ${millimetres(before)}`]),
  ];
}

/** The figures of a result as one line for people. */
export function figuresLine(name: string, result: SolveResult): string {
  const {print, pieces, seams, metrics} = result;
  return [
    `${name}: ${String(pieces.length)} pieces, ${String(seams.length)} seams, ${print.group}, ${metrics.method}, seed ${String(metrics.seed)}`,
    ...mismatch(result),
    `moved at most ${millimetres(metrics.maxMovedCm)}`,
    `${String(metrics.milliseconds.total)} ms`,
  ].join('; ');
}

const quoted = (names: readonly string[]): string => names.map((name) => `'${name}'`).join(' and ');

const what: Readonly<Record<Remedy['kind'], (names: readonly string[]) => string>> = {
  turn: (names) => `Turn ${quoted(names)} by 90 degrees`,
  ungather: () => 'Leave out the gathers',
  mirrors: () => 'Take a print with mirrors',
  smaller: () => 'Take a print of half the repeat',
};

/** Turn 'waistband' by 90 degrees: 20.5 -> 0.0 mm */
export const remedyLine = ({kind, pieces, before, after}: Remedy): string =>
  `${what[kind](pieces)}: ${(10 * before).toFixed(1)} -> ${millimetres(after)}`;
