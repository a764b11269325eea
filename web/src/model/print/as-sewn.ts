/**
 * Fabric as delivered: a repeat that measures otherwise than stated, and shrinkage. Garments are
 * solved on the print as it is after the wash. x runs along the weft, y along the warp. Lengths in
 * cm.
 */
import {SolverError} from '../base/failure.js';
import {shown} from '../base/read.js';
import {minus, type Point} from '../geometry/vectors.js';
import {rectangularRepeat, type Rectangle} from './rectangular-repeat.js';
import {fittingGroup, latticeVectors, repeatOf} from './repeat.js';
import {settled} from './print-scale.js';
import type {Delivered, GroupName, Print, PrintCell} from './repeating-print.js';
import {latticeType, type CellOf} from './wallpaper.js';

/** Least and greatest shrinkage; fabric that grows has a negative one. [per cent] */
export const shrinkageLimits = [-10, 30] as const;
/** A measured repeat differs from the stated one by less than this factor. */
const mostStretch = 1.25;
/** Shares that differ by less are equal. */
const same = 1e-9;

type Sewable = CellOf & Pick<Print, 'fabric' | 'delivered' | 'unscaled' | 'title'>;

/** A value of a description, 0 without one; NaN for what is no number. */
const amount = (value: unknown): number =>
  typeof (value ?? 0) === 'number' ? Number(value ?? 0) : NaN;

/** Returns whether two descriptions of fabric have the same values. */
export function isSameFabric(one: Delivered = {}, other: Delivered = {}): boolean {
  const values = ({shrinkage, measured}: Delivered): readonly number[] =>
    [shrinkage?.warp, shrinkage?.weft, measured?.across, measured?.up].map(amount);
  const others = values(other);
  return values(one).every((value, k) => Math.abs(value - (others[k] ?? 0)) < same);
}

/** The values that a print file states about its fabric; undefined without any. */
export function deliveredIn({fabric}: Pick<Print, 'fabric'>): Delivered | undefined {
  const {shrinkage, measured} = fabric ?? {};
  const delivered = {...(shrinkage && {shrinkage}), ...(measured && {measured})};
  return isSameFabric(delivered) ? undefined : delivered;
}

const wrong = (message: string): SolverError => new SolverError({code: 'options', message});

const short = (value: number): string => String(Number(value.toFixed(3)));

/**
 * Checks what a print states about its fabric.
 * @throws {SolverError} `options` with one sentence
 */
export function checkDelivered(print: Sewable): void {
  const {shrinkage, measured} = deliveredIn(print) ?? {};
  const [least, most] = shrinkageLimits;
  for (const way of ['warp', 'weft'] as const) {
    const share: unknown = shrinkage?.[way] ?? 0;
    if (typeof share === 'number' && share >= least && share <= most) continue;
    throw wrong(
      `The shrinkage along the ${way} is ${shown(share)} %, but must be a number from ${least} to ${most}; measure the fabric before and after a wash.`,
    );
  }
  if (!measured) return;
  if (print.unscaled) {
    throw wrong(
      'A print of unknown size has no stated repeat to compare a measured one with; give w1 and w2 in cm, as measured.',
    );
  }
  const stated = rectangularRepeat(print);
  if (!stated) {
    throw wrong(
      'The print does not repeat straight across and up its fabric, so a measured repeat cannot be compared; leave it out, and give w1 and w2 as measured.',
    );
  }
  const pairs = [
    ['across', measured.across, stated.width],
    ['up', measured.up, stated.height],
  ] as const;
  for (const [way, value, own] of pairs) {
    const stretch = value === undefined ? 1 : amount(value) / own;
    if (stretch > 1 / mostStretch && stretch < mostStretch) continue;
    throw wrong(
      `The repeat measures ${short(amount(value))} cm ${way}, but ${short(own)} cm are stated, which contradict each other; measure one repeat straight ${way} the fabric, or correct the print's size.`,
    );
  }
}

/** The factors of the print across and up, and those of the wash alone. */
function factorsOf(
  print: CellOf,
  {shrinkage, measured}: Delivered,
): {readonly all: Point; readonly wash: Point} {
  const stated: Rectangle | undefined = measured && rectangularRepeat(print);
  const [across, up] = [
    measured?.across !== undefined && stated ? measured.across / stated.width : 1,
    measured?.up !== undefined && stated ? measured.up / stated.height : 1,
  ];
  const wash: Point = [1 - (shrinkage?.weft ?? 0) / 100, 1 - (shrinkage?.warp ?? 0) / 100];
  return {all: [across * wash[0], up * wash[1]], wash};
}

const isEven = ([x, y]: Point): boolean => Math.abs(x / y - 1) < same;

/** The largest group, basis and cell of a print that is stretched unevenly. */
function stretchedCell(
  {group, w1, w2, cell = 'primitive'}: CellOf,
  of: (v: Point) => Point,
): CellOf {
  const type = latticeType(group);
  const [a, b] = [of(w1), of(w2)];
  const {size, turnDeg} = repeatOf({group, w1, w2, cell});
  const isUpright = Math.abs(turnDeg / 90 - Math.round(turnDeg / 90)) < 1e-6;
  const keeps = type === 'oblique' || (isUpright && ['rectangular', 'rhombic'].includes(type));
  if (keeps) return {group, w1: a, w2: b, cell};
  // sides of the new cell show the same image as before
  const isRectangle = cell === 'rectangular' && type === 'hexagonal';
  const basis = isRectangle ? ([minus(a, b), b] as const) : ([a, b] as const);
  const shown: PrintCell =
    cell === 'rectangular' && ['hexagonal', 'rhombic'].includes(type) ? 'centred' : cell;
  const plain = fittingGroup(group, {...size, angleDeg: 60})?.group ?? 'p1';
  const loose = {group: plain, w1: basis[0], w2: basis[1], cell: shown};
  if (!isUpright) return loose;
  const fitting = fittingGroup(group, {...size, width: 2 * size.width});
  if (fitting?.turnDeg !== 0) return loose;
  const isLarger: readonly GroupName[] = ['cm', 'cmm'];
  if (type === 'square') return {group: fitting.group, w1: a, w2: b, cell};
  return isLarger.includes(fitting.group) && isRectangle
    ? {group: fitting.group, w1: basis[0], w2: basis[1], cell: 'rectangular'}
    : loose;
}

/**
 * The print after the wash, with the measured repeat. Uneven factors leave a smaller group, such as
 * pmm of p4m. A print whose fabric is applied already is returned unchanged.
 */
export function asSewn<P extends Sewable>(print: P): P {
  const delivered = print.delivered ? undefined : deliveredIn(print);
  if (!delivered) return print;
  const {all, wash} = factorsOf(print, delivered);
  const of = ([x, y]: Point): Point => [x * all[0], y * all[1]];
  const {
    group,
    w1,
    w2,
    cell = 'primitive',
  } = isEven(all) && isEven(wash)
    ? {...print, w1: of(print.w1), w2: of(print.w2)}
    : stretchedCell(print, of);
  const {size, turnDeg} = repeatOf({group, w1, w2, cell});
  const [a, b] = latticeVectors(group, size, turnDeg, cell);
  return {
    ...print,
    ...{group, w1: settled(a), w2: settled(b), delivered},
    ...((print.cell !== undefined || cell !== 'primitive') && {cell}),
  };
}

/** The same print with other values of its fabric. */
export const withFabric = <P extends Sewable>(print: P, {shrinkage, measured}: Delivered): P => ({
  ...print,
  fabric: {...print.fabric, ...(shrinkage && {shrinkage}), ...(measured && {measured})},
});
