/** Grain of a piece: how it may lie on its fabric. */
import {angleOf as angleOfVector, degrees, minus, type Point} from '../geometry/vectors.js';

/**
 * `free`: any angle; `on`: grain line along the fabric; `across`: at a right angle to it; `bias`:
 * at 45 degrees.
 */
export type GrainLock = 'free' | 'on' | 'across' | 'bias';

/** One of several grain lines of a piece, such as those of layouts on grain and on the bias. */
export interface GrainChoice {
  readonly name?: string;
  /** In coordinates of the face-up piece. [cm] */
  readonly line: readonly [Point, Point];
  /** Members of the file that this program does not know, unchanged. */
  readonly more?: Readonly<Record<string, unknown>>;
}

/** A lock, or several settings of one piece. */
export type GrainRule =
  | GrainLock
  | {
      /** Default: the lock of all pieces. */
      readonly lock?: GrainLock;
      readonly toleranceDeg?: number;
      /**
       * Direction of the face-up piece's grain line, counter-clockwise from its x axis; it
       * overrides the one in the file.
       */
      readonly angleDeg?: number;
    };

/** Greatest difference of two directions that are the same. [degrees] */
const sameDirection = 0.05;

/**
 * Number of the grain line with a direction, among those that the maker draws; undefined without
 * one. @param angleDeg counter-clockwise from the x axis of the face-up piece
 */
export function grainAt(
  grains: readonly Pick<GrainChoice, 'line'>[],
  angleDeg: number,
): number | undefined {
  const found = grains.findIndex(({line}) => {
    const turn = (((directionDeg(line) - angleDeg) % 360) + 360) % 360;
    return Math.min(turn, 360 - turn) < sameDirection;
  });
  return found < 0 ? undefined : found;
}

/** Direction of a line, from 0 to 360. [degrees] */
export function directionDeg([from, to]: readonly [Point, Point]): number {
  return (degrees(angleOfVector(minus(to, from))) + 360) % 360;
}

/** Direction of the grain line in a rule; undefined without one. [degrees] */
export const angleOf = (rule: GrainRule | undefined): number | undefined =>
  typeof rule === 'object' ? rule.angleDeg : undefined;
