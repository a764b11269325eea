/** The user's decisions about the print on a photo, and the resulting print. */
import {assumedWidth, readableRepeat} from '../image/photo-print.js';
import type {DesignPrint} from '../model/design/design.js';
import {combined, minus, norm, type Point} from '../model/geometry/vectors.js';
import {latticeOf, pixelOf, vectorsAtMiddle} from '../model/print/photo-map.js';
import {
  oneRepeat,
  shareApart,
  type ColourGains,
  type PhotoGroup,
  type PhotoMap,
  type PhotoObject,
  type PhotoReading,
  type PhotoTileSettings,
  type PointsMeasured,
  type RepeatsMeasured,
} from '../model/print/photo-reading.js';
import type {GroupName} from '../model/print/repeating-print.js';
import {isCentred, latticeType} from '../model/print/wallpaper.js';
import {alongStripe, turnsOver, wrappedTurn} from '../model/print/repeat.js';

/** Returns whether two images are the same byte for byte; false if one cannot be read. */
export async function areSame(one: Blob, other: Blob): Promise<boolean> {
  if (one.size !== other.size) return false;
  try {
    const [a, b] = await Promise.all([one.arrayBuffer(), other.arrayBuffer()]);
    const [first, second] = [new Uint8Array(a), new Uint8Array(b)];
    for (let k = 0; k < first.length; k++) if (first[k] !== second[k]) return false;
    return true;
  } catch {
    return false;
  }
}

/** A step of the history. */
export interface PhotoStep {
  readonly reading: PhotoReading;
  /** Focal length of the camera, converted to film of 36 mm, if the file contains it. */
  readonly f35: number | undefined;
  /** True if the user placed or chose the cell of this reading. */
  readonly isByHand: boolean;
  /** The chosen group, if it differs from the group found. */
  readonly chosen: GroupName | undefined;
  /** Quarter turns of the print against the photo as read, counter-clockwise. */
  readonly quarterTurns: number;
  /** The user's setting for a print with one upright direction; undefined without a setting. */
  readonly oneWay: boolean | undefined;
  /** True if the symmetries of the group are made exact. */
  readonly isExact: boolean;
  /** Share of the uneven light that is removed, 0 to 1. */
  readonly flatten: number;
  readonly w1Measured: RepeatsMeasured | undefined;
  readonly w2Measured: RepeatsMeasured | undefined;
  readonly between: PointsMeasured | undefined;
  /** Coin or card on the fabric. */
  readonly object: PhotoObject | undefined;
  /** Gains that make a chosen spot white. */
  readonly gains: ColourGains | undefined;
}

/** Measurements of lengths. Only one kind counts at a time; w1 and w2 are one kind. */
export const unmeasured = {
  ...{w1Measured: undefined, w2Measured: undefined},
  ...{between: undefined, object: undefined},
} as const;

/** Returns the step of a reading, with the earlier decisions. */
export function stepOf(
  reading: PhotoReading,
  before?: PhotoStep,
  {f35, isByHand = false}: {readonly f35?: number | undefined; readonly isByHand?: boolean} = {},
): PhotoStep {
  const {chosen} = before ?? {};
  const isPossible = reading.groups.some(
    ({name, verdict}) => name === chosen && verdict !== 'cannot',
  );
  return {
    ...{quarterTurns: 0, oneWay: undefined, isExact: false, flatten: 1},
    ...unmeasured,
    gains: undefined,
    ...before,
    ...{reading, f35, isByHand, chosen: isPossible ? chosen : undefined},
  };
}

/** Returns the same step for the same photo in another size. */
export function scaledStep(
  step: PhotoStep,
  {width, height}: {readonly width: number; readonly height: number},
): PhotoStep {
  const {reading, between, object} = step;
  const [across, down] = [width / reading.width, height / reading.height];
  const at = ([x, y]: Point): Point => [across * x, down * y];
  const points = (measured: PointsMeasured): PointsMeasured => ({
    ...measured,
    ...{from: at(measured.from), to: at(measured.to)},
  });
  const seen = ({homography: [a, b, c, d, e, f, ...rest], lens}: PhotoMap): PhotoMap => ({
    homography: [across * a, across * b, across * c, down * d, down * e, down * f, ...rest],
    lens,
  });
  const map = seen(reading.map);
  return {
    ...step,
    reading: {
      ...reading,
      ...{width, height, map, ...vectorsAtMiddle(map, {width, height})},
      groups: reading.groups.map((group) => ({...group, map: seen(group.map)})),
      others: reading.others.map(seen),
      differing: reading.differing.map((ring) => ring.map(at)),
    },
    between: between && points(between),
    object: object && {
      ...object,
      ...{outline: object.outline.map(at), between: points(object.between)},
    },
  };
}

export const groupOf = ({chosen, reading}: PhotoStep): GroupName => chosen ?? reading.group;

export function groupIn(step: PhotoStep): PhotoGroup {
  const group = step.reading.groups.find(({name}) => name === groupOf(step));
  if (!group) throw new Error('A reading judges all groups.');
  return group;
}

/** Returns whether the reading is uncertain and the user has not corrected it. */
export const isDoubtful = ({reading, isByHand, chosen}: PhotoStep): boolean =>
  reading.confidence === 'uncertain' && !isByHand && chosen === undefined;

export const isOneWay = (step: PhotoStep): boolean => step.oneWay ?? !turnsOver(groupOf(step));

