/** Everything a person decides about a garment and its print: what undo steps through and what a project file holds. */
import type {FabricName} from './drape.js';
import type {PanelDecisions} from './garment-marks.js';
import type {SolveOptions} from './options.js';
import type {PieceNames} from './piece-names.js';
import type {GroupName, Print, PrintCell} from './print.js';
import type {Method} from './method.js';
import {latticeVectors, type RepeatSize} from './repeat.js';
import type {StoredFile} from './stored-file.js';
import type {Symmetry} from './symmetries.js';
import type {PrintTile} from './print-tile.js';

export interface DesignGarment {
  /** What messages call it: the name of its file. */
  readonly name: string;
  /** The file itself, in any format that the solver reads. */
  readonly text: string;
  /** Which of the garments that come with the page, if it is one. */
  readonly sample?: {readonly style: string; readonly size: string};
  /** Where it was read from, if it has a place; `size` is what a shop calls it. */
  readonly file?: StoredFile & {readonly size?: string};
}

/** The print file that a print was made of. */
export interface DesignPrintFile {
  readonly text: string;
  /** Where it was read from, if it has a place. */
  readonly place?: StoredFile;
  readonly colourway?: string;
}

export interface DesignPrint {
  readonly title: string;
  readonly group: GroupName;
  readonly size: RepeatSize;
  /** Counter-clockwise turn of the print on its cloth. [degrees] */
  readonly turnDeg: number;
  readonly oneWay: boolean;
  readonly cell: PrintCell;
  /** Its size is in proportion only, until somebody measures it. */
  readonly unscaled?: boolean;
  /** Where the picture of one cell is: a URL, or a `data:` URL when it is the user's own. */
  readonly image: string;
  /** Which of the prints that come with the page, if it is one. */
  readonly sample?: {readonly name: string; readonly colourway: string};
  readonly file?: DesignPrintFile;
  /** The picture that somebody opened, where `image` was made of it. */
  readonly tile?: PrintTile;
}

/** A print without a picture shows bare cloth, and the edges of its cell. */
export const noPicture = `data:image/svg+xml,${encodeURIComponent(
  '<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100" viewBox="0 0 100 100" preserveAspectRatio="none"><rect width="100" height="100" fill="#c9c1ae"/><rect x="1" y="1" width="98" height="98" fill="#f1ede3"/></svg>',
)}`;

/** `auto`: those that the garment shows by itself; `none`, never an empty list; or those that are listed. */
export type AskedSymmetry = 'auto' | 'none' | readonly Symmetry[];

/** What is decided about garment and print together. */
export interface Decisions {
  readonly symmetry: AskedSymmetry;
  readonly method: Method;
  readonly options: SolveOptions;
  /** A whole number from 0 to 4294967295. */
  readonly seed: number;
  /** What pieces are called, where that was chosen. */
  readonly names?: PieceNames;
  /** What it is made of when it is worn; as usual, where nothing is said. */
  readonly fabric?: FabricName;
}

/**
 * Never changed in place: whoever holds one holds a state that undo can come back to. Garment and print are held
 * themselves, or are referred to in another way.
 */
export interface Design<Garment = DesignGarment, Print = DesignPrint> extends Decisions {
  readonly garment: Garment;
  readonly print: Print;
}

/** What a solve has when nobody asks for another. */
export const usualSeed = 1;

/** What a garment is made of where nobody says otherwise. */
export const usualFabric: FabricName = 'poplin';

export const fabricOf = ({fabric = usualFabric}: Pick<Decisions, 'fabric'>): FabricName => fabric;

/** A design's decisions alone. */
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

/** The symmetries that are asked for one by one; the same list for the same design. */
export const askedSymmetries = ({symmetry}: Pick<Decisions, 'symmetry'>): readonly Symmetry[] =>
  typeof symmetry === 'string' ? noSymmetries : symmetry;

/** A list of symmetries as a design holds it. */
export const askingFor = (symmetries: readonly Symmetry[]): AskedSymmetry =>
  symmetries.length === 0 ? 'none' : symmetries;

/** What is decided about the panels of its garment. */
export const decidedOf = ({
  names,
  options,
}: Pick<Decisions, 'names' | 'options'>): PanelDecisions => ({
  ...(names && {names}),
  ...(options.grain?.pieces && {grain: options.grain.pieces}),
});

/** The print as solver and views take it. */
export function printOf(print: DesignPrint): Print {
  const {group, size, turnDeg, oneWay, cell, title, image, unscaled} = print;
  const [w1, w2] = latticeVectors(group, size, turnDeg, cell);
  return {title, group, w1, w2, oneWay, cell, image, ...(unscaled && {unscaled})};
}
