/** Where a print breaks a symmetry, on every cell of its photograph. */
import {combined, coordinates, type Point} from '../../model/geometry.js';
import {pixelOf} from '../../model/photo-map.js';
import type {PhotoMap} from '../../model/photo.js';
import type {DesignPrint} from '../../model/design.js';
import {latticeType} from '../../model/wallpaper.js';
import type {TileBreak} from '../../recognition/tile-check.js';
import {boxOf, isInside, type PhotoSize} from './lattice-lines.js';

/** In lattice coordinates. */
export interface BrokenPlaces {
  readonly rings: readonly (readonly Point[])[];
  /** They are there again after each of these. */
  readonly steps: readonly [Point, Point];
}

/** More areas than these are too small to be told apart. */
const mostAreas = 6000;

/** Neighbours in a row, as one. */
function rowsOf(breaks: readonly TileBreak[]): readonly Omit<TileBreak, 'difference'>[] {
  const rows: {x: number; y: number; width: number; height: number}[] = [];
  for (const {x, y, width, height} of [...breaks].sort((a, b) => a.y - b.y || a.x - b.x)) {
    const last = rows.at(-1);
    if (last?.y === y && Math.abs(last.x + last.width - x) < 1e-9) last.width += width;
    else rows.push({x, y, width, height});
  }
  return rows;
}

/** What breaks on the picture of a print's cell, which shows w1 and w2 or the rectangle of a centred lattice. */
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

/** Closed outlines of all that are seen. [px] */
export function brokenPath(map: PhotoMap, size: PhotoSize, {rings, steps}: BrokenPlaces): string {
  const {least, most} = boxOf(map, size);
  const corners: readonly Point[] = [least, most, [least[0], most[1]], [most[0], least[1]]];
  const ends = corners.map((corner) => coordinates(steps, corner));
  const range = (k: 0 | 1): readonly number[] => {
    const values = ends.map((end) => end[k]);
    const first = Math.floor(Math.min(...values)) - 1;
    return Array.from({length: Math.ceil(Math.max(...values)) - first + 1}, (_, i) => first + i);
  };
  const [across, up] = [range(0), range(1)];
  if (across.length * up.length * rings.length > mostAreas) return '';
  return across
    .flatMap((i) => up.map((j) => combined(steps, i, j)))
    .flatMap(([du, dv]) =>
      rings.map((ring) => ring.map(([u, v]) => pixelOf(map, size, [u + du, v + dv]))),
    )
    .filter((ring) => ring.some((point) => isInside(point, size)))
    .map(ringPath)
    .join('');
}

export const ringPath = (ring: readonly Point[]): string =>
  `M${ring.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L')}Z`;
