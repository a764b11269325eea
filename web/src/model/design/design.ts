/**
 * All decisions about a garment and its print: the state that undo restores and a project file
 * stores.
 */
import type {FabricName} from '../result/draped-garment.js';
import type {PanelDecisions} from '../garment/panel-marks.js';
import type {SolveOptions} from './options.js';
import type {PieceNames} from '../garment/piece-names.js';
import type {Delivered, GroupName, Print, PrintCell} from '../print/repeating-print.js';
import type {Method} from '../result/method.js';
import {latticeVectors, type PrintRepeat, type RepeatSize} from '../print/repeat.js';
import type {Symmetry} from '../garment/symmetries.js';
import type {PrintTile} from '../print/opened-image.js';

/** A file by its URL, and by the sha256 of its bytes in lower-case hexadecimal digits. */
export interface StoredFile {
  /** An http:, https: or file: URL, or a path relative to the design. */
  readonly url: string;
  readonly sha256: string;
}

export interface DesignGarment {
  /** Name of its file, used in messages. */
  readonly name: string;
  /** Text of the file, in any format that the solver reads. */
  readonly text: string;
  /** Style and size of the bundled garment, if it is one. */
  readonly sample?: {readonly style: string; readonly size: string};
  /** Source file, if it has an address; `size` is the shop's name for the size. */
  readonly file?: StoredFile & {readonly size?: string};
}

/** The print file from which a print was made. */
export interface DesignPrintFile {
  readonly text: string;
  /** Source file, if it has an address. */
  readonly place?: StoredFile;
  readonly colourway?: string;
}

export interface DeliveredPrint extends Delivered {
  readonly stated: PrintRepeat & {readonly group: GroupName; readonly cell: PrintCell};
}

export interface DesignPrint {
  readonly title: string;
  readonly group: GroupName;
  readonly size: RepeatSize;
  /** Counter-clockwise turn of the print on its fabric. [degrees] */
  readonly turnDeg: number;
  readonly oneWay: boolean;
  readonly cell: PrintCell;
  /** The size is in proportion only, until it is measured. */
  readonly unscaled?: boolean;
  /** Size and turn before the user chose others from a comparison. */
  readonly own?: PrintRepeat | undefined;
  /**
   * The fabric for which group, size and turn are those after the wash, and the print as stated,
   * before fabric was considered.
   */
  readonly delivered?: DeliveredPrint | undefined;
  /** The fabric is printed already, so that size and turn cannot be chosen. */
  readonly isPrinted?: boolean | undefined;
  /** Image of one cell: a URL, or a `data:` URL for the user's own image. */
  readonly image: string;
  /** Name and colourway of the bundled print, if it is one. */
  readonly sample?: {readonly name: string; readonly colourway: string};
  readonly file?: DesignPrintFile;
  /** The opened image from which `image` was made. */
  readonly tile?: PrintTile;
}

/** Image of a print that has none: bare fabric and the edges of its cell. */
export const noPicture = `data:image/svg+xml,${encodeURIComponent(
  '<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100" viewBox="0 0 100 100" preserveAspectRatio="none"><rect width="100" height="100" fill="#c9c1ae"/><rect x="1" y="1" width="98" height="98" fill="#f1ede3"/></svg>',
)}`;

/**
 * `auto`: the symmetries detected on the garment; `none`, instead of an empty list; or the listed
 * ones.
 */
export type AskedSymmetry = 'auto' | 'none' | readonly Symmetry[];

/** Decisions about garment and print together. */
export interface Decisions {
  readonly symmetry: AskedSymmetry;
  readonly method: Method;
  readonly options: SolveOptions;
  /** A whole number from 0 to 4294967295. */
  readonly seed: number;
  /** Chosen names of pieces. */
  readonly names?: PieceNames;
  /** Fabric of the drape; `usualFabric` when omitted. */
  readonly fabric?: FabricName;
}

/**
 * Another garment that is cut from the same fabric. It is solved by itself on the print of the
 * design, so it has its own position on the print.
 */
export interface AddedGarment<Garment = DesignGarment> extends Decisions {
  readonly garment: Garment;
  /** Number of garments. */
  readonly copies: number;
}

/** Greatest number of equal garments on a fabric, and of other garments beside the first. */
export const mostCopies = 20;
export const mostAdded = 20;

/**
 * A state that undo can return to, so it must never be changed in place. Garment and print are
 * contained in it, or referred to in another way.
 */
export interface Design<Garment = DesignGarment, Print = DesignPrint> extends Decisions {
  readonly garment: Garment;
  readonly print: Print;
  /** Number of garments cut from the fabric. Default 1. */
  readonly copies?: number;
  /** Other garments on the same fabric. */
  readonly added?: readonly AddedGarment<Garment>[];
}

/** The garments of a design that its fabric layout contains, each as a design of its own. */
export const garmentsOnFabric = ({
  added = [],
  copies = 1,
  ...design
}: Design): readonly (Design & {readonly copies: number})[] => [
  {...design, copies},
  ...added.map((one) => ({...one, print: design.print})),
];

/** Seed of a solve unless another one is chosen. */
export const usualSeed = 1;

/** Fabric of a garment unless another one is chosen. */
export const usualFabric: FabricName = 'poplin';

export const fabricOf = ({fabric = usualFabric}: Pick<Decisions, 'fabric'>): FabricName => fabric;

/** Only the decisions of a design. */
export const decisionsOf = ({
  symmetry,
  method,
  options,
  seed,
  names,
  fabric,
}: Decisions): Decisions => ({
  ...{symmetry, method, options, seed},
  ...(names && {names}),
  ...(fabric && {fabric}),
});

const noSymmetries: readonly Symmetry[] = [];

/** The symmetries listed by a design; the same list object for the same design. */
export const askedSymmetries = ({symmetry}: Pick<Decisions, 'symmetry'>): readonly Symmetry[] =>
  typeof symmetry === 'string' ? noSymmetries : symmetry;

/** Symmetries in the form that a design stores. */
export const askingFor = (symmetries: readonly Symmetry[]): AskedSymmetry =>
  symmetries.length === 0 ? 'none' : symmetries;

/** Decisions about the panels of a design's garment. */
export const decidedOf = ({
  names,
  options,
}: Pick<Decisions, 'names' | 'options'>): PanelDecisions => ({
  ...(names && {names}),
  ...(options.grain?.pieces && {grain: options.grain.pieces}),
});

/** The fabric without the stated print. */
export const fabricOnly = ({shrinkage, measured}: Delivered): Delivered => ({
  ...(shrinkage && {shrinkage}),
  ...(measured && {measured}),
});

/** The print in the form that solver and views take. */
export function printOf(print: DesignPrint): Print {
  const {group, size, turnDeg, oneWay, cell, title, image, unscaled, delivered} = print;
  const [w1, w2] = latticeVectors(group, size, turnDeg, cell);
  return {
    ...{title, group, w1, w2, oneWay, cell, image},
    ...(unscaled && {unscaled}),
    ...(delivered && {delivered: fabricOnly(delivered)}),
  };
}
