/** Places at which a print breaks a symmetry, on every cell of its photo. */
import {combined, coordinates, distance, type Point} from '../model/geometry/vectors.js';
import {pixelOf} from '../model/print/photo-map.js';
import type {PhotoMap} from '../model/print/photo-reading.js';
import type {DesignPrint} from '../model/design/design.js';
import {latticeType} from '../model/print/wallpaper.js';
import type {TileBreak} from '../image/tile-check.js';
import {boxOf, isInside, type PhotoSize} from './lattice-lines.js';

/** Broken places of one cell, in lattice coordinates. */
export interface BrokenPlaces {
  readonly rings: readonly (readonly Point[])[];
  /** Translations that repeat the places. */
  readonly steps: readonly [Point, Point];
}

/**
 * Greatest number of drawn areas, since more would block the page. Only cells around the middle of
 * the image have theirs then.
 */
const mostAreas = 5000;

/** Joins neighbours in a row. */
function rowsOf(breaks: readonly TileBreak[]): readonly Omit<TileBreak, 'difference'>[] {
  const rows: {x: number; y: number; width: number; height: number}[] = [];
  for (const {x, y, width, height} of [...breaks].sort((a, b) => a.y - b.y || a.x - b.x)) {
    const last = rows.at(-1);
    if (last?.y === y && Math.abs(last.x + last.width - x) < 1e-9) last.width += width;
    else rows.push({x, y, width, height});
  }
  return rows;
}

/**
 * Returns the broken places in lattice coordinates. The image of the cell shows w1 and w2, or the
 * rectangle of a centred lattice.
 */
export function brokenPlaces(
  breaks: readonly TileBreak[],
  {group, cell}: Pick<DesignPrint, 'group' | 'cell'>,
): BrokenPlaces {
  const [right, up]: readonly [Point, Point] =
    cell === 'primitive'
      ? [
          [1, 0],
          [0, 1],
        ]
      : latticeType(group) === 'hexagonal'
        ? [
            [1, 0],
            [-1, 2],
          ]
        : [
            [1, 1],
            [-1, 1],
          ];
  const at = (x: number, y: number): Point => combined([right, up], x, 1 - y);
  return {
    rings: rowsOf(breaks).map(({x, y, width, height}) => [
      at(x, y),
      at(x + width, y),
      at(x + width, y + height),
      at(x, y + height),
    ]),
    steps: [right, up],
  };
}

/** Returns closed outlines of the visible places. [px] */
export function brokenPath(map: PhotoMap, size: PhotoSize, {rings, steps}: BrokenPlaces): string {
  return cellsSeen(map, size, steps)
    .slice(0, Math.ceil(mostAreas / Math.max(1, rings.length)))
    .flatMap(([du, dv]) =>
      rings.map((ring) => ring.map(([u, v]) => pixelOf(map, size, [u + du, v + dv]))),
    )
    .filter((ring) => ring.some((point) => isInside(point, size)))
    .map(ringPath)
    .join('');
}

/** Returns the corners of the visible cells of `steps`, those in the middle of the image first. */
function cellsSeen(map: PhotoMap, size: PhotoSize, steps: BrokenPlaces['steps']): readonly Point[] {
  const {least, most} = boxOf(map, size);
  const corners: readonly Point[] = [least, most, [least[0], most[1]], [most[0], least[1]]];
  const ends = corners.map((corner) => coordinates(steps, corner));
  const range = (k: 0 | 1): readonly number[] => {
    const values = ends.map((end) => end[k]);
    const first = Math.floor(Math.min(...values)) - 1;
    return Array.from({length: Math.ceil(Math.max(...values)) - first + 1}, (_, i) => first + i);
  };
  const up = range(1);
  const middle: Point = [size.width / 2, size.height / 2];
  return range(0)
    .flatMap((i) => up.map((j) => combined(steps, i, j)))
    .map((corner) => {
      const at = (s: number, t: number): Point => {
        const [u, v] = combined(steps, s, t);
        return pixelOf(map, size, [corner[0] + u, corner[1] + v]);
      };
      const centre = at(0.5, 0.5);
      const reach = Math.max(distance(centre, at(0, 0)), distance(centre, at(1, 0)));
      return {corner, centre, reach};
    })
    .filter(
      ({centre: [x, y], reach}) =>
        x > -reach && y > -reach && x < size.width + reach && y < size.height + reach,
    )
    .sort((a, b) => distance(a.centre, middle) - distance(b.centre, middle))
    .map(({corner}) => corner);
}

export const ringPath = (ring: readonly Point[]): string =>
  `M${ring.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L')}Z`;
