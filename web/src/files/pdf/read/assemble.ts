/** Chooses the pages with the pattern and puts them together to one sheet. Lengths in mm, y up. */
import {boxOf, type Box} from '../../../model/geometry/polyline.js';
import type {Point} from '../../../model/geometry/vectors.js';
import {arranged, type Arrangement, type StatedGrid} from './arrange.js';
import {isInBox, partsInBox} from './cut-lines.js';
import {regionsOf} from './regions.js';
import {bySize, withoutFurniture, type Tile} from './furniture.js';
import {middleOf, type InkLine, type InkText, type PageInk} from './ink.js';
import {chosenTiles} from './page-kinds.js';
import {weldedLines} from './weld.js';

/** A page on the sheet. */
interface PlacedPage {
  /** Page number in the file. */
  readonly number: number;
  /** Row and column from 0; undefined for pages beside each other that have no joints. */
  readonly cell?: {readonly row: number; readonly column: number};
  /** The shown part of the page on the sheet. */
  readonly box: Box;
}

/** A joint whose lines do not meet. */
interface OpenJoint {
  readonly pages: readonly [number, number];
  /** Number of lines that end at the joint. */
  readonly misses: number;
}

export interface Sheet {
  readonly lines: readonly InkLine[];
  readonly texts: readonly InkText[];
  readonly pages: readonly PlacedPage[];
  /** Numbers of pages that are left out. */
  readonly others: readonly number[];
  readonly columns: number;
  readonly rows: number;
  /** Undefined without joints. [mm] */
  readonly overlap?: Point;
  /** Distance from the left side of pages to the drawn part; undefined without joints. */
  readonly trim?: number;
  readonly openJoints: readonly OpenJoint[];
  readonly notes: readonly string[];
}

/** Gap between pages without joints. */
const apart = 50;

/** Puts the pages of a file together. */
export function assembled(pages: readonly PageInk[], stated: StatedGrid): Sheet {
  const tiles = bySize(pages).flatMap(withoutFurniture);
  const {chosen: drawn, notes} = chosenTiles(tiles, stated);
  const {chosen, arrangement} = joinable(drawn, stated);
  const hidden = new Set(stated.without ?? []);
  const isChosen = new Set(
    chosen.map(({ink}) => ink.number).filter((number) => !hidden.has(number)),
  );
  const others = pages.map(({number}) => number).filter((number) => !isChosen.has(number));
  const isTiled =
    arrangement !== undefined &&
    (arrangement.score > 0 ||
      arrangement.isNamed ||
      stated.grid !== undefined ||
      stated.places !== undefined);
  const sheet = isTiled
    ? joined(chosen, arrangement, hidden)
    : besideEachOther(chosen.filter(({ink}) => !hidden.has(ink.number)));
  return {...sheet, others, notes: [...notes, ...sheet.notes]};
}

/** The tiles with their arrangement. If they do not join, the first may be a cover. */
function joinable(
  tiles: readonly Tile[],
  stated: StatedGrid,
): {readonly chosen: readonly Tile[]; readonly arrangement?: Arrangement} {
  if (tiles.length < 2) return {chosen: tiles};
  const arrangement = arranged(tiles, stated);
  const isExact = stated.isExact === true || stated.grid !== undefined;
  if (arrangement.score > 0 || isExact || tiles.length < 3) return {chosen: tiles, arrangement};
  const rest = tiles.slice(1);
  const other = arranged(rest, stated);
  return other.score > 0 ? {chosen: rest, arrangement: other} : {chosen: tiles, arrangement};
}

type Joined = Omit<Sheet, 'others'>;

/** Both sides of the outline of one piece end on both pages. */
const manyMisses = 4;

function joined(
  tiles: readonly Tile[],
  arrangement: Arrangement,
  hidden: ReadonlySet<number>,
): Joined {
  const {cells, window, overlap, joints} = arrangement;
  const {low, high} = window;
  const steps: Point = [high[0] - low[0] - overlap[0], high[1] - low[1] - overlap[1]];
  const taken = new Set(cells.map(({row, column}) => `${row} ${column}`));
  const all = tiles.map((tile, k) => {
    const {row, column} = cells[k] ?? {row: 0, column: 0};
    const shift: Point = [column * steps[0] - low[0], -row * steps[1] - high[1]];
    const isTaken = (r: number, c: number): boolean => taken.has(`${r} ${c}`);
    const regions = regionsOf(arrangement, {row, column}, isTaken);
    return placedTile(tile, regions, shift, {row, column});
  });
  const placed = all.filter(({page}) => !hidden.has(page.number));
  const openJoints = joints
    .filter(({meets, misses}) => misses >= manyMisses && misses > meets)
    .map(({a, b, misses}): OpenJoint => {
      const number = (index: number): number => tiles[index]?.ink.number ?? 0;
      return {pages: [number(a), number(b)], misses};
    });
  const columns = Math.max(...cells.map(({column}) => column)) + 1;
  const rows = Math.max(...cells.map(({row}) => row)) + 1;
  const {lines, ...rest} = union(placed);
  const welded = weldedLines(
    lines,
    placed.flatMap(({cuts}) => cuts),
  );
  return {...rest, lines: welded, columns, rows, overlap, trim: low[0], openJoints, notes: []};
}

interface Placed {
  readonly page: PlacedPage;
  /** Corners of the parts into which its lines are cut. */
  readonly cuts: readonly Point[];
  readonly lines: readonly InkLine[];
  readonly texts: readonly InkText[];
}

function placedTile(
  {ink, lines, texts}: Tile,
  regions: readonly Box[],
  shift: Point,
  cell?: PlacedPage['cell'],
): Placed {
  const moved = ([x, y]: Point): Point => [x + shift[0], y + shift[1]];
  const around = boxOf(regions.flatMap(({low, high}) => [low, high]));
  return {
    page: {
      number: ink.number,
      ...(cell && {cell}),
      box: {low: moved(around.low), high: moved(around.high)},
    },
    cuts: regions.flatMap(({low, high}) => [moved(low), moved(high)]),
    lines: lines.flatMap((line) =>
      regions.flatMap((region) =>
        partsInBox(line, region).map((part) => ({
          ...part,
          points: part.points.map(moved),
          style: line.style,
        })),
      ),
    ),
    texts: texts
      .filter((text) => regions.some((region) => isInBox(region, middleOf(text))))
      .map((text) => ({...text, from: moved(text.from), to: moved(text.to)})),
  };
}

const union = (placed: readonly Placed[]): Pick<Sheet, 'lines' | 'texts' | 'pages'> => ({
  lines: placed.flatMap(({lines}) => lines),
  texts: placed.flatMap(({texts}) => texts),
  pages: placed.map(({page}) => page),
});

function besideEachOther(tiles: readonly Tile[]): Joined {
  let left = 0;
  const placed = tiles.map((tile) => {
    const {width, height} = tile.ink;
    const one = placedTile(tile, [{low: [0, 0], high: [width, height]}], [left, -height]);
    left += width + apart;
    return one;
  });
  return {...union(placed), columns: tiles.length, rows: 1, openJoints: [], notes: []};
}
