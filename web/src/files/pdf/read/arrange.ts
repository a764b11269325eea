/**
 * Finds the grid of tiles: its shape, and the overlap of neighbours, by the lines that go on from
 * page to page. Lengths in mm.
 */
import type {Box} from '../../../model/geometry/polyline.js';
import {distance, type Point} from '../../../model/geometry/vectors.js';
import type {Tile} from './furniture.js';
import type {InkLine} from './ink.js';
import {
  crossingsFor,
  gainAt,
  meetingOf,
  mostOverlap,
  overlaps,
  profileOf,
  step,
  type Meeting,
  type Profile,
  type Side,
} from './joints.js';
import {namedGrids, orderedGrids, statedGrid, type Cell} from './page-names.js';
import {tileWindow} from './windows.js';

/** The user's statements about the grid. */
export interface StatedGrid {
  /** True if the user names the pages, in their order. */
  readonly isExact?: boolean;
  /** Numbers of pages that keep their place and show nothing. */
  readonly without?: readonly number[];
  /** Number of columns and rows. */
  readonly grid?: Point;
  /** Places of pages by their numbers. */
  readonly places?: ReadonlyMap<number, Cell>;
  /** Strip that is cut off at each side of a page. [mm] */
  readonly trim?: number;
  /** Overlap of neighbouring pages after trimming. [mm] */
  readonly overlap?: number;
}

/** A joint between two tiles, by their indices. */
interface Joint {
  readonly a: number;
  readonly b: number;
  readonly isUpright: boolean;
  readonly meets: number;
  readonly misses: number;
}

export interface Arrangement {
  readonly cells: readonly Cell[];
  /** The part of each page that is shown, in its own coordinates. */
  readonly window: Box;
  /** Overlap of neighbours across and down. */
  readonly overlap: Point;
  /** Shares of the overlaps that the right and lower pages lose. */
  readonly splits: Point;
  readonly joints: readonly Joint[];
  /** Number of lines that go on at joints, less those that do not. */
  readonly score: number;
  /** True if the pages have names of rows and columns. */
  readonly isNamed: boolean;
}

/** A grid by names of pages is taken if it fits nearly as well as the best one. */
const nameTrust = 0.6;

/** Number of lines that outweigh the borders of pages. */
const trust = 4;

type Direction = 'across' | 'down';

const sides: Readonly<Record<Direction, readonly [Side, Side]>> = {
  across: ['right', 'left'],
  down: ['bottom', 'top'],
};

/** The best arrangement of tiles of one size; its score is 0 if no line goes on. */
export function arranged(tiles: readonly Tile[], stated: StatedGrid): Arrangement {
  const window = tileWindow(tiles, stated.trim);
  const compared = new Compared(tiles, window);
  const names = namedGrids(tiles.map(({ink}) => ink));
  const own = statedCells(tiles, stated);
  const tried = own ? [own] : [...names, ...orderedGrids(tiles.length)];
  const prior = priorOverlap(tiles, window, stated);
  const rated = tried.map((cells) => ({cells, ...compared.rate(cells, prior, stated.overlap)}));
  const best = highest(rated);
  const named = own ? best : bestNamed(rated.slice(0, names.length));
  const isNamed = named !== undefined && named.score + usualNames >= nameTrust * (best?.score ?? 0);
  const chosen = isNamed ? named : best;
  const cells = chosen?.cells ?? [];
  const coarse = chosen?.overlap ?? prior;
  const isStated = stated.overlap !== undefined;
  const overlap: Point = isStated
    ? coarse
    : [
        compared.refined(cells, 'across', coarse[0], prior[0]),
        compared.refined(cells, 'down', coarse[1], prior[1]),
      ];
  const splits: Point = [
    splitOf(tiles, window, 0, overlap[0]),
    splitOf(tiles, window, 1, overlap[1]),
  ];
  const joints = compared.joints(cells, overlap, splits);
  return {cells, window, overlap, splits, joints, score: chosen?.score ?? 0, isNamed};
}

/** The cells of tiles as the user states them. */
function statedCells(
  tiles: readonly Tile[],
  {grid, places}: StatedGrid,
): readonly Cell[] | undefined {
  if (places) return tiles.map(({ink}) => places.get(ink.number) ?? {row: 0, column: 0});
  return grid && statedGrid(tiles.length, grid);
}

/** Shares of an overlap at which pages are cut, in the order of preference. */
const shares = [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8];

