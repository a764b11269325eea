import type {groupNames} from '../base/core-tables.js';
import type {Point} from '../geometry/vectors.js';

/** The 17 wallpaper groups by their usual short names. */
export type GroupName = (typeof groupNames)[number];

/**
 * `primitive`: the cell spanned by w1 (to the right) and w2 (up); `rectangular`: the conventional
 * rectangular cell of the group's lattice; `centred`: two cells with sides w1 + w2 and w2 - w1,
 * whose middle looks like a corner: a half-drop, for any group.
 */
export const printCells = ['primitive', 'rectangular', 'centred'] as const;

export type PrintCell = (typeof printCells)[number];

/** The same print in other colours: an image of its cell as SVG, and one as PNG. */
export interface Colourway {
  readonly name: string;
  readonly image: string;
  readonly raster?: string;
}

/** Fabric as it is delivered, before its first wash. */
export interface Delivered {
  /** Shrinkage in the wash along warp and weft. [per cent] */
  readonly shrinkage?: {readonly warp: number; readonly weft: number};
  /** The repeat as measured straight across the fabric and up; as stated where absent. [cm] */
  readonly measured?: {readonly across?: number; readonly up?: number};
}

/**
 * A repeating print. `w1`, `w2` in cm, right-handed; +y of the print is the length of the fabric.
 */
export interface Print {
  readonly format?: 'seamwise-print/1';
  /** Name shown to the user. */
  readonly title?: string;
  readonly family?: 'botanical' | 'geometric' | 'tailored';
  readonly group: GroupName;
  readonly w1: Point;
  readonly w2: Point;
  /** One cell of the print; its lower left corner is the group's origin. */
  readonly image?: string;
  /** The cell in `image`. Default `primitive`. */
  readonly cell?: PrintCell;
  /** True if the print has an upside: then a piece on grain must not be turned by 180 degrees. */
  readonly oneWay?: boolean;
  /**
   * Lengths are in proportion only, because the print is not measured yet. It can be placed, but
   * not cut.
   */
  readonly unscaled?: boolean;
  /**
   * Scale of `w1` and `w2` relative to the file of the print, as in `print.scale` of a result.
   * Default 1.
   */
  readonly scale?: number;
  /**
   * Counter-clockwise turn of `w1` and `w2` relative to the file of the print, as in
   * `print.turnDeg` of a result. [degrees] Default 0.
   */
  readonly turnDeg?: number;
  readonly fabric?: Delivered & {readonly usableWidthCm?: number};
  /**
   * The fabric for which `w1` and `w2` are the repeat after the wash, as in `print.delivered` of a
   * result. Without it, they are the stated repeat, to which `fabric` is yet to be applied.
   */
  readonly delivered?: Delivered;
  /** The first one is the one in `image`. */
  readonly colourways?: readonly Colourway[];
}

/** The colourway of this name, regardless of case. */
export const colourwayOf = ({colourways = []}: Print, name: string): Colourway | undefined =>
  colourways.find((one) => one.name.toLowerCase() === name.toLowerCase());
