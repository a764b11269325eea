/** Checks whether a tile has the symmetries of a group, and finds the places that break them. */
import type {PlaneMap} from '../model/geometry/plane-map.js';
import {norm, type Point} from '../model/geometry/vectors.js';
import type {GroupName, PrintCell} from '../model/print/repeating-print.js';
import {fittingGroup, latticeVectors, type RepeatSize} from '../model/print/repeat.js';
import {imageCell, isCentred, latticeType, printElements} from '../model/print/wallpaper.js';
import {tiledFabric, seenThrough, type TiledFabric, type Pixels} from './tile-fabric.js';

/**
 * A place of the tile that differs from its images under the symmetries; in shares of the cell,
 * from its upper left corner.
 */
export interface TileBreak {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  /** Root mean square difference from its images. [0, 255] */
  readonly difference: number;
}

interface ElementCheck {
  readonly map: PlaneMap;
  /** Root mean square difference of the whole tile, and of the worst place. [0, 255] */
  readonly rms: number;
  readonly worst: number;
}

export interface TileCheck {
  /** The greatest difference of a place; up to `visibleDifference` it is noise. [0, 255] */
  readonly worst: number;
  /** The comparison with the tile's image under every symmetry except the identity. */
  readonly elements: readonly ElementCheck[];
  /** The worst first. */
  readonly breaks: readonly TileBreak[];
}

/** Pixels of the checked tile along its longer side; finer details are noise. */
const detail = 160;
/** Number of places along each side. */
const places = 24;
/** Greatest difference at a place of a compressed or coarsely drawn image. [0, 255] */
export const visibleDifference = 16;

/** The cells of a group that a rectangular image may show, the most symmetric first. */
function cellsOf(group: GroupName): readonly PrintCell[] {
  if (isCentred(group)) return ['rectangular'];
  return latticeType(group) === 'oblique' ? ['centred', 'primitive'] : ['primitive'];
}

const movedBy = (shift: Point): PlaneMap => ({xx: 1, xy: 0, yx: 0, yy: 1, shift});

/**
 * Size of the checked tile: at most the image's, and even, so that half the cell is a whole number
 * of pixels.
 */
function sizeFor(image: Pixels, cell: TiledFabric['cell']): readonly [number, number] {
  const [a, b] = imageCell(cell).map(norm);
  const scale = detail / Math.max(a ?? 1, b ?? 1);
  const pixels = (side: number | undefined, most: number): number =>
    2 * Math.max(1, Math.floor(Math.min(most, scale * (side ?? 1)) / 2));
  return [pixels(a, image.width), pixels(b, image.height)];
}

/** Number of columns and rows of places in a tile, at most its pixels. */
const placesIn = ({width, height}: TiledFabric): readonly [columns: number, rows: number] => [
  Math.min(places, width),
  Math.min(places, height),
];

/** For each place, the root mean square of a value given per colour and pixel. */
function byPlace(fabric: TiledFabric, value: (index: number) => number): readonly number[] {
  const {width, height} = fabric;
  const [columns, rows] = placesIn(fabric);
  const sums = new Float64Array(columns * rows);
  const counts = new Float64Array(columns * rows);
  for (let y = 0; y < height; y++) {
    const row = Math.floor((y * rows) / height) * columns;
    for (let x = 0; x < width; x++) {
      const place = row + Math.floor((x * columns) / width);
      const from = 3 * (y * width + x);
      for (let k = from; k < from + 3; k++) sums[place] = (sums[place] ?? 0) + value(k) ** 2;
      counts[place] = (counts[place] ?? 0) + 3;
    }
  }
  return Array.from(sums, (sum, k) => Math.sqrt(sum / Math.max(1, counts[k] ?? 1)));
}

function rootMeanSquare({colours: one}: TiledFabric, {colours: other}: TiledFabric): number {
  let sum = 0;
  for (let k = 0; k < one.length; k++) sum += ((one[k] ?? 0) - (other[k] ?? 0)) ** 2;
  return Math.sqrt(sum / one.length);
}

