/** Divides a sheet among pages. Lengths in cm on the sheet, y up. */
import type {CutSheet} from '../cutting/cut-sheet.js';
import type {Point} from '../model/geometry/vectors.js';
import {letters} from '../model/garment/letters.js';
import {boxOf, type Box} from '../model/geometry/polyline.js';
import {boxAt, grown, overlap, reachesInto} from './boxes.js';
import type {Paper} from './papers.js';

export interface SheetPage {
  /** Row number and column letter, as 2A; undefined for a page that shows nothing of the sheet. */
  readonly name?: string;
  readonly row: number;
  readonly column: number;
  /** Position of the page's lower left corner. */
  readonly low: Point;
  /** The part of the sheet that is drawn. */
  readonly window: Box;
  /** The part of the window that is not glued beneath another page. */
  readonly frame: Box;
}

/** Pages of equal size. */
export interface PageLayout {
  readonly paper: Paper;
  readonly widthCm: number;
  readonly heightCm: number;
  readonly columns: number;
  readonly rows: number;
  /** In reading order. */
  readonly pages: readonly SheetPage[];
  /** Frames of empty pages, which are omitted. */
  readonly empty: readonly Box[];
  /** Position of the test squares and text on the first page. */
  readonly block: Box;
}

/** Margin that printers cannot reach. */
export const usualMargin = 1;
/** Overlap of glued pages. */
const overlapCm = 1;
/** Space for the width of lines at the edge of the sheet. */
const pad = 0.2;
const projectorPad = 0.5;
/** Greatest page size in viewers, 200 inches, minus rounding. */
const longest = 500;
/**
 * The block's distance from pieces is half of this, which is also the grid step of its search;
 * large pages use a coarser grid.
 */
const step = 1;
const mostTries = 30;

/** A paper in one orientation, with its margins. */
interface Format {
  readonly width: number;
  readonly height: number;
  readonly margin: number;
  readonly pad: number;
  readonly keepsBlank?: boolean;
  /** Axis along which pages may grow for content. */
  readonly grows?: 0 | 1;
}

/** The pages of a sheet in one format. The spare length is distributed by a share. */
interface Tiling {
  readonly format: Format;
  readonly columns: number;
  readonly rows: number;
  readonly pages: readonly SheetPage[];
  readonly empty: readonly Box[];
}

const shares = [0.5, 0, 1] as const;

/** Number of pages in one direction, and the spare length. */
function divided(length: number, page: number): {readonly count: number; readonly left: number} {
  const count = Math.max(1, Math.ceil((length - overlapCm) / (page - overlapCm) - 1e-9));
  return {count, left: count * (page - overlapCm) + overlapCm - length};
}

function tiling(
  {pieces, widthCm, heightCm}: CutSheet,
  format: Format,
  [shareX, shareY]: Point,
): Tiling {
  const {margin, pad: around} = format;
  const [w, h] = [format.width - 2 * margin, format.height - 2 * margin];
  const across = divided(widthCm + 2 * around, w);
  const down = divided(heightCm + 2 * around, h);
  const left = -around - across.left * shareX;
  const top = heightCm + around + down.left * shareY;
  const boxes = pieces.map(({cut}) => boxOf(cut[0] ?? []));
  const pages: SheetPage[] = [];
  const empty: Box[] = [];
  for (let row = 0; row < down.count; row++) {
    for (let column = 0; column < across.count; column++) {
      const low: Point = [left + column * (w - overlapCm), top - row * (h - overlapCm) - h];
      const glued = [column < across.count - 1, row < down.count - 1].map((is) =>
        is ? overlapCm : 0,
      );
      const [right = 0, below = 0] = glued;
      const frame = boxAt([low[0], low[1] + below], w - right, h - below);
      const isEmpty = pieces.every(
        ({cut}, k) => !overlap(boxes[k] ?? frame, frame) || !reachesInto(cut, frame),
      );
      if (isEmpty && !format.keepsBlank) empty.push(frame);
      else {
        pages.push({
          ...{name: `${row + 1}${letters(column)}`, row, column, frame},
          low: [low[0] - margin, low[1] - margin],
          window: boxAt(low, w, h),
        });
      }
    }
  }
  return {format, columns: across.count, rows: down.count, pages, empty};
}

