/** Grain of a piece: how it may lie on its fabric. */

/**
 * `free`: any angle; `on`: grain line along the fabric; `across`: at a right angle to it; `bias`:
 * at 45 degrees.
 */
export type GrainLock = 'free' | 'on' | 'across' | 'bias';

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

/** Direction of the grain line in a rule; undefined without one. [degrees] */
export const angleOf = (rule: GrainRule | undefined): number | undefined =>
  typeof rule === 'object' ? rule.angleDeg : undefined;
