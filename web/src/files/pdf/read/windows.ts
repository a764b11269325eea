/** The part of each tile in which the pattern is drawn. Lengths in mm. */
import type {Box} from '../../../model/geometry/polyline.js';
import type {Tile} from './furniture.js';

/** Two windows are the same if their sides differ by less. */
const same = 0.3;

/** Least share of a page that its window covers. */
const leastShare = 0.35;

/** The window of tiles of one size: that of most of them, or the extent of lines that end at it. */
export function tileWindow(tiles: readonly Tile[], trim: number | undefined): Box {
  const {width = 0, height = 0} = tiles[0]?.ink ?? {};
  const page: Box = {low: [0, 0], high: [width, height]};
  if (trim !== undefined) return {low: [trim, trim], high: [width - trim, height - trim]};
  const clips = tiles.map(({ink}) => ink.window).filter((box) => isLarge(box, page));
  const clip = mostOf(clips.filter((box) => !isSame(box, page))) ?? page;
  return {
    low: [endsAt(tiles, 0, 'low', clip.low[0]), endsAt(tiles, 1, 'low', clip.low[1])],
    high: [endsAt(tiles, 0, 'high', clip.high[0]), endsAt(tiles, 1, 'high', clip.high[1])],
  };
}

const sidesOf = ({low, high}: Box): readonly number[] => [...low, ...high];

const isSame = (a: Box, b: Box): boolean =>
  sidesOf(a).every((side, k) => Math.abs(side - (sidesOf(b)[k] ?? 0)) < same);

const isLarge = ({low, high}: Box, page: Box): boolean =>
  (high[0] - low[0]) * (high[1] - low[1]) >= leastShare * page.high[0] * page.high[1];

/** The box that is found most often. */
function mostOf(boxes: readonly Box[]): Box | undefined {
  const votes = (box: Box): number => boxes.filter((other) => isSame(box, other)).length;
  return boxes.reduce<{box: Box; votes: number} | undefined>((best, box) => {
    const count = votes(box);
    return best && best.votes >= count ? best : {box, votes: count};
  }, undefined)?.box;
}

/** Ends within this of each other are at one place. */
const bin = 0.2;
/** Least number of line ends at the side of a window, and least share of all ends near it. */
const least = {count: 4, share: 0.3};
/** Greatest distance of a window from the side of its page. */
const widestMargin = 45;

/**
 * The place within a margin of the page at which most lines end, as they do if a program cut them;
 * otherwise the given one.
 */
function endsAt(tiles: readonly Tile[], axis: 0 | 1, side: 'low' | 'high', given: number): number {
  const counts = new Map<number, number>();
  let all = 0;
  for (const {ink, lines} of tiles) {
    const far = axis === 0 ? ink.width : ink.height;
    for (const {points, isClosed} of lines) {
      if (isClosed) continue;
      for (const point of [points[0], points.at(-1)]) {
        const place = point?.[axis] ?? 0;
        const margin = side === 'low' ? place : far - place;
        if (margin > widestMargin) continue;
        all++;
        const key = Math.round(place / bin);
        counts.set(key, (counts.get(key) ?? 0) + 1);
      }
    }
  }
  const around = (key: number): number =>
    (counts.get(key - 1) ?? 0) + (counts.get(key) ?? 0) + (counts.get(key + 1) ?? 0);
  const enough = Math.max(least.count, least.share * all);
  const found = [...counts.keys()].filter((key) => around(key) >= enough);
  if (found.length === 0) return given;
  const best = found.reduce((one, other) => (around(other) > around(one) ? other : one));
  const exact = meanAt(tiles, axis, best * bin);
  if (shareBeyond(tiles, axis, side, exact) > mostBeyond) return given;
  return Math.abs(exact - given) < same ? given : exact;
}

/** Greatest share of lines that reach beyond the side of a window, where programs cut all lines. */
const mostBeyond = 0.02;

function shareBeyond(
  tiles: readonly Tile[],
  axis: 0 | 1,
  side: 'low' | 'high',
  place: number,
): number {
  const lines = tiles.flatMap((tile) => tile.lines);
  const reaches = lines.filter(({points}) =>
    points.some((p) => (side === 'low' ? p[axis] < place - same : p[axis] > place + same)),
  );
  return reaches.length / (lines.length || 1);
}

/** The mean place of the ends near a place. */
function meanAt(tiles: readonly Tile[], axis: 0 | 1, near: number): number {
  let [sum, count] = [0, 0];
  for (const {lines} of tiles) {
    for (const {points, isClosed} of lines) {
      if (isClosed) continue;
      for (const point of [points[0], points.at(-1)]) {
        const place = point?.[axis] ?? Infinity;
        if (Math.abs(place - near) > 1.5 * bin) continue;
        sum += place;
        count++;
      }
    }
  }
  return count > 0 ? sum / count : near;
}