/** Both orientations of the paper. */
function formatsOf({widthCm, heightCm}: CutSheet, paper: Paper): readonly Format[] {
  if (paper.isProjector) {
    const side = (length: number): number => Math.min(longest, length + 2 * projectorPad);
    const [width, height] = [side(widthCm), side(heightCm)];
    return [{width, height, margin: 0, pad: projectorPad, grows: 1}];
  }
  const {keepsBlank = false} = paper;
  const margins = {margin: usualMargin, pad, keepsBlank};
  if (paper.heightCm !== undefined) {
    const [width, height] = [paper.widthCm, paper.heightCm];
    return [
      {width, height, ...margins},
      {width: height, height: width, ...margins},
    ];
  }
  const long = (length: number): number => Math.min(longest, length + 2 * (usualMargin + pad));
  return [
    {width: paper.widthCm, height: long(heightCm), ...margins, grows: 1},
    {width: long(widthCm), height: paper.widthCm, ...margins, grows: 0},
  ];
}

const area = ({width, height}: Format): number => width * height;

/** The tilings with the fewest pages, and with the least paper among equals. */
function best(sheet: CutSheet, formats: readonly Format[]): readonly [Tiling, ...Tiling[]] {
  const all = formats.flatMap((format) =>
    shares.flatMap((x) => shares.map((y) => tiling(sheet, format, [x, y]))),
  );
  const cost = ({format, pages}: Tiling): number => pages.length * 1e6 + area(format);
  const least = Math.min(...all.map(cost));
  return all.filter((one) => cost(one) <= least + 1e-6) as [Tiling, ...Tiling[]];
}

/** A place on a page that no piece meets, searched from below. */
function freePlace(
  {pieces}: CutSheet,
  {frame}: SheetPage,
  [width, height]: Point,
): Box | undefined {
  const outlines = pieces
    .map(({cut}) => ({cut, around: boxOf(cut[0] ?? [])}))
    .filter(({around}) => overlap(around, frame));
  const {low, high} = grown(frame, -step / 2);
  const apart = Math.max(step, Math.min(high[0] - low[0], high[1] - low[1]) / mostTries);
  for (let y = low[1]; y + height <= high[1]; y += apart) {
    for (let x = low[0]; x + width <= high[0]; x += apart) {
      const place = boxAt([x, y], width, height);
      const near = grown(place, step / 2);
      if (outlines.every(({cut, around}) => !overlap(around, near) || !reachesInto(cut, near))) {
        return place;
      }
    }
  }
  return undefined;
}

/** The first tiling with enough room on its first page. */
function withRoom(
  sheet: CutSheet,
  tilings: readonly Tiling[],
  room: Point,
): {readonly tiling: Tiling; readonly block: Box} | undefined {
  for (const one of tilings) {
    const [first] = one.pages;
    const block = first && freePlace(sheet, first, room);
    if (block) return {tiling: one, block};
  }
  return undefined;
}

/** An additional first page above the sheet, which shows nothing of it. */
function cover({format, pages}: Tiling, {heightCm}: CutSheet): SheetPage {
  const {width, height, margin} = format;
  const left = Math.min(...pages.map(({low}) => low[0]));
  const low: Point = [
    left,
    Math.max(heightCm, ...pages.map(({window}) => window.high[1])) + margin,
  ];
  const window = boxAt([low[0] + margin, low[1] + margin], width - 2 * margin, height - 2 * margin);
  return {row: -1, column: 0, low, window, frame: window};
}

/**
 * Divides a sheet among pages.
 * @param roomFor returns width and height of the text and squares on the first page, with or
 *   without a map
 */
export function dividedAmong(
  sheet: CutSheet,
  paper: Paper,
  roomFor: (hasMap: boolean) => Point,
): PageLayout {
  const formats = formatsOf(sheet, paper).map((format) =>
    paper.isProjector
      ? {...format, width: Math.max(format.width, roomFor(false)[0] + 2 * step)}
      : format,
  );
  const tilings = best(sheet, formats);
  const room = roomFor(tilings[0].pages.length > 1);
  const longer = ({grows, ...format}: Format): readonly Format[] => {
    if (grows === undefined) return [];
    const side = grows === 0 ? 'width' : 'height';
    return [{...format, [side]: Math.min(longest, format[side] + room[grows] + 2 * step)}];
  };
  const found =
    withRoom(sheet, tilings, room) ?? withRoom(sheet, best(sheet, formats.flatMap(longer)), room);
  const {format, columns, rows, pages, empty} = found?.tiling ?? tilings[0];
  const before = found ? [] : [cover(tilings[0], sheet)];
  return {
    ...{paper, columns, rows, empty, pages: [...before, ...pages]},
    block: found?.block ?? before[0]?.frame ?? boxAt([0, 0], 0, 0),
    ...{widthCm: format.width, heightCm: format.height},
  };
}
