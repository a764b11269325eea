import type {GarmentDocument} from '../model/garment/garment-document.js';
import {panelMarks} from '../model/garment/panel-marks.js';
import type {SolveOptions} from '../model/design/options.js';
import type {ComparedAnswer} from '../model/design/solve-problem.js';
import type {Milliseconds, SolveResult} from '../model/result/result.js';
import {seamCount} from '../model/result/seam-groups.js';
import type {Remedy} from '../node/index.js';
import {seamGroupsOf} from '../scene/group-states.js';
import {finalMismatch, mismatchOf, worstOf} from '../scene/mismatch.js';
import {countOf} from './base/count-of.js';

const millimetres = (cm: number): string => `${(10 * cm).toFixed(1)} mm`;

/** The part of the aligned problem that the figures use. */
interface Asked {
  readonly garment: GarmentDocument;
  readonly options: SolveOptions;
  /** Answers that were compared, the one in the print's own size first. */
  readonly compared?: readonly ComparedAnswer[];
}

/**
 * A remark on the reference: drafted pieces lie on their grain, and pieces without a grain line are
 * taken as drawn upright.
 */
function grainAsDrafted({garment, options}: Asked, {pieces}: SolveResult): string {
  const {pieces: grain = {}} = options.grain ?? {};
  const marks = panelMarks(garment, {grain});
  const unsaid = pieces.filter(({name}) => {
    const {grain: line, grainDeg} = marks.get(name) ?? {};
    return !line && grainDeg === undefined;
  });
  if (unsaid.length === 0) return '';
  const which = unsaid.length === pieces.length ? '' : ` for ${countOf(unsaid.length, 'piece')}`;
  return ` with the grain upwards as drawn, for the file states none${which}`;
}

/** The mismatch at the seams: the mean, the worst mean of a seam, and the mean as drafted. */
function mismatch(result: SolveResult, asked: Asked): string[] {
  const mismatch = finalMismatch(result);
  const worst = worstOf(mismatch);
  if (!worst) return ['no seams to match'];
  const before = result.drafted && mismatchOf(result, 'rest', result.drafted).mean;
  return [
    `on average the print misses by ${millimetres(mismatch.mean)} at the seams, at the worst by ${millimetres(worst.mean)}`,
    ...(before === undefined
      ? []
      : [`before ${millimetres(before)}${grainAsDrafted(asked, result)}`]),
  ];
}

/**
 * The number of visible seams that match, as in the headline of the page, and how many do in the
 * first of several answers.
 */
function matching(result: SolveResult, {options, compared = []}: Asked): string[] {
  const {matched, counted} = seamCount(seamGroupsOf(result), options.weights);
  if (counted === 0) return [];
  const [own] = compared;
  const before =
    own && own.matched !== matched ? ` (${String(own.matched)} in the first answer)` : '';
  return [`${String(matched)} of ${String(counted)} visible seams match${before}`];
}

/** Size and turn of the print, if they are not its own. */
const varied = ({scale = 1, turnDeg = 0}: SolveResult['print']): string[] => [
  ...(scale === 1 ? [] : [`print at ${String(Number((100 * scale).toFixed(1)))} %`]),
  ...(turnDeg === 0 ? [] : [`print turned by ${String(turnDeg)} degrees`]),
];

/** The time of the solve, and that of the attempts that did not hold. */
function times({total, deformation, attempts = deformation}: Milliseconds): string[] {
  const before = attempts - deformation;
  return [
    `${String(total)} ms`,
    ...(before > 0 ? [`${String(before)} ms for attempts that moved too far`] : []),
  ];
}

/** The figures of a result in one line. */
export function figuresLine(name: string, result: SolveResult, asked: Asked): string {
  const {print, pieces, seams, metrics} = result;
  return [
    `${name}: ${countOf(pieces.length, 'piece')}, ${countOf(seams.length, 'seam')}, ${print.group}, ${metrics.method}, seed ${String(metrics.seed)}`,
    ...varied(print),
    ...matching(result, asked),
    ...mismatch(result, asked),
    `moved at most ${millimetres(metrics.maxMovedCm)}`,
    ...times(metrics.milliseconds),
  ].join('; ');
}

const quoted = (names: readonly string[]): string => names.map((name) => `'${name}'`).join(' and ');

const what: Readonly<Record<Remedy['kind'], (names: readonly string[]) => string>> = {
  turn: (names) => `Turn ${quoted(names)} by 90 degrees`,
  ungather: () => 'Leave out the gathers',
  mirrors: () => 'Take a print with mirrors',
  smaller: () => 'Take a print of half the repeat',
};

/** The text of a remedy, for example "Turn 'waistband' by 90 degrees: 20.5 -> 0.0 mm". */
export const remedyLine = ({kind, pieces, before, after}: Remedy): string =>
  `${what[kind](pieces)}: ${(10 * before).toFixed(1)} -> ${millimetres(after)}`;