/** Greatest distance from a cut at which a line along it is uncertain, and its least length. */
const alongCut = {off: 0.3, length: 3};

/** The share of an overlap at which the fewest lines run along the cut. */
function splitOf(tiles: readonly Tile[], {low, high}: Box, axis: 0 | 1, overlap: number): number {
  const counts = shares.map(() => 0);
  const cuts: readonly Point[] = shares.map((share) =>
    axis === 0
      ? [low[0] + share * overlap, high[0] - (1 - share) * overlap]
      : [high[1] - share * overlap, low[1] + (1 - share) * overlap],
  );
  for (const {points, isClosed} of tiles.flatMap(({lines}) => lines)) {
    points.forEach((from, k) => {
      const to = points[k + 1] ?? (isClosed ? points[0] : undefined);
      if (!to || distance(from, to) < alongCut.length) return;
      if (Math.abs(to[axis] - from[axis]) > alongCut.off) return;
      cuts.forEach((places, n) => {
        const isNear = places.some((place) => Math.abs(from[axis] - place) < alongCut.off);
        if (isNear) counts[n] = (counts[n] ?? 0) + 1;
      });
    });
  }
  return shares[counts.indexOf(Math.min(...counts))] ?? 0.5;
}

/** Number of lines that outweigh the usual meaning of names: row, then column, from above. */
const usualNames = 2;

function bestNamed<T extends {readonly score: number}>(rated: readonly T[]): T | undefined {
  const best = highest(rated);
  const [usual] = rated;
  return best && usual && usual.score + usualNames >= best.score ? usual : best;
}

const highest = <T extends {readonly score: number}>(rated: readonly T[]): T | undefined =>
  rated.reduce<T | undefined>(
    (best, one) => (best && best.score >= one.score ? best : one),
    undefined,
  );

/** The overlap that borders imply: pages are usually cut along them. */
function priorOverlap(tiles: readonly Tile[], {low, high}: Box, {overlap}: StatedGrid): Point {
  if (overlap !== undefined) return [overlap, overlap];
  const borders = tiles.map(({border}) => border);
  const implied = (axis: 0 | 1): number => {
    const least = Math.min(...borders.map((box) => box.high[axis] - box.low[axis]));
    const left = high[axis] - low[axis] - least;
    return left > 0 && left <= mostOverlap ? left : 0;
  };
  return [implied(0), implied(1)];
}

interface Neighbours {
  readonly a: number;
  readonly b: number;
}

/** The neighbours in a grid. */
function neighboursIn(cells: readonly Cell[], direction: Direction): Neighbours[] {
  const places = new Map(cells.map(({row, column}, k) => [`${row} ${column}`, k]));
  return cells.flatMap(({row, column}, a) => {
    const next = direction === 'across' ? `${row} ${column + 1}` : `${row + 1} ${column}`;
    const b = places.get(next);
    return b === undefined ? [] : [{a, b}];
  });
}

/** Tiles with the comparisons made so far. */
class Compared {
  readonly #tiles: readonly Tile[];
  readonly #window: Box;
  readonly #profiles: readonly ReadonlyMap<Side, Profile>[];
  readonly #curves = new Map<string, Float32Array>();

