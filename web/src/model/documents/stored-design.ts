/** A design as shops store it: decisions, their files, and the result. */
import {
  decisionsOf,
  fabricOnly,
  type Design,
  type DesignPrint,
  type StoredFile,
} from '../design/design.js';
import {
  askedSymmetry,
  decisionFields,
  fabricFields,
  optionalFields,
  readAlignment,
  repeatFields,
  seed,
} from '../design/read-design.js';
import type {Alignment} from '../geometry/vectors.js';
import {colourwayOf, type Delivered, type Print} from '../print/repeating-print.js';
import {settled} from '../print/print-scale.js';
import {withRepeat} from '../print/print-variant.js';
import {readPrintFile} from '../print/read-print-file.js';
import {fail, recordOf, shape, text, type Read} from '../base/read.js';
import {latticeVectors, repeatOf} from '../print/repeat.js';
import {resultText, sha256Of} from './result-text.js';
import type {SolveResult} from '../result/result.js';
import {FileError, readVersioned, type FileKind} from '../base/versioned-file.js';
import {packageVersion} from '../base/version.js';

/** Changes of a print; omitted fields are those of the print's file. */
export type PrintChanges = Partial<
  Pick<DesignPrint, 'group' | 'size' | 'turnDeg' | 'oneWay' | 'cell'>
> & {
  /** One of the print file's colourways. */
  readonly colourway?: string;
  /** The fabric for which the other fields are those after the wash. */
  readonly delivered?: Delivered;
};

/** A garment file; `size` is the shop's name for the size. */
export type FiledGarment = StoredFile & {readonly size?: string};

export type FiledPrint = StoredFile & PrintChanges;

/** A design whose garment and print are given by URL and hash. */
export type FiledDesign = Design<FiledGarment, FiledPrint>;

/** `seamwise-design/1`: a filed design with its result. */
export interface StoredDesign extends FiledDesign {
  /** Place of each piece on the print, by name. */
  readonly alignments: Readonly<Record<string, Alignment>>;
  /** The sha256 of the result's text, as `resultText` writes it. */
  readonly result: string;
  /** Version of this package that computed the result. */
  readonly solver: string;
}

const version = 1;
/** Greatest length of a stored design; the largest garments need a few thousand. [characters] */
const greatestLength = 200_000;

const name = text(/^\P{Cc}{1,200}$/u, 'a name of at most 200 characters');
const hash = text(/^[\da-f]{64}$/, 'a sha256 in 64 lower-case hexadecimal digits');
const semver = text(/^\d{1,6}\.\d{1,6}\.\d{1,6}(-[\w.-]{1,80})?$/, 'a version such as 1.0.0');

/**
 * Reads a URL. It rejects schemes that run or contain something, paths that name another host, and
 * characters that a parser would drop.
 */
const url: Read<string> = (value, at) => {
  const address = text()(value, at);
  const isPlain = /^[^\p{Cc}\\]{1,2000}$/u.test(address) && address.trim() === address;
  const isKnown =
    /^(https?|file):\/\//i.test(address) || !/^([a-z][a-z\d+.-]*:|\/\/)/i.test(address);
  return isPlain && isKnown
    ? address
    : fail(at, 'an http:, https: or file: URL, or a path relative to the design');
};

const kind: FileKind<StoredDesign> = {
  format: 'seamwise-design',
  version,
  read: shape(
    {
      garment: shape({url, sha256: hash}, {size: name}),
      print: shape(
        {url, sha256: hash},
        {colourway: name, ...repeatFields, delivered: shape({}, fabricFields)},
      ),
      symmetry: askedSymmetry,
      ...decisionFields,
      seed,
      alignments: recordOf(readAlignment),
      result: hash,
      solver: semver,
    },
    optionalFields,
  ),
  notJson: 'is not JSON; give it a design that was stored by Seamwise.',
  otherKind: `is no design; its 'format' must be 'seamwise-design/${version}'.`,
  newer: (written) =>
    `was stored by a newer Seamwise (design format ${written}, this one reads ${version}); update this package.`,
  damaged: (what) => `is damaged: ${what}; correct it, or take an earlier copy.`,
};

