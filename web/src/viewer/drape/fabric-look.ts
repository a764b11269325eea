/** Looks of the fabrics of a drape. */
import type {FabricName} from '../../model/result/draped-garment.js';

/** Patterns of threads. */
export const weaves = {plain: 0, twill: 1, knit: 2} as const;

export interface FabricLook {
  readonly weave: keyof typeof weaves;
  /** Distance of threads, twill lines or wales, coarser than real ones so that they show. [cm] */
  readonly pitch: number;
  /** Height of the weave. [cm] */
  readonly relief: number;
  /** Light that fibres scatter where the fabric turns away, 0 to 1. */
  readonly sheen: number;
  /** Share of what is behind that does not show, 0 to 1. */
  readonly opacity: number;
  /** Thickness of a hem, which is of two layers or three. [cm] */
  readonly hem: number;
  /** Darkness of the stitches along hems, 0 to 1. */
  readonly stitch: number;
}

export const fabricLooks: Readonly<Record<FabricName, FabricLook>> = {
  poplin: {
    ...{weave: 'plain', pitch: 0.08, relief: 0.006, sheen: 0.04},
    ...{opacity: 1, hem: 0.08, stitch: 0.3},
  },
  jersey: {
    ...{weave: 'knit', pitch: 0.13, relief: 0.018, sheen: 0.12},
    ...{opacity: 1, hem: 0.12, stitch: 0.35},
  },
  denim: {
    ...{weave: 'twill', pitch: 0.12, relief: 0.02, sheen: 0.02},
    ...{opacity: 1, hem: 0.15, stitch: 0.6},
  },
  chiffon: {
    ...{weave: 'plain', pitch: 0.06, relief: 0.004, sheen: 0.1},
    ...{opacity: 0.68, hem: 0.06, stitch: 0.15},
  },
};