/** Returns the vectors of a map in the print, in the reading's proportions. */
function shapeOf({reading}: PhotoStep, map: PhotoMap): readonly [Point, Point] {
  const middle = latticeOf(map, reading, [reading.width / 2, reading.height / 2]);
  const [u, v] = [Math.round(middle[0]), Math.round(middle[1])];
  const at = (i: number, j: number): Point =>
    latticeOf(reading.map, reading, pixelOf(map, reading, [u + i, v + j]));
  const base = at(0, 0);
  const vector = (i: number, j: number): Point => {
    const [s, t] = minus(at(i, j), base);
    return combined(reading.shape, s, t);
  };
  return [vector(1, 0), vector(0, 1)];
}

const times = ([x, y]: Point, factor: number): Point => [factor * x, factor * y];

interface PhotoCell {
  readonly w1: Point;
  readonly w2: Point;
  /** True if lengths are cm; otherwise |w1| is about 1. */
  readonly isScaled: boolean;
}

/**
 * Returns the measured lengths of w1 and w2; they are equal if the group requires equal sides. [cm]
 */
function lengthsOf(step: PhotoStep): readonly [number | undefined, number | undefined] {
  const [w1, w2] = [oneRepeat(step.w1Measured), oneRepeat(step.w2Measured)];
  if (w1 === undefined || w2 === undefined || !isEqualSided(step)) return [w1, w2];
  const both = conflictIn(step) ? w1 : Math.sqrt(w1 * w2);
  return [both, both];
}

/** Returns w1 and w2 of the displayed group. */
export function cellOf(step: PhotoStep): PhotoCell {
  const [w1, w2] = shapeOf(step, groupIn(step).map);
  const [first, second] = lengthsOf(step);
  const [across, up] = [
    first === undefined ? undefined : first / norm(w1),
    second === undefined ? undefined : second / norm(w2),
  ];
  const other = across ?? up ?? byPoints(step);
  return {
    w1: times(w1, across ?? other ?? 1),
    w2: times(w2, up ?? other ?? 1),
    isScaled: other !== undefined,
  };
}

/** Returns the unit of the reading's shape in cm. */
function byPoints({reading, object, ...step}: PhotoStep): number | undefined {
  const between = step.between ?? object?.between;
  if (!between) return undefined;
  const [s, t] = minus(
    latticeOf(reading.map, reading, between.to),
    latticeOf(reading.map, reading, between.from),
  );
  const apart = norm(combined(reading.shape, s, t));
  return apart > 0 ? between.cm / apart : undefined;
}

/**
 * Greatest difference between two measurements of sides that the group makes equal, as a share: the
 * error of a tape.
 */
const tapeError = 0.005;

const isEqualSided = (step: PhotoStep): boolean =>
  ['square', 'rhombic', 'hexagonal'].includes(latticeType(groupOf(step)));

/** Measurements along w1 and w2 that no cell can have together. */
interface MeasureConflict {
  /** Length of one repeat. [cm] */
  readonly w1: number;
  readonly w2: number;
  /** w2 according to w1 and the photo, or to w1 and the group. [cm] */
  readonly expected: number;
  /** Deviation of w2 from it, as a share. */
  readonly share: number;
  /** True if the group has equal sides, so that w1 counts; otherwise both count. */
  readonly isOfGroup: boolean;
}

export function conflictIn(step: PhotoStep): MeasureConflict | undefined {
  const [w1, w2] = [oneRepeat(step.w1Measured), oneRepeat(step.w2Measured)];
  const {stripes, seen} = step.reading;
  if (w1 === undefined || w2 === undefined || stripes) return undefined;
  const isOfGroup = isEqualSided(step);
  const [a, b] = shapeOf(step, groupIn(step).map);
  const aspect = isOfGroup ? 1 : norm(b) / norm(a);
  const share = shareApart(w1, w2, aspect);
  const most = isOfGroup ? tapeError : seen.error;
  return share > most ? {w1, w2, expected: w1 * aspect, share, isOfGroup} : undefined;
}

/** Returns whether every place along a line of the print is alike; w1 runs across those lines. */
export const isStriped = (step: PhotoStep): boolean =>
  step.reading.stripes && ['pm', 'pmm'].includes(groupOf(step));

/** Returns the print without its image, rounded as in print files. */
export function measuresOf(
  step: PhotoStep,
): Pick<DesignPrint, 'group' | 'size' | 'turnDeg' | 'oneWay' | 'cell' | 'unscaled'> {
  const group = groupOf(step);
  const {w1, w2, isScaled} = cellOf(step);
  const factor = isScaled ? 1 : assumedWidth;
  const {size, turnDeg} = readableRepeat({group, w1: times(w1, factor), w2: times(w2, factor)});
  return {
    group,
    size: isStriped(step) ? {...size, height: Math.min(size.height, alongStripe)} : size,
    turnDeg: wrappedTurn(turnDeg + 90 * step.quarterTurns),
    oneWay: isOneWay(step),
    cell: isCentred(group) ? 'rectangular' : 'primitive',
    ...(!isScaled && {unscaled: true}),
  };
}

/** Returns the settings for the tile of the print. */
export function tileSettings(step: PhotoStep): PhotoTileSettings {
  const {name, map} = groupIn(step);
  return {
    ...{map, shape: shapeOf(step, map), flatten: step.flatten},
    ...(step.isExact && name !== 'p1' && {symmetrise: name}),
    ...(step.gains && {gains: step.gains}),
  };
}
