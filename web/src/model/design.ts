/** Everything a person decides about a garment and its print: what undo steps through and what a project file holds. */
import type {PanelDecisions} from './garment-marks.js';
import type {SolveOptions} from './options.js';
import type {PieceNames} from './piece-names.js';
import type {GroupName, Print, PrintCell} from './print.js';
import type {Problem} from './problem.js';
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

/** Never changed in place: whoever holds one holds a state that undo can come back to. */
export interface Design {
  readonly garment: DesignGarment;
  readonly print: DesignPrint;
  /** Those that the user has asked for; found ones that were not accepted are not among them. */
  readonly symmetries: readonly Symmetry[];
  readonly method: Method;
  readonly options: SolveOptions;
  /** What pieces are called, where that was chosen. */
  readonly names?: PieceNames;
}

/** What is decided about the panels of its garment. */
export const decidedOf = ({names, options}: Pick<Design, 'names' | 'options'>): PanelDecisions => ({
  ...(names && {names}),
  ...(options.grain?.pieces && {grain: options.grain.pieces}),
});

/** The print as solver and views take it. */
export function printOf({group, size, turnDeg, oneWay, cell, title, image}: DesignPrint): Print {
  const [w1, w2] = latticeVectors(group, size, turnDeg, cell);
  return {title, group, w1, w2, oneWay, cell, image};
}

export const problemOf = (design: Design): Problem => ({
  garment: design.garment.text,
  print: printOf(design.print),
  symmetry: {symmetries: design.symmetries},
  method: design.method,
  options: design.options,
});
