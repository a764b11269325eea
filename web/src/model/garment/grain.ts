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
  readonly line?: readonly [Point, Point];
  /** In place of a line: counter-clockwise from the x axis of the face-up piece. [degrees] */
  readonly angleDeg?: number;
  /** Members of the file that this program does not know, unchanged. */
  readonly more?: Readonly<Record<string, unknown>>;
}

/** A grain line that is drawn. */
export interface DrawnGrain extends GrainChoice {
  readonly line: readonly [Point, Point];
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
 * The grain line with a direction, among those that the maker draws; undefined without one.
 * @param angleDeg counter-clockwise from the x axis of the face-up piece
 */
export const grainAt = (
  grains: readonly GrainChoice[],
  angleDeg: number,
): GrainChoice | undefined =>
  grains.find((one) => {
    const turn = (((grainDeg(one) - angleDeg) % 360) + 360) % 360;
    return Math.min(turn, 360 - turn) < sameDirection;
  });

/** Direction of a grain line; upwards without one. [degrees] */
export const grainDeg = ({line, angleDeg = 90}: GrainChoice): number =>
  line ? degrees(angleOfVector(minus(line[1], line[0]))) : angleDeg;

/** The grain line in use; undefined if it is none of those that the maker draws. */
export function grainInUse(
  {grain, grains = []}: {readonly grain?: GrainChoice; readonly grains?: readonly GrainChoice[]},
  chosenDeg: number | undefined,
): GrainChoice | undefined {
  if (chosenDeg === undefined && !grain?.line) return grains[0];
  return grainAt(grains, chosenDeg ?? grainDeg(grain ?? {}));
}

/** Direction of the grain line in a rule; undefined without one. [degrees] */
export const angleOf = (rule: GrainRule | undefined): number | undefined =>
  typeof rule === 'object' ? rule.angleDeg : undefined;