/**
 * Compares the tile with its image under every symmetry of the group, relative to the group's own
 * origin. A place's difference is its distance from the mean of all its images, so that a single
 * wrong one among many stands out.
 */
export function checkTile(
  pixels: Pixels,
  group: GroupName,
  size: RepeatSize,
  cell: PrintCell,
): TileCheck {
  const [w1, w2] = latticeVectors(group, size, 0, cell);
  const repeat = {group, w1, w2, cell};
  const fabric = tiledFabric(repeat, pixels, sizeFor(pixels, repeat), 2);
  const sum = Float32Array.from(fabric.colours);
  const add = ({colours}: TiledFabric): void => {
    for (let k = 0; k < sum.length; k++) sum[k] = (sum[k] ?? 0) + (colours[k] ?? 0);
  };
  const holdsTwo = cell === 'centred' || (cell === 'rectangular' && isCentred(group));
  const centring = holdsTwo ? [movedBy(w2)] : [];
  const own = printElements(fabric.cell).slice(1);
  const elements = [...own, ...centring].map((map, k) => {
    const seen = seenThrough(fabric, map);
    if (k < own.length) add(seen);
    const apart = byPlace(fabric, (at) => (fabric.colours[at] ?? 0) - (seen.colours[at] ?? 0));
    return {map, rms: rootMeanSquare(fabric, seen), worst: Math.max(...apart)};
  });
  if (elements.length === 0) return {worst: 0, elements, breaks: []};
  // a symmetry of the tile also applies to its sum, so the centre of the cell equals its corner
  for (const map of centring) add(seenThrough({...fabric, colours: Float32Array.from(sum)}, map));
  // a place that differs from all the others by d is d (1 - 1/n) from the mean of all n
  const order = (own.length + 1) * (centring.length + 1);
  const off = byPlace(
    fabric,
    (k) => (order * (fabric.colours[k] ?? 0) - (sum[k] ?? 0)) / (order - 1),
  );
  const [columns, rows] = placesIn(fabric);
  const breaks = off
    .map((difference, k) => ({
      x: (k % columns) / columns,
      y: Math.floor(k / columns) / rows,
      ...{width: 1 / columns, height: 1 / rows, difference},
    }))
    .filter(({difference}) => difference > visibleDifference)
    .sort((a, b) => b.difference - a.difference);
  return {worst: Math.max(...off), elements, breaks};
}

/** An image as the cell of a group. */
export interface WholeCell {
  readonly group: GroupName;
  /** 90 if the image has the group's axes after a quarter turn clockwise. [degrees] */
  readonly turnDeg: 0 | 90;
  /** Size of the image, after the turn if there is one. */
  readonly size: RepeatSize;
  readonly cell: PrintCell;
}

function turnedClockwise({width, height, data}: Pixels): Pixels {
  const turned = new Uint8ClampedArray(data.length);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const from = 4 * (y * width + x);
      turned.set(data.subarray(from, from + 4), 4 * (x * height + height - 1 - y));
    }
  }
  return {width: height, height: width, data: turned};
}

/**
 * An image as the cell of a group with its origin in the lower left corner; a group with swapped
 * axes fits after a turn. Undefined if the group has another origin, or no cell of that area.
 * @param copies number of smallest cells in the image; undefined if any will do
 */
export function wholeCell(
  pixels: Pixels,
  group: GroupName,
  {width, height}: RepeatSize,
  copies: number | undefined,
): WholeCell | undefined {
  const upright = {width, height, angleDeg: 90};
  for (const cell of cellsOf(group)) {
    if (copies !== undefined && copies !== (cell === 'primitive' ? 1 : 2)) continue;
    for (const turnDeg of [0, 90] as const) {
      const size = turnDeg === 0 ? upright : {width: height, height: width, angleDeg: 90};
      if (fittingGroup(group, size)) continue;
      const image = turnDeg === 0 ? pixels : turnedClockwise(pixels);
      const {worst} = checkTile(image, group, size, cell);
      if (worst <= visibleDifference) return {group, turnDeg, size, cell};
    }
  }
  return undefined;
}
