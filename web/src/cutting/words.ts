/** Text of a cutting sheet and of each piece. */
import {angleOf, degrees, minus} from '../model/geometry/vectors.js';
import type {Print} from '../model/print/repeating-print.js';
import {repeatOf} from '../model/print/repeat.js';
import {formatLength, type Units} from '../model/base/length-text.js';
import type {AllowanceRule} from './allowance-rule.js';
import type {CutPiece, EdgeAllowance} from './cut-piece.js';

export interface WordsOptions extends AllowanceRule {
  readonly units: Units;
  /** Locale of numbers. Default 'en'. */
  readonly locale?: string;
  /** Name of the print's colourway. */
  readonly colourway?: string;
  /** Creation date as text. */
  readonly date?: string;
}

/** Smallest rotation that is mentioned. [degrees] */
const leastTurn = 0.05;

const printName = (print: Print, {colourway}: WordsOptions): string =>
  [print.title ?? `Print ${print.group}`, ...(colourway === undefined ? [] : [colourway])].join(
    ', ',
  );

function repeatSize(print: Print, {units, locale = 'en'}: WordsOptions): string {
  const {width, height} = repeatOf(print).size;
  return [width, height].map((cm) => formatLength(cm, units, locale)).join(' × ');
}

/** Rotation of the print from the grain line of a piece, in (-90, 90]. [degrees] */
function turnOf({grain: [foot, head], alignment}: CutPiece, print: Print): number {
  const turn = degrees(alignment.angle - angleOf(minus(head, foot))) + 90 + repeatOf(print).turnDeg;
  return turn - 180 * Math.ceil(turn / 180 - 0.5);
}

function turnWords(piece: CutPiece, print: Print, {locale = 'en'}: WordsOptions): string {
  const turn = turnOf(piece, print);
  if (Math.abs(turn) < leastTurn) return '';
  const amount = turn.toLocaleString(locale, {maximumFractionDigits: 1});
  return `, turned ${amount}°`;
}

/**
 * The text of a piece, with the most important lines first.
 * @param print undefined for plain fabric
 */
export function pieceWords(
  piece: CutPiece,
  {
    print,
    twin,
    heading,
  }: {
    readonly print: Print | undefined;
    readonly twin: string | undefined;
    readonly heading: string;
  },
  options: WordsOptions,
): readonly string[] {
  const {label, quantity} = piece;
  return [
    label,
    print ? `Cut ${quantity}, face up, single layer` : `Cut ${quantity} of plain fabric`,
    ...(twin === undefined ? [] : [`Mirror image of ${twin}`]),
    ...(heading === '' ? [] : [heading]),
    ...(print
      ? [
          printName(print, options),
          `${repeatSize(print, options)}${turnWords(piece, print, options)}`,
        ]
      : []),
  ];
}

/** The stated allowance of one kind of edges, and whether it holds for all of them. */
interface SaidWidth {
  readonly said: string | undefined;
  readonly isAll: boolean;
}

/** The allowance of the rule if any edge uses it, otherwise a common allowance of all edges. */
function saidOf(
  edges: readonly EdgeAllowance[],
  ruledCm: number,
  length: (cm: number) => string,
): SaidWidth {
  const widths = [...new Set(edges.map(({widthCm}) => length(widthCm)))];
  const isAll = widths.length < 2;
  if (isAll) return {said: widths[0], isAll};
  return {said: edges.every(({isOwn}) => isOwn) ? undefined : length(ruledCm), isAll};
}

/** The line styles of cut and sewn lines, and the distance between them. */
function linesSentence(cuts: readonly CutPiece[], options: WordsOptions): string {
  const {allowanceCm, hemCm = allowanceCm, units, locale = 'en'} = options;
  const length = (cm: number): string => formatLength(cm, units, locale);
  const edges = cuts.flatMap(({allowances}) => allowances);
  if (edges.every(({widthCm}) => widthCm === 0)) {
    return 'Without allowance: sew along the solid line.';
  }
  const [seam, hem] = [false, true].map((hems) =>
    saidOf(
      edges.filter(({isHem}) => isHem === hems),
      hems ? hemCm : allowanceCm,
      length,
    ),
  ) as [SaidWidth, SaidWidth];
  const parts = [
    'Solid: cut. Dashed: sew',
    ...(seam.said === undefined ? [] : [`${seam.said} inside`]),
    ...(hem.said === undefined || hem.said === seam.said ? [] : [`${hem.said} at hems`]),
    ...(seam.isAll && hem.isAll ? [] : ['elsewhere as the pattern says']),
  ];
  const isTold = seam.said !== undefined || hem.said !== undefined;
  return isTold
    ? `${parts.join(', ')}.`
    : 'Solid: cut. Dashed: sew, as far inside as the pattern says.';
}

/** Facts about the sheet, one sentence each. */
export function factsOf(
  cuts: readonly CutPiece[],
  print: Print | undefined,
  options: WordsOptions,
): readonly string[] {
  const {date} = options;
  return [
    ...(print ? [`${printName(print, options)}, repeat ${repeatSize(print, options)}`] : []),
    linesSentence(cuts, options),
    ...(cuts.some(({internalLines}) => internalLines.length > 0)
      ? ['Dash-dot: lines that the pattern draws inside.']
      : []),
    ...(cuts.some(({folds}) => folds.length > 0)
      ? ['Long dashes: folds; lay their lines on each other as the arrows say, before sewing.']
      : []),
    'Edges with the same letter are sewn together.',
    'Each piece is cut from a single layer, face up; none lies on a fold.',
    ...(cuts.some(({matches}) => matches.length > 0)
      ? [
          'Numbered crosses of a piece lie on the same point of the print;',
          'the faint frame around each shows one repeat.',
        ]
      : []),
    ...(cuts.some(({ticks}) => ticks.length > 0)
      ? ['Ticks a, b, c of a seam: those of one name, such as Ab, meet on one point of the print.']
      : []),
    'Print at 100 %; measure the squares.',
    ...(date === undefined ? [] : [date]),
  ];
}
