/** Tells pages with the pattern from pages of words. Lengths in mm. */
import {signedArea, lengthOf} from '../../../model/geometry/polyline.js';
import type {StatedGrid} from './arrange.js';
import {bySize, type Tile} from './furniture.js';
import {lettersOn} from './ink.js';
import {tileWindow} from './windows.js';

/** Distance from the side of a window at which a line leaves it. */
const atSide = 0.5;

/** Area of a closed line that may be a piece. [mm2] */
const pieceArea = 2500;

/** Letters of a page of words. */
const manyLetters = 250;

/** Least length of lines for each letter of a page with many letters and pieces. */
const perLetter = 4;

interface Measured {
  readonly tile: Tile;
  /** Number of line ends at the sides. */
  readonly leaves: number;
  readonly length: number;
  readonly closed: number;
  readonly letters: number;
}

function measured(tile: Tile, tiles: readonly Tile[]): Measured {
  const {low, high} = tileWindow(tiles, undefined);
  let [leaves, length, closed] = [0, 0, 0];
  for (const {points, isClosed, style} of tile.lines) {
    if (style.stroke === undefined) continue;
    length += lengthOf(points);
    if (isClosed && Math.abs(signedArea(points)) >= pieceArea) closed++;
    if (isClosed) continue;
    for (const [x, y] of [points[0] ?? low, points.at(-1) ?? low]) {
      const off = Math.min(x - low[0], y - low[1], high[0] - x, high[1] - y);
      if (off < atSide) leaves++;
    }
  }
  return {tile, leaves, length, closed, letters: lettersOn(tile.ink)};
}

/** A page that is so much larger than a tile shows the pattern in whole. */
const muchLarger = 4;

const areaOf = ({ink: {width, height}}: Tile): number => width * height;

/** The pages with the pattern: those that the user names, or else in the order of the file. */
export function chosenTiles(
  tiles: readonly Tile[],
  stated: StatedGrid,
): {readonly chosen: readonly Tile[]; readonly notes: readonly string[]} {
  if (stated.isExact === true) return {chosen: tiles, notes: []};
  const byNumber = [...tiles].sort((a, b) => a.ink.number - b.ink.number);
  if (stated.grid && stated.grid[0] * stated.grid[1] >= tiles.length) {
    return {chosen: byNumber, notes: []};
  }
  const groups = bySize(byNumber.map(({ink}) => ink)).map((inks) => {
    const own = byNumber.filter(({ink}) => inks.includes(ink));
    return own.map((tile) => measured(tile, own));
  });
  const patterns = groups
    .map((group) => patternIn(group))
    .filter((group) => group.length > 0)
    .map((group) => ({group, length: group.reduce((sum, {length}) => sum + length, 0)}));
  const [longest] = [...patterns].sort((a, b) => b.length - a.length);
  if (!longest) return {chosen: [], notes: []};
  const [first] = longest.group;
  const whole = patterns.find(
    ({group, length}) =>
      first !== undefined &&
      group.every(({tile}) => areaOf(tile) >= muchLarger * areaOf(first.tile)) &&
      length >= 0.5 * longest.length,
  );
  const taken = (whole ?? longest).group;
  const isTiled = taken.some(({leaves}) => leaves > 0) && taken.length > 1;
  const rest = patterns.filter(({group}) => group !== taken).flatMap(({group}) => group);
  const repeats = whole && whole !== longest ? longest.group : [];
  const also = isTiled || whole !== undefined ? [] : rest.filter(({closed}) => closed > 0);
  const numbers = (list: readonly Measured[]): string =>
    list.map(({tile}) => tile.ink.number).join(', ');
  return {
    chosen: [...taken, ...also].map(({tile}) => tile).sort((a, b) => a.ink.number - b.ink.number),
    notes:
      repeats.length > 0
        ? [
            `The pattern is read from its large page ${numbers(taken)}, and not from the tiles on pages ${numbers(repeats)}.`,
          ]
        : [],
  };
}

/** The pages of one size that show the pattern. */
function patternIn(group: readonly Measured[]): Measured[] {
  const isDrawn = ({leaves, closed, length, letters}: Measured): boolean =>
    leaves > 1 || (closed > 0 && (letters < manyLetters || length > perLetter * letters));
  const drawn = group.map(isDrawn);
  const leaving = group.map(({leaves}) => leaves > 1);
  const [from, to] = [leaving.indexOf(true), leaving.lastIndexOf(true)];
  const isTiled = leaving.filter(Boolean).length > 1;
  const hasFurniture = group.some(({tile}, k) => leaving[k] === true && tile.isFurnished);
  if (!isTiled) return group.filter((_, k) => drawn[k]);
  // pages without lines keep their place among tiles
  return group.filter(({tile, letters}, k) => {
    const isAmong = k >= from && k <= to && (leaving[k] === true || letters < manyLetters);
    return isAmong || (hasFurniture && tile.isFurnished);
  });
}
