import type {groupNames} from './core-tables.js';
import type {Point} from './geometry.js';

/** The 17 wallpaper groups by their usual short names. */
export {groupNames} from './core-tables.js';

export type GroupName = (typeof groupNames)[number];

/**
 * The cell spanned by w1 (to the right) and w2 (up); the conventional rectangular cell of the group's lattice; or
 * two cells with sides w1 + w2 and w2 - w1, so that the middle is like a corner: half-drop, whatever the group.
 */
export const printCells = ['primitive', 'rectangular', 'centred'] as const;

export type PrintCell = (typeof printCells)[number];

/** The same print in other colours: an image of its cell as SVG, and one as PNG. */
export interface Colourway {
  readonly name: string;
  readonly image: string;
  readonly raster?: string;
}

/** A repeating print. `w1`, `w2` in cm, right-handed; +y of the print is the length of the cloth. */
export interface Print {
  readonly format?: 'seamwise-print/1';
  /** What people call it. */
  readonly title?: string;
  readonly family?: 'botanical' | 'geometric' | 'tailored';
  readonly group: GroupName;
  readonly w1: Point;
  readonly w2: Point;
  /** One cell of the print; its lower left corner is the group's origin. */
  readonly image?: string;
  /** What `image` shows; `primitive` when left out. */
  readonly cell?: PrintCell;
  /** The print has an upside: a piece on grain may not be turned by 180 degrees. */
  readonly oneWay?: boolean;
  /** Its lengths are in proportion only: nobody has measured them yet. It can be placed, but not cut. */
  readonly unscaled?: boolean;
  readonly fabric?: {readonly usableWidthCm?: number};
  /** The first is the one that `image` shows. */
  readonly colourways?: readonly Colourway[];
}

/** The colourway of that name, however it is capitalised. */
export const colourwayOf = ({colourways = []}: Print, name: string): Colourway | undefined =>
  colourways.find((one) => one.name.toLowerCase() === name.toLowerCase());