  constructor(tiles: readonly Tile[], window: Box) {
    this.#tiles = tiles;
    this.#window = window;
    this.#profiles = tiles.map(
      ({lines}) =>
        new Map(
          (['left', 'right', 'top', 'bottom'] as const).map((side) => [
            side,
            profileOf(lines, window, side),
          ]),
        ),
    );
  }

  /** The gain of a pair for each overlap. */
  #curve({a, b}: Neighbours, direction: Direction): Float32Array {
    const key = `${direction} ${a} ${b}`;
    const known = this.#curves.get(key);
    if (known) return known;
    const [out, into] = sides[direction];
    const [from, to] = [this.#profiles[a]?.get(out) ?? [], this.#profiles[b]?.get(into) ?? []];
    const curve = Float32Array.from({length: overlaps}, (_, k) => gainAt(from, to, k));
    this.#curves.set(key, curve);
    return curve;
  }

  /** The best overlap of all pairs in one direction. */
  #best(
    cells: readonly Cell[],
    direction: Direction,
    prior: number,
    fixed: number | undefined,
  ): {readonly overlap: number; readonly gain: number} {
    const pairs = neighboursIn(cells, direction);
    const sum = new Float32Array(overlaps);
    for (const pair of pairs)
      this.#curve(pair, direction).forEach((gain, k) => (sum[k] = (sum[k] ?? 0) + gain));
    if (fixed !== undefined) return {overlap: fixed, gain: sum[Math.round(fixed / step)] ?? 0};
    const atPrior = Math.round(prior / step);
    const best = sum.indexOf(Math.max(...sum));
    // without clear evidence, pages are cut along their borders, also where no line crosses these
    const isEmpty = prior > 0 && sum.subarray(0, atPrior + 1).every((gain) => gain === 0);
    const isPrior =
      isEmpty || (sum[best] ?? 0) < 1.1 * (sum[atPrior] ?? 0) + (prior > 0 ? trust : 0.5);
    return isPrior
      ? {overlap: prior, gain: sum[atPrior] ?? 0}
      : {overlap: best * step, gain: sum[best] ?? 0};
  }

  rate(
    cells: readonly Cell[],
    prior: Point,
    fixed: number | undefined,
  ): {readonly score: number; readonly overlap: Point} {
    const across = this.#best(cells, 'across', prior[0], fixed);
    const down = this.#best(cells, 'down', prior[1], fixed);
    return {score: across.gain + down.gain, overlap: [across.overlap, down.overlap]};
  }

  /** The lines of a tile near a side, as segments. */
  #near(tile: number, side: Side, depth: number): InkLine[] {
    const {low, high} = this.#window;
    const axis = side === 'left' || side === 'right' ? 0 : 1;
    const isLow = side === 'left' || side === 'bottom';
    const place = isLow ? low[axis] + depth : high[axis] - depth;
    return (this.#tiles[tile]?.lines ?? []).flatMap(({points, isClosed, style}) => {
      const all = isClosed ? [...points, points[0] ?? [0, 0]] : points;
      return all.slice(1).flatMap((to, k): InkLine[] => {
        const from = all[k] ?? to;
        const isNear =
          Math.min(from[axis], to[axis]) <= place + 2 &&
          Math.max(from[axis], to[axis]) >= place - 2;
        return isNear ? [{points: [from, to], isClosed: false, style}] : [];
      });
    });
  }

  #meetings(
    cells: readonly Cell[],
    direction: Direction,
    around: number,
    split = 0.5,
  ): (Neighbours & {readonly at: (overlap: number) => Meeting})[] {
    const [out, into] = sides[direction];
    return neighboursIn(cells, direction).map(({a, b}) => {
      const from = this.#near(a, out, around * (1 - split));
      const to = this.#near(b, into, around * split);
      const at = (overlap: number): Meeting =>
        meetingOf(
          crossingsFor(from, this.#window, out, overlap * (1 - split)),
          crossingsFor(to, this.#window, into, overlap * split),
          0,
        );
      return {a, b, at};
    });
  }

  /** The overlap to a fiftieth of a millimetre; among equal ones that nearest to the prior one. */
  refined(cells: readonly Cell[], direction: Direction, coarse: number, prior: number): number {
    if (neighboursIn(cells, direction).length === 0) return 0;
    const pairs = this.#meetings(cells, direction, coarse);
    const tried = Array.from({length: 101}, (_, k) => coarse + (k - 50) * 0.02).filter(
      (o) => o >= 0,
    );
    const costs = tried.map((overlap) => {
      const meetings = pairs.map(({at}) => at(overlap));
      const gaps = meetings.flatMap((one) => one.gaps.map(Math.abs));
      const misses = meetings.reduce((sum, one) => sum + one.misses, 0);
      return gaps.reduce((sum, gap) => sum + gap, 0.6 * misses);
    });
    const least = Math.min(...costs);
    const equal = tried.filter((_, k) => (costs[k] ?? Infinity) <= least + 0.005);
    const middle = equal[Math.floor(equal.length / 2)] ?? coarse;
    return equal.find((o) => Math.abs(o - prior) < 0.011) !== undefined ? prior : middle;
  }

  /** The joints of a grid, compared where pages are cut. */
  joints(cells: readonly Cell[], overlap: Point, splits: Point): Joint[] {
    return (['across', 'down'] as const).flatMap((direction, axis) => {
      const value = overlap[axis] ?? 0;
      return this.#meetings(cells, direction, value, splits[axis]).map(({a, b, at}): Joint => {
        const {meets, misses} = at(value);
        return {a, b, isUpright: direction === 'across', meets, misses};
      });
    });
  }
}
