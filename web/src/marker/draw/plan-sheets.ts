/**
 * Lays a layout out on sheets: figures above, then the fabric with pieces and rulers, then tables.
 * SVG and PDF are drawn from these sheets. Lengths in cm at the fabric's scale, y up, from a
 * sheet's lower left corner.
 */
import {leastLetterMm, type CutMark} from '../../cutting/cut-sheet.js';
import {printTitle} from '../../cutting/words.js';
import {sheetTextsIn} from '../../texts/sheet-texts.js';
import {nameLines} from '../../layout/name-lines.js';
import type {Point} from '../../model/geometry/vectors.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import type {Print} from '../../model/print/repeating-print.js';
import {
  cm,
  Filling,
  moved,
  textOf,
  type PlanSheet,
  type SheetFormat,
  type Size,
} from './plan-style.js';
import {fabricMarks, ruler, type DrawnFabric} from './plan-fabric.js';
import {namesIn, planPieces, repeatCorner, type KnownPieces} from './plan-pieces.js';
import {crossesTable, otherwiseTables, rowMarks, type Row, type Table} from './plan-tables.js';
import {
  factsOf,
  figuresOf,
  planWords,
  type Figure,
  type PlanWords,
  type PlanWordsOptions,
} from './plan-words.js';

export interface PlanOptions extends KnownPieces {
  readonly words: PlanWordsOptions;
  /** The garment's title. */
  readonly title?: string;
}

export type {PlanSheet} from './plan-style.js';

/** Tolerance of lengths for rounding. [cm] */
const rounding = 1e-9;
/** All in mm on paper. */
const tableWidth = 188;
const rulerRoom = 9;
const belowFabric = 11;
const aboveFabric = 4;
const gapBetween = 5;
const headingHeight = 10;
const figureHeight = 17;
const factHeight = 4.4;
const factSize = leastLetterMm;
const leastFabric = 40;

const heightOf = (rows: readonly Row[]): number => rows.reduce((sum, row) => sum + row.height, 0);

/** A figure in its own column. */
const figureMarks = (size: Size, {caption, value, note}: Figure, [x, y]: Point): CutMark[] => [
  textOf(size, [x, y - cm(size, 2)], caption, leastLetterMm, {align: 'left'}),
  textOf(size, [x, y - cm(size, 7.2)], value, 5.2, {align: 'left', weight: 'bold'}),
  textOf(size, [x, y - cm(size, 12)], note, leastLetterMm, {align: 'left'}),
];

function addHeading(
  filling: Filling,
  heading: string,
  figures: readonly Figure[],
  facts: readonly string[],
): void {
  const {size} = filling;
  filling.add(cm(size, headingHeight), ([x, y]) => [
    textOf(size, [x, y - cm(size, 3.5)], heading, 6, {align: 'left', weight: 'bold'}),
  ]);
  filling.add(cm(size, figureHeight), ([x, y]) =>
    figures.flatMap((figure, k) =>
      figureMarks(size, figure, [x + cm(size, (k * tableWidth) / 4), y]),
    ),
  );
  for (const line of facts.flatMap((fact) => nameLines(fact, tableWidth, factSize))) {
    filling.add(cm(size, factHeight), ([x, y]) => [
      textOf(size, [x, y - cm(size, factHeight / 2)], line, factSize, {align: 'left'}),
    ]);
  }
}

function addTable(filling: Filling, {head, rows}: Table): void {
  const {size} = filling;
  const put = (row: Row): void => {
    filling.add(cm(size, row.height), (at) => rowMarks(size, row, at, tableWidth));
  };
  const space = cm(size, gapBetween);
  // keeps a table's head together with at least two rows
  const needed = space + cm(size, heightOf([...head, ...rows.slice(0, 2)]));
  if (needed > filling.left) filling.turn();
  else if (!filling.isFresh) filling.add(space);
  head.forEach(put);
  for (const row of rows) {
    if (cm(size, row.height) > filling.left) {
      filling.turn();
      head.forEach(put);
    }
    put(row);
  }
}

/** Ruler steps in centimetres and inches. */
const rulerSteps = {cm: {step: 5, long: 2, unitCm: 1}, inch: {step: 1, long: 6, unitCm: 2.54}};
const fineSteps = {cm: {step: 1, long: 10, unitCm: 1}, inch: {step: 1, long: 6, unitCm: 2.54}};

function addFabric(
  filling: Filling,
  fabric: DrawnFabric,
  isRoll: boolean,
  {texts, units}: PlanWords,
): void {
  const {size} = filling;
  const {widthCm, lengthCm} = fabric;
  const steps = (isRoll ? fineSteps : rulerSteps)[units];
  const [beside, below] = isRoll ? [0, 0] : [cm(size, rulerRoom), cm(size, belowFabric)];
  filling.add(cm(size, aboveFabric));
  const holes = fabric.pieces.flatMap(({laid}) => laid?.cut.slice(1) ?? []);
  for (let from = 0; from < lengthCm - rounding;) {
    const rest = lengthCm - from;
    if (filling.left - below < Math.min(rest, cm(size, leastFabric))) filling.turn();
    const to = from + Math.min(rest, filling.left - below);
    const marks = fabricMarks(size, fabric, [from, to]);
    if (isRoll) {
      const along = ruler(size, 1, [from, to], {...steps, side: -1, hasPlate: true});
      filling.addFabric([from, to], [0, 0], {marks: [...marks, ...along], holes}, []);
    } else {
      const style = {...steps, side: 1, hasPlate: false} as const;
      filling.addFabric([from, to], [beside, below], {marks, holes}, [
        ...ruler(size, 1, [from, to], style),
        ...moved(ruler(size, 0, [0, widthCm], style), [0, from]),
        ...(from === 0
          ? [textOf(size, [widthCm / 2, -cm(size, 8)], texts.start, leastLetterMm)]
          : []),
      ]);
    }
    from = to;
  }
}

export function planSheets(
  plan: LayPlan,
  print: Print,
  options: PlanOptions,
  format: SheetFormat,
): readonly PlanSheet[] {
  const words = planWords(options.words);
  const {texts} = words;
  const nameOf = namesIn(plan, options, texts.garment);
  const pieces = planPieces(plan, options, nameOf);
  const ring = repeatCorner(plan);
  const filling = new Filling(format);
  const heading = [options.title, texts.title(format.scale)]
    .filter((one) => one !== undefined)
    .join(': ');
  const printName = printTitle(print, sheetTextsIn(options.words.locale));
  const facts = factsOf(plan, words, {printName, ring, nameOf});
  const {widthCm, lengthCm, selvedgeCm} = plan;
  const tables = [
    ...(plan.printOrigin ? [crossesTable(pieces, words)] : []),
    ...otherwiseTables(plan, words),
  ];
  const {isRoll} = format;
  const steps = [
    () => {
      addFabric(filling, {widthCm, lengthCm, selvedgeCm, pieces, ring}, isRoll, words);
    },
    () => {
      for (const table of tables) addTable(filling, table);
    },
  ];
  if (isRoll) filling.add(cm(filling.size, aboveFabric));
  addHeading(filling, heading, figuresOf(plan, words), facts);
  // on a roll, the heading unrolls first, so the tables come before the fabric
  for (const step of isRoll ? steps.toReversed() : steps) step();
  filling.turn();
  return filling.done;
}

/**
 * Least width of a sheet at 1 : scale that shows the whole width of a layout. [cm on paper, without
 * margins]
 */
export const leastWidth = ({widthCm}: LayPlan, scale: number): number =>
  Math.max(tableWidth / 10, widthCm / scale + rulerRoom / 10 + 0.2);
