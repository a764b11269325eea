/** Designs of files: their print is that of its file, with the changes of the design. */
import {fabricOnly, type Design, type DesignPrint, type StoredFile} from '../design/design.js';
import {colourwayOf, type Delivered, type Print} from '../print/repeating-print.js';
import {settled} from '../print/print-scale.js';
import {withRepeat} from '../print/print-variant.js';
import {readPrintFile} from '../print/read-print-file.js';
import {latticeVectors, repeatOf} from '../print/repeat.js';
import {FileError} from '../base/versioned-file.js';

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