/** Reads a stored design. @throws {FileError} when the text is not a valid design */
export function readStoredDesign(content: string, called: string): StoredDesign {
  if (content.length > greatestLength) {
    throw new FileError(
      called,
      `is longer than a design's ${greatestLength} characters; store garment and print by their URLs.`,
    );
  }
  return readVersioned(content, called, kind);
}

export const writeStoredDesign = (design: StoredDesign): string =>
  `${JSON.stringify({format: `${kind.format}/${version}`, ...design}, null, 1)}\n`;

/** Builds the stored design of a solved one; the result must be that of `problemOfStored`. */
export const designOf = (design: FiledDesign, result: SolveResult): StoredDesign => ({
  garment: design.garment,
  print: design.print,
  ...decisionsOf(design),
  alignments: Object.fromEntries(result.pieces.map((piece) => [piece.name, piece.alignment])),
  result: sha256Of(resultText(result)),
  solver: packageVersion,
});

/** Returns whether two values are equal within less than any measurement. [cm, degrees] */
const near = (one: number, other: number): boolean => Math.abs(one - other) < 1e-9;

/** Differences of a print from its file. */
export function changesOf(
  {
    group,
    size,
    turnDeg,
    oneWay,
    cell,
    delivered,
  }: Required<Omit<PrintChanges, 'colourway' | 'delivered'>> & {
    readonly delivered?: Delivered | undefined;
  },
  file: Print,
): PrintChanges {
  const own = repeatOf(file);
  const isResized = (['width', 'height', 'angleDeg'] as const).some(
    (side) => !near(size[side], own.size[side]),
  );
  return {
    ...(group !== file.group && {group}),
    ...(isResized && {size}),
    ...(!near(turnDeg, own.turnDeg) && {turnDeg}),
    ...(oneWay !== (file.oneWay ?? false) && {oneWay}),
    ...(cell !== (file.cell ?? 'primitive') && {cell}),
    ...(delivered && {delivered: fabricOnly(delivered)}),
  };
}

/**
 * The print of a design, made from its file and the changes.
 * @throws {FileError} naming the print's file
 */
export function printOfStored({print}: Pick<FiledDesign, 'print'>, content: string): Print {
  const file = readPrintFile(content, print.url);
  const {colourway, size, oneWay, cell, delivered} = print;
  const worn = colourway === undefined ? undefined : colourwayOf(file, colourway);
  if (colourway !== undefined && !worn) {
    throw new FileError(print.url, `has no colourway '${colourway}'; choose one that it has.`);
  }
  return {
    ...(hasNewLattice(print) ? withLattice(file, print) : file),
    ...(worn && {image: worn.image}),
    ...(oneWay !== undefined && {oneWay}),
    ...(cell !== undefined && {cell}),
    ...(size && {unscaled: false}), // measured by the user
    ...(delivered && {delivered}),
  };
}

/** The print with a changed lattice. Another size or turn alone gives exactly that variant. */
function withLattice(
  file: Print,
  {group = file.group, size, turnDeg, cell = file.cell}: PrintChanges,
): Print {
  const own = repeatOf(file);
  const repeat = {size: size ?? own.size, turnDeg: turnDeg ?? own.turnDeg};
  if (group === file.group && cell === file.cell) return withRepeat(file, repeat);
  const [w1, w2] = latticeVectors(group, repeat.size, repeat.turnDeg, cell);
  return {...file, group, w1: settled(w1), w2: settled(w2)};
}

const hasNewLattice = ({group, size, turnDeg}: PrintChanges): boolean =>
  group !== undefined || size !== undefined || turnDeg !== undefined;

/**
 * The print for the solver: the text of its file if nothing in it was changed.
 * @throws {FileError}
 */
export function printTextOf(design: Pick<FiledDesign, 'print'>, content: string): Print | string {
  const shown = printOfStored(design, content);
  const {print} = design;
  const isChanged = hasNewLattice(print) || print.oneWay !== undefined || print.delivered;
  return isChanged ? shown : content;
}
