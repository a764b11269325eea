/** Names of pages, such as A1, 2B or "row 1, column 3", as rows and columns. */
import type {Point} from '../../../model/geometry/vectors.js';
import type {InkText, PageInk} from './ink.js';

/** The place of a page in the grid, from 0. Rows are counted from the top. */
export interface Cell {
  readonly row: number;
  readonly column: number;
}

/** The two parts of a name, from 0, in the order of the name. */
type Pair = readonly [first: number, second: number];

const letterIndex = (letter: string): number => letter.toUpperCase().charCodeAt(0) - 65;

const rowWords = 'row|reihe|zeile|rang(?:ée)?|ligne|riga|fila';
const columnWords = 'col(?:umn|\\.)?|spalte|colonne|colonna|columna';
const rowThenColumn = new RegExp(
  `\\b(?:${rowWords})\\W*(\\d{1,2})\\W+(?:${columnWords})\\W*(\\d{1,2})`,
  'i',
);
const columnThenRow = new RegExp(
  `\\b(?:${columnWords})\\W*(\\d{1,2})\\W+(?:${rowWords})\\W*(\\d{1,2})`,
  'i',
);

function pairOf(text: string): Pair | undefined {
  const letterFirst = /^([A-Z])[ -]?(\d{1,2})$/i.exec(text);
  if (letterFirst) return [letterIndex(letterFirst[1] ?? 'A'), Number(letterFirst[2]) - 1];
  const numberFirst = /^(\d{1,2})[ -]?([A-Z])$/i.exec(text);
  if (numberFirst) return [Number(numberFirst[1]) - 1, letterIndex(numberFirst[2] ?? 'A')];
  const worded = rowThenColumn.exec(text);
  if (worded) return [Number(worded[1]) - 1, Number(worded[2]) - 1];
  const turned = columnThenRow.exec(text);
  if (turned) return [Number(turned[2]) - 1, Number(turned[1]) - 1];
  const plain = /^(?:\p{L}* ?\( ?)?(\d{1,2}) ?[-/.,:x×] ?(\d{1,2})(?: ?\))?$/u.exec(text);
  return plain ? [Number(plain[1]) - 1, Number(plain[2]) - 1] : undefined;
}

interface Named {
  readonly page: number;
  readonly pair: Pair;
}

/** Texts at one place of their pages have one key. */
const placeKey = ({from, size}: InkText, {height}: PageInk): string =>
  [from[0], height - from[1], 2 * size].map((value) => (value / 5).toFixed(0)).join(' ');

/**
 * The grids that the names of pages may mean, the pages in the given order: first part as row or as
 * column, counted from above or from below. Empty if most pages have no names of their own.
 */
export function namedGrids(pages: readonly PageInk[]): (readonly Cell[])[] {
  const places = new Map<string, Named[]>();
  pages.forEach((ink, page) => {
    for (const text of ink.texts) {
      const pair = pairOf(text.text.trim());
      if (!pair || pair.some((part) => part < 0)) continue;
      const key = placeKey(text, ink);
      const list = places.get(key) ?? [];
      if (list.every((one) => one.page !== page)) list.push({page, pair});
      places.set(key, list);
    }
  });
  const distinct = (list: readonly Named[]): number =>
    new Set(list.map(({pair}) => pair.join(' '))).size;
  const [best] = [...places.values()].sort((a, b) => distinct(b) - distinct(a));
  if (best?.length !== pages.length || distinct(best) !== pages.length) return [];
  const pairs = best.sort((a, b) => a.page - b.page).map(({pair}) => pair);
  return [
    pairs.map(([row, column]): Cell => ({row, column})),
    pairs.map(([column, row]): Cell => ({row, column})),
  ].flatMap((cells) => [cells, upsideDown(cells)]);
}

/** The grid with its rows counted from below. */
function upsideDown(cells: readonly Cell[]): readonly Cell[] {
  const last = Math.max(...cells.map(({row}) => row));
  return cells.map(({row, column}) => ({row: last - row, column}));
}

/** The grids of pages in reading order, or column by column, in every shape. */
export function orderedGrids(count: number): (readonly Cell[])[] {
  const indices = Array.from({length: count}, (_, k) => k);
  const widths = indices.map((k) => k + 1);
  return [
    ...widths.map((columns) =>
      indices.map((k): Cell => ({row: Math.floor(k / columns), column: k % columns})),
    ),
    ...widths
      .filter((rows) => rows > 1 && rows < count)
      .map((rows) => indices.map((k): Cell => ({row: k % rows, column: Math.floor(k / rows)}))),
  ];
}

/** The grid of a given number of columns and rows, in reading order. */
export const statedGrid = (count: number, [columns]: Point): readonly Cell[] =>
  Array.from({length: count}, (_, k) => ({row: Math.floor(k / columns), column: k % columns}));
