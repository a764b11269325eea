/** A repeat as a maker measures it, and its lattice. */
import {groupNames} from '../base/core-tables.js';
import {
  angleOf,
  degrees,
  minus,
  norm,
  plus,
  radians,
  rotated,
  turnBetween,
  type Point,
} from '../geometry/vectors.js';
import {type GroupName, type PrintCell} from './repeating-print.js';
import {latticeType, printElements, type CellOf} from './wallpaper.js';

/**
 * Sides of the cell that a maker measures: of the rectangular cell of a rhombic or hexagonal
 * lattice, so that half a repeat aside is half a repeat up; of the shown cell if that is `centred`.
 * [cm]
 */
export interface RepeatSize {
  readonly width: number;
  readonly height: number;
  /** Angle between the sides; 90 unless the lattice is oblique. [degrees] */
  readonly angleDeg: number;
}

/** Size and counter-clockwise turn of a repeat. [cm, degrees] */
export interface PrintRepeat {
  readonly size: RepeatSize;
  readonly turnDeg: number;
}

const root3 = Math.sqrt(3);

/** Vectors w1, w2 of a group's lattice, with the whole print turned counter-clockwise. [cm] */
export function latticeVectors(
  group: GroupName,
  {width, height, angleDeg}: RepeatSize,
  turnDeg = 0,
  cell: PrintCell = 'primitive',
): readonly [Point, Point] {
  const upright = ((): readonly [Point, Point] => {
    switch (latticeType(group)) {
      case 'rhombic':
        return [
          [width / 2, -height / 2],
          [width / 2, height / 2],
        ];
      case 'hexagonal':
        return [
          [width, 0],
          [width / 2, (width * root3) / 2],
        ];
      case 'square':
        return [
          [width, 0],
          [0, width],
        ];
      case 'rectangular':
        return [
          [width, 0],
          [0, height],
        ];
      case 'oblique': {
        const [x, y] = rotated([height, 0], radians(angleDeg));
        const upward: Point = [x, y];
        if (cell !== 'centred') return [[width, 0], upward];
        return [
          [(width - x) / 2, -y / 2],
          [(width + x) / 2, y / 2],
        ];
      }
    }
  })();
  if (turnDeg === 0) return upright;
  const angle = radians(turnDeg);
  return [rotated(upright[0], angle), rotated(upright[1], angle)];
}

/** The inverse of `latticeVectors`; the turn is in (-180, 180] degrees. */
export function repeatOf({group, w1, w2, cell}: CellOf): PrintRepeat {
  const type = latticeType(group);
  const [across, up] =
    type === 'rhombic' || (type === 'oblique' && cell === 'centred')
      ? ([plus(w1, w2), minus(w2, w1)] as const)
      : [w1, w2];
  const size = {
    width: norm(across),
    height: norm(up),
    angleDeg: degrees(turnBetween(across, up)),
  };
  const turnDeg = degrees(angleOf(across));
  return {size: coupledSize(group, size), turnDeg: turnDeg <= -180 ? 180 : turnDeg + 0};
}

/** Wraps an angle into (-180, 180]. [degrees] */
export const wrappedTurn = (degrees: number): number => {
  const turn = ((degrees % 360) + 360) % 360;
  return turn > 180 ? turn - 360 : turn;
};

/** Returns whether the height of a repeat follows from its width. */
export const isCoupled = (group: GroupName): boolean =>
  ['square', 'hexagonal'].includes(latticeType(group));

/** The size that the group requires: free values stay, the others follow from the width. */
export function coupledSize(group: GroupName, {width, height, angleDeg}: RepeatSize): RepeatSize {
  switch (latticeType(group)) {
    case 'square':
      return {width, height: width, angleDeg: 90};
    case 'hexagonal':
      return {width, height: width * root3, angleDeg: 90};
    case 'rectangular':
    case 'rhombic':
      return {width, height, angleDeg: 90};
    case 'oblique':
      return {width, height, angleDeg};
  }
}

