/**
 * Stripes and plaids: bands of colour along the warp, across it, or both, and the resulting group.
 */
import type {Point} from '../../src/model/geometry/vectors.js';
import type {GroupName} from '../../src/model/print/repeating-print.js';
import {cellOf, upright} from './design.js';
import type {Palette} from './palette.js';
import {isInk, type Ink} from './shape.js';
import type {Cell} from './tile.js';

/** A band of one colour and its width. [cm] */
type Band = readonly [ink: Ink, width: number];

/** The bands of one repeat, from the group's origin. */
export type Sett = readonly Band[];

/** Parses bands in a weaver's notation, colour and width in turn: `leaf 2 ground 0.5`. */
export function sett(text: string): Sett {
  return [...text.matchAll(/(\w+) ([\d.]+)/g)].map(([, ink = '', width]): Band => {
    if (!isInk(ink)) throw new Error(`no ink is called ${ink}`);
    return [ink, Number(width)];
  });
}

const repeatOf = (sett: Sett): number => sett.reduce((sum, [, width]) => sum + width, 0);

/**
 * A symmetric sett: `half`, from the middle of its first band to the middle of its last, and back.
 */
export function even(half: string): Sett {
  const bands = sett(half).map(([ink, width], k, {length}): Band => [
    ink,
    k === 0 || k === length - 1 ? width / 2 : width,
  ]);
  return [...bands, ...bands.toReversed()];
}

const sameBands = (a: Sett, b: Sett): boolean =>
  a.length === b.length && a.every(([ink, width], k) => ink === b[k]?.[0] && width === b[k][1]);

const isEven = (sett: Sett): boolean => sameBands(sett, sett.toReversed());

/**
 * The group of a plaid whose colours blend evenly where warp and weft cross. The weave is not
 * drawn: the diagonals of a twill would remove all mirrors. Setts count as symmetric only about the
 * origin.
 */
export function plaidCell(warp: Sett, weft: Sett): Cell {
  const w1: Point = [repeatOf(warp), 0];
  const w2: Point = [0, repeatOf(weft)];
  const backwards: Point = [-w1[0], 0];
  const of = (group: GroupName, a: Point, b: Point): Cell => ({
    ...cellOf(group, [a, b]),
    cell: 'primitive',
  });
  if (isEven(warp) && isEven(weft)) return of(sameBands(warp, weft) ? 'p4m' : 'pmm', w1, w2);
  if (isEven(warp)) return of('pm', w2, backwards); // mirrors along the warp
  if (isEven(weft)) return of('pm', w1, w2);
  return sameBands(warp, weft) ? of('cm', w1, w2) : of('p1', w1, w2);
}

/** Length of a drawn stripe, along which every length is a repeat. [cm] */
const stripeLength = 0.5;

/** Bands along the warp: pmm if they are symmetric, else pm with its mirrors across the bands. */
export function stripeCell(warp: Sett): Cell {
  const group = isEven(warp) ? 'pmm' : 'pm';
  return cellOf(group, upright(repeatOf(warp), stripeLength));
}

const short = (value: number): string => String(Number(value.toFixed(4)));

/**
 * One repeat of bands: each is drawn to the end, and the next one over it, so that neighbours meet
 * without a gap.
 */
function bands(sett: Sett, palette: Palette, pathFrom: (from: number) => string): string[] {
  let from = 0;
  return sett.map(([ink, width]) => {
    const drawn = `<path fill="${palette[ink]}" d="${pathFrom(from)}"/>`;
    from += width;
    return drawn;
  });
}

const warpBands = (sett: Sett, height: number, palette: Palette): string[] =>
  bands(sett, palette, (x) => `M${short(x)} 0V${short(height)}H${short(repeatOf(sett))}V0z`);

export const drawStripe =
  (warp: Sett) =>
  (palette: Palette): string[] =>
    warpBands(warp, stripeLength, palette);

/** Draws the warp, and over it the weft with half opacity, which gives the even blend. */
export function drawPlaid(warp: Sett, weft: Sett): (palette: Palette) => string[] {
  const [width, height] = [repeatOf(warp), repeatOf(weft)];
  return (palette) => [
    ...warpBands(warp, height, palette),
    '<g opacity=".5">',
    ...bands(
      weft,
      palette,
      (y) => `M0 ${short(height - y)}V0H${short(width)}V${short(height - y)}z`,
    ),
    '</g>',
  ];
}
