/**
 * Tables of a layout, row by row from the top. Lengths in cm, y up, from the left end of the upper
 * edge.
 */
import {leastLetterMm, type CutMark} from '../../cutting/cut-sheet.js';
import type {Point} from '../../model/geometry/vectors.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import type {PlanPiece} from './plan-pieces.js';
import {cm, lineOf, textOf, type Size} from './plan-style.js';
import type {PlanWords} from './plan-words.js';

interface Cell {
  readonly words: string;
  /** Position of the text's aligned end, from the left. [mm on paper] */
  readonly x: number;
  readonly align: 'left' | 'right';
  readonly isBold?: boolean;
}

/** A row of a table, or its title. */
export interface Row {
  /** [mm on paper] */
  readonly height: number;
  readonly size: number;
  readonly cells: readonly Cell[];
  readonly rule?: 'below' | 'faint';
}

/**
 * A table. Its head stays with the first rows, and is repeated if the table continues on another
 * sheet.
 */
export interface Table {
  readonly head: readonly Row[];
  readonly rows: readonly Row[];
}

const rowHeight = 4.8;
const rowSize = leastLetterMm;
const headSize = leastLetterMm;
const titleSize = 3;
const left = 0;

const title = (words: string): Row => ({
  ...{height: 6.5, size: titleSize},
  cells: [{words, x: left, align: 'left', isBold: true}],
});

/** The table of each piece's crosses on the fabric. */
export function crossesTable(pieces: readonly PlanPiece[], words: PlanWords): Table {
  const {texts, place, unit} = words;
  const columns = [94, 140, 186];
  const pair = (at: Point | undefined): string =>
    at ? `${place(at[0])} × ${place(at[1])}` : texts.none;
  return {
    head: [
      title(texts.crosses),
      {
        ...{height: 4, size: headSize},
        cells: [{words: texts.crossesUnit(unit), x: left, align: 'left'}],
      },
      {
        ...{height: rowHeight, size: headSize, rule: 'below'},
        cells: [
          {words: texts.number, x: 7, align: 'right'},
          {words: texts.piece, x: 10, align: 'left'},
          ...columns.map((x, k): Cell => ({words: texts.cross(k + 1), x, align: 'right'})),
        ],
      },
    ],
    rows: pieces.map(({number, name, crosses}): Row => ({
      ...{height: rowHeight, size: rowSize, rule: 'faint'},
      cells: [
        {words: String(number), x: 7, align: 'right', isBold: true},
        {words: name, x: 10, align: 'left'},
        ...columns.map((x, k): Cell => ({words: pair(crosses[k]), x, align: 'right'})),
      ],
    })),
  };
}

/** Most columns that are legible and fit a page. */
const mostColumns = 10;
const firstColumn = 46;
const columnWidth = 14;

/** Two rows of figures in pairs, one below the other. */
function pairedTable(
  heading: string,
  [upper, lower]: readonly [string, string],
  columns: readonly {readonly upper: string; readonly lower: string; readonly isOwn: boolean}[],
): Table {
  const row = (
    name: string,
    value: (column: (typeof columns)[number]) => string,
    some: typeof columns,
    rule?: 'below',
  ): Row => ({
    ...{height: rowHeight, size: rowSize},
    ...(rule && {rule}),
    cells: [
      {words: name, x: left, align: 'left'},
      ...some.map((column, k): Cell => ({
        ...{words: value(column), x: firstColumn + columnWidth * k, align: 'right'},
        isBold: column.isOwn,
      })),
    ],
  });
  const groups = Array.from({length: Math.ceil(columns.length / mostColumns)}, (_, k) =>
    columns.slice(k * mostColumns, (k + 1) * mostColumns),
  );
  return {
    head: [title(heading)],
    rows: groups.flatMap((some) => [
      row(upper, (column) => column.upper, some, 'below'),
      row(lower, (column) => column.lower, some),
    ]),
  };
}

/** Lengths of the layout for other starts of the print and other fabric widths. */
export function otherwiseTables(
  {phases, widths, widthCm: own, lengthCm, printOrigin}: LayPlan,
  {texts, short, unit}: PlanWords,
): readonly Table[] {
  const lengthOf = (cm: number | null): string => (cm === null ? texts.none : short(cm));
  const names = (first: string): [string, string] => [
    `${first} (${unit})`,
    `${texts.length} (${unit})`,
  ];
  return [
    ...(printOrigin && phases.length > 1
      ? [
          pairedTable(
            texts.phases,
            names(texts.phase),
            phases.map(({phaseCm, lengthCm: length}) => ({
              upper: short(phaseCm),
              lower: lengthOf(length),
              isOwn: length === lengthCm,
            })),
          ),
        ]
      : []),
    ...(widths.length > 0
      ? [
          pairedTable(
            texts.widths,
            names(texts.width),
            widths.map(({widthCm, lengthCm: length}) => ({
              upper: short(widthCm),
              lower: lengthOf(length),
              isOwn: widthCm === own,
            })),
          ),
        ]
      : []),
  ];
}

/**
 * Draws a row.
 * @param at the left end of its upper edge
 * @param width in mm on paper
 */
export function rowMarks(
  size: Size,
  {height, size: letters, cells, rule}: Row,
  [x, y]: Point,
  width: number,
): readonly CutMark[] {
  const middle = y - cm(size, height / 2);
  return [
    ...cells.map(({words, x: aside, align, isBold}) =>
      textOf(size, [x + cm(size, aside), middle], words, letters, {
        ...{align, weight: isBold ? 'bold' : 'regular'},
      }),
    ),
    ...(rule
      ? [
          lineOf(
            size,
            [
              [x, y - cm(size, height)],
              [x + cm(size, width), y - cm(size, height)],
            ],
            {width: rule === 'below' ? 0.25 : 0.12, isFaint: rule === 'faint'},
          ),
        ]
      : []),
  ];
}