/** A smaller group for the same fabric, with the same origin. */
export interface FittingGroup {
  readonly group: GroupName;
  readonly size: RepeatSize;
  /**
   * Angle from the axes of the larger group to those of the smaller one. Add it to the turn of the
   * print, and turn the image of its cell by as much the other way, so that the fabric looks as
   * before. [degrees]
   */
  readonly turnDeg: 0 | 90;
  /** Kind of cell in the image of the measured cell, for the smaller group. */
  readonly cell: PrintCell;
}

/** Remaining group where the cell is a rectangle of any proportions. */
const onRectangles: Readonly<Partial<Record<GroupName, GroupName>>> = {
  p4: 'p2',
  p4m: 'pmm', // it loses the mirrors along the diagonals
  p4g: 'pgg', // it loses them, too; the glides along the sides stay
  p3: 'p1',
  p3m1: 'cm', // its mirror at right angles to w1 stays
  p31m: 'cm', // its mirror along w1 stays
  p6: 'p2',
  p6m: 'cmm',
};

/**
 * Groups that keep half turns in cells that are not rectangles. No axis along a side stays there.
 */
const halfTurns: ReadonlySet<GroupName> = new Set<GroupName>([
  'pmm',
  'pmg',
  'pgg',
  'cmm',
  'p4',
  'p4m',
  'p4g',
  'p6',
  'p6m',
]);

/** Relative tolerance of measured lengths, and tolerance of angles. [1, rad] */
const tolerance = 0.005;

/**
 * The largest group that is left of `group` when its measured cell does not meet the group's
 * requirements. Each of its symmetries is one of the larger group, on the same origin. Undefined
 * when the size fits. Axes oblique to the sides of a slanted cell are not considered.
 */
export function fittingGroup(group: GroupName, measured: RepeatSize): FittingGroup | undefined {
  if (latticeType(group) === 'oblique') return undefined;
  const {width, height, angleDeg} = measured;
  if (Math.abs(Math.cos(radians(angleDeg))) > tolerance) {
    const smaller = halfTurns.has(group) ? 'p2' : 'p1';
    return {group: smaller, size: measured, turnDeg: 0, cell: 'primitive'};
  }
  const smaller = onRectangles[group];
  const fits = Math.abs(height / coupledSize(group, measured).height - 1) <= tolerance;
  if (fits || !smaller) return undefined;
  const cell = latticeType(smaller) === 'rhombic' ? 'rectangular' : 'primitive';
  // cm has its mirrors along the width of its cell, but p3m1 along the height
  if (group === 'p3m1') {
    const size = {width: height, height: width, angleDeg: 90};
    return {group: smaller, size, turnDeg: 90, cell};
  }
  return {group: smaller, size: {width, height, angleDeg: 90}, turnDeg: 0, cell};
}

/** A piece that is symmetric in itself, or two that are each other's mirror image. */
type SymmetryKind = 'piece' | 'pair';

const turnsOnly: ReadonlySet<GroupName> = new Set<GroupName>(['p1', 'p2', 'p4', 'p3', 'p6']);
const glidesOnly: ReadonlySet<GroupName> = new Set<GroupName>(['pg', 'pgg']);

/**
 * Returns whether a group carries a symmetry. A symmetric piece needs mirrors in the print; for a
 * mirrored pair, glides suffice.
 */
export const carries = (group: GroupName, kind: SymmetryKind): boolean =>
  !turnsOnly.has(group) && (kind === 'pair' || !glidesOnly.has(group));

export const groupsThatCarry = (kind: SymmetryKind): readonly GroupName[] =>
  groupNames.filter((group) => carries(group, kind));

/** Sides of a repeat that can be printed and sewn. [cm] */
export const leastRepeat = 0.2;
export const mostRepeat = 200;

/** Any repeat is valid along a stripe; this one represents all. [cm] */
export const alongStripe = 0.5;

/** Returns whether every print of this group looks the same upside down. */
export function turnsOver(group: GroupName): boolean {
  const [w1, w2] = latticeVectors(group, {width: 1, height: 1, angleDeg: 90});
  return printElements({group, w1, w2}).some(
    ({xx, yy}) => Math.abs(xx + 1) < 1e-9 && Math.abs(yy + 1) < 1e-9,
  );
}
