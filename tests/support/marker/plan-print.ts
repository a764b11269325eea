/**
 * Rotations that map a print onto itself, by a separate table, and their checks for pieces on
 * printed fabric. Lengths in cm.
 */
import {apply} from '@/model/geometry/plane-map.js';
import {
  coordinates,
  combined,
  minus,
  plus,
  rotated,
  turnBetween,
  type Point,
} from '@/model/geometry/vectors.js';
import type {GroupName} from '@/model/print/repeating-print.js';
import {printElements, type Repeat} from '@/model/print/wallpaper.js';
import {at, greatest} from '../plane.js';

/**
 * Number of a group's rotations about the origin; in none of the 17 groups do rotations include
 * part of a repeat.
 */
export const turnsOf: Readonly<Record<GroupName, 1 | 2 | 3 | 4 | 6>> = {
  ...{p1: 1, pm: 1, pg: 1, cm: 1},
  ...{p2: 2, pmm: 2, pmg: 2, pgg: 2, cmm: 2},
  ...{p3: 3, p3m1: 3, p31m: 3},
  ...{p4: 4, p4m: 4, p4g: 4},
  ...{p6: 6, p6m: 6},
};

/** Permitted rotations of a piece with a grain. */
export type TurnRule = 'half' | 'quarter' | 'any';

const rightAngles: Readonly<Record<TurnRule, number>> = {
  half: Math.PI,
  quarter: Math.PI / 2,
  any: 0,
};

/** Deviation of an angle from the nearest permitted one, as a sine. */
export function offRule(rule: TurnRule, angle: number): number {
  const step = rightAngles[rule];
  return step === 0 ? 0 : Math.abs(Math.sin(angle - step * Math.round(angle / step)));
}

/** The rotations of a print that a rule permits. [rad] */
export const allowedTurns = (group: GroupName, rule: TurnRule): readonly number[] =>
  Array.from({length: turnsOf[group]}, (_, k) => (2 * Math.PI * k) / turnsOf[group]).filter(
    (angle) => offRule(rule, angle) < 1e-9,
  );

/** A vector less a whole number of repeats, so that only rounding errors remain. */
export function lessRepeats({w1, w2}: Pick<Repeat, 'w1' | 'w2'>, v: Point): Point {
  const [i, j] = coordinates([w1, w2], v);
  return minus(v, combined([w1, w2], Math.round(i), Math.round(j)));
}

/** The print's points under a piece, relative to those of its alignment. */
interface OnFabric {
  /**
   * Distance from a rotation of the group, after moving the first point to its place; mirrored ones
   * are far.
   */
  readonly off: number;
  /** The print's own shift beneath the piece, before its turn, less whole repeats. */
  readonly shift: Point;
}

/**
 * @param wanted  three or more points of the print by the alignment @param found  the points that
 * the fabric shows there
 */
export function onFabric(
  repeat: Repeat,
  wanted: readonly Point[],
  found: readonly Point[],
): OnFabric {
  const reach = (points: readonly Point[], k: number): Point => minus(at(points, k), at(points, 0));
  const angle = turnBetween(reach(wanted, 1), reach(found, 1));
  const step = (2 * Math.PI) / turnsOf[repeat.group];
  const turn = step * Math.round(angle / step);
  const apart = wanted.map((_, k) => minus(reach(found, k), rotated(reach(wanted, k), turn)));
  return {
    off: greatest(apart.map((v) => Math.hypot(...v))),
    shift: lessRepeats(repeat, rotated(minus(at(found, 0), rotated(at(wanted, 0), turn)), -turn)),
  };
}

/**
 * Distance of a shift of the whole print from the nearest one that keeps all symmetries in their
 * places.
 */
export const offNormaliser = (repeat: Repeat, shift: Point): number =>
  greatest(
    printElements(repeat).map((element) =>
      Math.hypot(...lessRepeats(repeat, minus(apply({...element, shift: [0, 0]}, shift), shift))),
    ),
  );

/** The shortest repeat straight along the fabric; undefined if there is none within `most`. */
export function warpPeriod({w1, w2}: Pick<Repeat, 'w1' | 'w2'>, most = 400): number | undefined {
  const reach = Math.ceil(most / Math.min(Math.hypot(...w1), Math.hypot(...w2)));
  const periods: number[] = [];
  for (let i = -reach; i <= reach; i++) {
    // the step along w2 that returns to the start across the fabric
    const steps = w2[0] === 0 ? [-1, 0, 1] : [Math.round((-i * w1[0]) / w2[0])];
    for (const j of steps) {
      const [x, y] = plus([i * w1[0], i * w1[1]], w2, j);
      if (Math.abs(x) < 1e-9 && y > 1e-9 && y <= most) periods.push(y);
    }
  }
  return periods.length > 0 ? Math.min(...periods) : undefined;
}
