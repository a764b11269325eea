/** Text of a cutting sheet and of each piece. */
import {angleOf, degrees, minus} from '../model/geometry/vectors.js';
import {shrinks} from '../model/print/as-cut.js';
import type {Print} from '../model/print/repeating-print.js';
import {repeatOf} from '../model/print/repeat.js';
import {formatLength, type Units} from '../model/base/length-text.js';
import type {AllowanceRule} from './allowance-rule.js';
import {sheetTextsIn, type SheetTexts} from '../texts/sheet-texts.js';
import type {CutPiece, EdgeAllowance} from './cut-piece.js';

export interface WordsOptions extends AllowanceRule {
  readonly units: Units;
  /** Locale of numbers and texts. Default 'en'. */
  readonly locale?: string;
  /** Name of the print's colourway. */
  readonly colourway?: string;
  /** Creation date as text. */
  readonly date?: string;
}

/** Smallest rotation that is mentioned. [degrees] */
const leastTurn = 0.05;

/** The name of a print, which is that of its group if it has no title. */
export const printTitle = (print: Print, texts: SheetTexts): string =>
  print.title ?? texts.print(print.group);

const printName = (print: Print, {colourway, locale}: WordsOptions): string =>
  [printTitle(print, sheetTextsIn(locale)), ...(colourway === undefined ? [] : [colourway])].join(
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

/** The size of the repeat, and its rotation from the grain line of a piece. */
function repeatWords(piece: CutPiece, print: Print, options: WordsOptions): string {
  const size = repeatSize(print, options);
  const turn = turnOf(piece, print);
  if (Math.abs(turn) < leastTurn) return size;
  const {locale = 'en'} = options;
  const amount = turn.toLocaleString(locale, {maximumFractionDigits: 1});
  return sheetTextsIn(locale).turned(size, amount);
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
  const {label, quantity, grainName} = piece;
  const texts = sheetTextsIn(options.locale);
  return [
    label,
    print ? texts.cut(quantity) : texts.cutPlain(quantity),
    ...(twin === undefined ? [] : [texts.mirror(twin)]),
    ...(heading === '' ? [] : [heading]),
    ...(grainName === undefined ? [] : [grainName]),
    ...(print ? [printName(print, options), repeatWords(piece, print, options)] : []),
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
  const texts = sheetTextsIn(locale);
  const length = (cm: number): string => formatLength(cm, units, locale);
  const edges = cuts.flatMap(({allowances}) => allowances);
  if (edges.every(({widthCm}) => widthCm === 0)) {
    return texts.noAllowance;
  }
  const [seam, hem] = [false, true].map((hems) =>
    saidOf(
      edges.filter(({isHem}) => isHem === hems),
      hems ? hemCm : allowanceCm,
      length,
    ),
  ) as [SaidWidth, SaidWidth];
  const parts = [
    texts.lines,
    ...(seam.said === undefined ? [] : [texts.seamInside(seam.said)]),
    ...(hem.said === undefined || hem.said === seam.said ? [] : [texts.hemInside(hem.said)]),
    ...(seam.isAll && hem.isAll ? [] : [texts.otherwise]),
  ];
  const isTold = seam.said !== undefined || hem.said !== undefined;
  return isTold ? `${parts.join(', ')}.` : texts.asPattern;
}

/** The reason why pieces are larger than sewn, if they are. */
function shrinkageFact(
  print: Print | undefined,
  texts: SheetTexts,
  locale = 'en',
): readonly string[] {
  const {shrinkage} = print?.delivered ?? {};
  if (!shrinkage || !shrinks({shrinkage})) return [];
  const percent = (share: number): string =>
    share.toLocaleString(locale, {maximumFractionDigits: 2});
  return [texts.shrinks(percent(shrinkage.warp), percent(shrinkage.weft))];
}

/** Facts about the sheet, one sentence each. */
export function factsOf(
  cuts: readonly CutPiece[],
  print: Print | undefined,
  options: WordsOptions,
): readonly string[] {
  const {date, locale} = options;
  const texts = sheetTextsIn(locale);
  const has = (marked: (piece: CutPiece) => readonly unknown[]): boolean =>
    cuts.some((piece) => marked(piece).length > 0);
  return [
    ...(print ? [texts.repeat(printName(print, options), repeatSize(print, options))] : []),
    ...shrinkageFact(print, texts, locale),
    linesSentence(cuts, options),
    ...(has(({internalLines}) => internalLines) ? [texts.internal] : []),
    ...(has(({folds}) => folds) ? [texts.folds] : []),
    texts.letters,
    texts.singleLayer,
    ...(has(({matches}) => matches) ? [texts.crosses, texts.frames] : []),
    ...(has(({ticks}) => ticks) ? [texts.ticks] : []),
    texts.scale,
    ...(date === undefined ? [] : [date]),
  ];
}
