/**
 * Separates the pattern from what every page of paper has: borders, marks for gluing, page names.
 * Lengths in mm.
 */
import type {Point} from '../../../model/geometry/vectors.js';
import {boxOf, type Box} from '../../../model/geometry/polyline.js';
import {isRectangle} from '../../base/closed-lines.js';
import type {InkLine, InkText, PageInk} from './ink.js';

/** A page without its furniture. */
export interface Tile {
  readonly ink: PageInk;
  readonly lines: readonly InkLine[];
  readonly texts: readonly InkText[];
  /** True if it has the furniture of most pages of its size. */
  readonly isFurnished: boolean;
  /** The border of the page; the window where none is drawn. */
  readonly border: Box;
}

/** Layers of lines that belong to the paper. */
const furnitureLayer =
  /\b(?:page ?frames?|page ?borders?|tiles?|tiling|seitenrahmen|page ?marks?)\b/i;

/** Least share of the pages that have a line of the furniture, and least number of them. */
const usual = {share: 0.5, count: 3};

/** Least share of a page inside its border. */
const leastBorder = 0.45;

const sizeKey = ({width, height}: PageInk): string => `${width.toFixed(0)} ${height.toFixed(0)}`;

/** Pages by their size. */
export function bySize(pages: readonly PageInk[]): readonly (readonly PageInk[])[] {
  const groups = new Map<string, PageInk[]>();
  for (const page of pages) {
    const group = groups.get(sizeKey(page));
    if (group) group.push(page);
    else groups.set(sizeKey(page), [page]);
  }
  return [...groups.values()];
}

const rounded = ([x, y]: Point): string => `${x.toFixed(0)} ${y.toFixed(0)}`;

/** A key shared by lines of one shape at one place on their pages. */
function keyOf({points, isClosed}: InkLine): string {
  const {low, high} = boxOf(points);
  return `${rounded(low)} ${rounded(high)} ${isClosed ? points.length : 0}`;
}

/** Takes the furniture from pages of one size. */
export function withoutFurniture(pages: readonly PageInk[]): Tile[] {
  const counts = new Map<string, number>();
  for (const {lines} of pages) {
    for (const key of new Set(lines.map(keyOf))) counts.set(key, (counts.get(key) ?? 0) + 1);
  }
  const least = Math.max(usual.count, usual.share * pages.length);
  const common = new Set([...counts].filter(([, count]) => count >= least).map(([key]) => key));
  return pages.map((ink) => {
    const border =
      borderOf(ink, counts) ??
      borderBetween(
        ink,
        ink.lines.filter((line) => common.has(keyOf(line))),
      );
    const isOwn = (line: InkLine): boolean =>
      !common.has(keyOf(line)) && !isPaper(line) && !isBorder(line, ink, counts);
    const keys = new Set(ink.lines.map(keyOf));
    const found = [...common].filter((key) => keys.has(key)).length;
    return {
      ink,
      lines: ink.lines.filter(isOwn),
      texts: ink.texts.filter(({layer}) => layer === undefined || !furnitureLayer.test(layer)),
      isFurnished: common.size > 0 ? found >= common.size / 2 : ink.lines.some(isPaper),
      border,
    };
  });
}

const isPaper = ({style: {layer}}: InkLine): boolean =>
  layer !== undefined && furnitureLayer.test(layer);

/** Returns whether a line is a rectangle around most of its page that other pages have, too. */
function isBorder(
  line: InkLine,
  {width, height}: PageInk,
  counts: ReadonlyMap<string, number>,
): boolean {
  if (!line.isClosed || line.points.length > 8) return false;
  const {low, high} = boxOf(line.points);
  const share = ((high[0] - low[0]) * (high[1] - low[1])) / (width * height);
  const isUsual = isPaper(line) || (counts.get(keyOf(line)) ?? 0) > 1;
  return share >= leastBorder && isUsual && isRectangle(line.points);
}

/** The smallest border: beyond it, the page is glued beneath the next one. */
function borderOf(ink: PageInk, counts: ReadonlyMap<string, number>): Box | undefined {
  const area = ({low, high}: Box): number => (high[0] - low[0]) * (high[1] - low[1]);
  return ink.lines
    .filter((line) => isBorder(line, ink, counts))
    .map(({points}) => boxOf(points))
    .sort((a, b) => area(a) - area(b))[0];
}

/** Least share of a page that a line of its border spans. */
const leastSpan = 0.75;

/**
 * The border that single lines across a page draw. The side opposite to a line is that of the
 * window; without lines, that of the page.
 */
function borderBetween(
  {window: {low, high}, width, height}: PageInk,
  lines: readonly InkLine[],
): Box {
  const sides = (axis: 0 | 1): readonly [number, number] => {
    const along = axis === 0 ? 1 : 0;
    const places = lines.flatMap(({points, isClosed}) => {
      const box = boxOf(points);
      const span = along === 0 ? width : height;
      const isAcross = box.high[along] - box.low[along] >= leastSpan * span;
      const isStraight = box.high[axis] - box.low[axis] < 0.1;
      return !isClosed && isAcross && isStraight ? [box.low[axis]] : [];
    });
    const whole = axis === 0 ? width : height;
    if (places.length === 0) return [0, whole];
    const middle = whole / 2;
    return [
      Math.max(low[axis], ...places.filter((place) => place < middle)),
      Math.min(high[axis], ...places.filter((place) => place > middle)),
    ];
  };
  const [[left, right], [below, above]] = [sides(0), sides(1)];
  return {low: [left, below], high: [right, above]};
}
