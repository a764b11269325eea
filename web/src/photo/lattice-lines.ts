/** The cells of a print over its photo, as paths in pixels of the photo. */
import {combined, type Point} from '../model/geometry/vectors.js';
import {latticeOf, pixelOf, rebased} from '../model/print/photo-map.js';
import type {PhotoMap} from '../model/print/photo-reading.js';

export interface PhotoSize {
  readonly width: number;
  readonly height: number;
}

/** A box in lattice coordinates. */
export interface LatticeBox {
  readonly least: Point;
  readonly most: Point;
}

/**
 * Greatest numbers of lines and nodes. More lines would be a grey veil, so only every second, third
 * ... line is drawn.
 */
const mostLines = 120;
const mostNodes = 600;
/** Segments of a line across the image, which lens and perspective bend. */
const pieces = 12;

/** Returns a box that contains everything visible in the image. */
export function boxOf(map: PhotoMap, size: PhotoSize): LatticeBox {
  const {width, height} = size;
  const shares = [0, 0.5, 1];
  const border = shares.flatMap((s) =>
    shares.map((t) => latticeOf(map, size, [s * width, t * height])),
  );
  const of = (k: 0 | 1, pick: (...values: number[]) => number): number =>
    pick(...border.map((point) => point[k]));
  return {
    least: [Math.floor(of(0, Math.min)), Math.floor(of(1, Math.min))],
    most: [Math.ceil(of(0, Math.max)), Math.ceil(of(1, Math.max))],
  };
}

const short = (value: number): string => value.toFixed(1);

const pathThrough = (points: readonly Point[]): string =>
  points.map(([x, y], k) => `${k === 0 ? 'M' : 'L'}${short(x)} ${short(y)}`).join('');

/** Returns the path between two points of the lattice. */
export function pathBetween(map: PhotoMap, size: PhotoSize, from: Point, to: Point): string {
  return pathThrough(
    Array.from({length: pieces + 1}, (_, k) => {
      const share = k / pieces;
      return pixelOf(map, size, [
        from[0] + share * (to[0] - from[0]),
        from[1] + share * (to[1] - from[1]),
      ]);
    }),
  );
}

const steps = (from: number, to: number): readonly number[] => {
  const every = Math.max(1, Math.ceil((to - from + 1) / mostLines));
  return Array.from({length: Math.floor((to - from) / every) + 1}, (_, k) => from + every * k);
};

/** Returns the borders of all visible cells. */
export function cellLines(map: PhotoMap, size: PhotoSize): string {
  const {least, most} = boxOf(map, size);
  return [
    ...steps(least[0], most[0]).map((u) => pathBetween(map, size, [u, least[1]], [u, most[1]])),
    ...steps(least[1], most[1]).map((v) => pathBetween(map, size, [least[0], v], [most[0], v])),
  ].join('');
}

/** Returns the corner of the cell in the middle of the image. */
export function middleNode(map: PhotoMap, size: PhotoSize): Point {
  const [u, v] = latticeOf(map, size, [size.width / 2, size.height / 2]);
  return [Math.floor(u), Math.floor(v)];
}

export const isInside = ([x, y]: Point, {width, height}: PhotoSize): boolean =>
  x >= 0 && y >= 0 && x <= width && y <= height;

/** Returns the visible corners of cells; none if there are too many cells to distinguish. */
export function nodesOf(map: PhotoMap, size: PhotoSize): readonly Point[] {
  const {least, most} = boxOf(map, size);
  const [across, up] = [most[0] - least[0] + 1, most[1] - least[1] + 1];
  if (across * up > mostNodes) return [];
  return Array.from({length: across * up}, (_, k): Point => [
    least[0] + (k % across),
    least[1] + Math.floor(k / across),
  ]).filter((node) => isInside(pixelOf(map, size, node), size));
}

/** Returns a square cell in the middle of the image. */
export function startLattice({width, height}: PhotoSize): PhotoMap {
  const side = Math.min(width, height) / 4;
  const [x, y] = [(width - side) / 2, (height + side) / 2];
  return {homography: [side, 0, x, 0, -side, y, 0, 0, 1], lens: 0};
}

/**
 * Returns the map after a move of one node. A move of `base` shifts all nodes; a move of another
 * node stretches the lattice from `base`. Nodes keep their numbers.
 */
export function movedNode(
  map: PhotoMap,
  size: PhotoSize,
  base: Point,
  node: Point,
  to: Point,
): PhotoMap {
  const [p, q] = latticeOf(map, size, to);
  const [i, j] = [node[0] - base[0], node[1] - base[1]];
  const [du, dv] = [p - node[0], q - node[1]];
  const squared = i * i + j * j;
  // the least change of both vectors that moves the node there
  const [a, b] = squared === 0 ? [0, 0] : [i / squared, j / squared];
  const [w1, w2]: [Point, Point] = [
    [1 + a * du, a * dv],
    [b * du, 1 + b * dv],
  ];
  const start = squared === 0 ? [base[0] + du, base[1] + dv] : base;
  const [x, y] = combined([w1, w2], -base[0], -base[1]);
  return rebased(map, [w1, w2], [start[0] + x, start[1] + y]);
}
