/**
 * Writes cutting sheets as AAMA or ASTM DXF: R12 syntax, one block for each piece and size, in
 * millimetres or inches.
 */
import {plus, type Point} from '../../model/geometry/vectors.js';
import {packageVersion} from '../../model/base/version.js';
import type {CutSheet, LaidPiece} from '../cut-sheet.js';
import type {DxfFormat, DxfUnit} from '../../model/base/dxf-format.js';
import {block, dxfFile, insert, plainText, text, type Pair} from '../../files/dxf/records.js';
import {drawn, layers, type PieceDxfOptions} from './piece-dxf.js';

export interface DxfOptions extends PieceDxfOptions {
  /** Creation date of the file. */
  readonly date?: Date;
  /** Size of the sheet. Default: that of the garment. */
  readonly size?: string;
  /** Sheets of other sizes of the pattern. Each has a size, and no two have the same. */
  readonly otherSizes?: readonly CutSheet[];
  /** Warning on layer 15, on every piece and below the sheet. */
  readonly mark?: string;
}

/** Greatest length of block names in some readers. */
const longestName = 31;
/** Distance between the sheets of two sizes. [cm] */
const betweenSizes = 5;

function words(
  piece: LaidPiece,
  name: string,
  {size}: CutSheet,
  {style, mark}: DxfOptions,
): readonly Pair[] {
  const [foot] = piece.grain;
  const said = [
    `Piece Name: ${name}`,
    `Quantity: ${piece.quantity},0`,
    ...(size === undefined ? [] : [`Size: ${size}`]),
    ...(piece.material === undefined ? [] : [`Material: ${piece.material}`]),
    ...(style === 'astm' ? [] : [`Annotation: ${piece.words.join('; ')}`]),
  ];
  return [
    ...said.flatMap((one) => text(layers.cut, foot, one)),
    ...piece.words.flatMap((one, k) => text(layers.words, plus(foot, [0, -k]), one)),
    ...(mark === undefined ? [] : text(layers.words, plus(foot, [0, 1]), mark)),
    ...piece.letters.flatMap(({letter, at}) => text(layers.words, at, letter)),
  ];
}

/** A name whose block name is unique, with an ending that distinguishes its size. */
function uniqueName(stem: string, ending: string, taken: Set<string>): string {
  const named = (end: string): string => stem.slice(0, longestName - end.length) + end;
  let unique = named(ending);
  for (let n = 2; taken.has(blockName(unique).toLowerCase()); n++) unique = named(` ${n}${ending}`);
  taken.add(blockName(unique).toLowerCase());
  return unique;
}

/** Unique readable names in 7-bit ASCII, regardless of case. */
export function namesOf(pieces: readonly Pick<LaidPiece, 'name'>[]): readonly string[] {
  const taken = new Set<string>();
  return pieces.map(({name}, k) => {
    const plain = plainText(name);
    const readable = /\w/.test(plain) && !plain.includes('?') ? plain : `piece ${k + 1}`;
    return uniqueName(readable, '', taken);
  });
}

/** A block name of characters that every reader supports. */
export const blockName = (name: string): string => name.replace(/[^\w-]+/g, '_');

const twoDigits = (value: number): string => String(value).padStart(2, '0');

/** The system text of a style, of which a file has one. */
export function styleText(
  {title, size}: Pick<CutSheet, 'title' | 'size'>,
  {date, style, unit}: DxfFormat & Pick<DxfOptions, 'date'>,
): readonly string[] {
  const day = date && [date.getUTCDate(), date.getUTCMonth() + 1].map(twoDigits);
  return [
    ...(style === 'astm' ? ['ASTM/D13Proposal 1 Version: D 6673-10'] : []),
    `Style Name: ${title ?? 'Pattern'}`,
    ...(date && day ? [`Creation Date: ${day.join('-')}-${date.getUTCFullYear()}`] : []),
    `Author: Seamwise;Seamwise;${packageVersion}`,
    ...(size === undefined ? [] : [`Sample Size: ${size}`]),
    unitText(unit),
  ];
}

const unitText = (unit: DxfUnit | undefined): string =>
  `Units: ${unit === 'in' ? 'ENGLISH' : 'METRIC'}`;

/** The place of each sheet, one above the other. */
function rowsOf(sheets: readonly CutSheet[]): readonly Point[] {
  let top = 0;
  return sheets.map(({heightCm}): Point => {
    const row: Point = [0, top];
    top += heightCm + betweenSizes;
    return row;
  });
}

/**
 * The text of a DXF file in 7-bit ASCII. Pieces of one name are sizes of one piece; the sheet is
 * the sample size.
 */
export function sheetDxf(drawnSheet: CutSheet, options: DxfOptions = {}): string {
  const {size, otherSizes = [], mark} = options;
  const sheet = size === undefined ? drawnSheet : {...drawnSheet, size};
  const sheets = [sheet, ...otherSizes];
  const rows = rowsOf(sheets);
  const taken = new Set<string>();
  const placed = sheets.flatMap((one, row) => {
    const ending = sheets.length > 1 && one.size !== undefined ? `_${plainText(one.size)}` : '';
    const names = namesOf(one.pieces);
    return one.pieces.map((piece, k) => {
      const name = names[k] ?? piece.name;
      const called = blockName(uniqueName(name, ending, taken));
      const entities = [...words(piece, name, one, options), ...drawn(piece, options)];
      return {block: block(called, entities), insert: insert(called, rows[row])};
    });
  });
  const style = styleText(sheet, options).flatMap((one, k) => text(layers.cut, [0, -2 - k], one));
  const warning = mark === undefined ? [] : text(layers.words, [0, -1], mark);
  return dxfFile(
    placed.flatMap((one) => one.block),
    [...warning, ...style, ...placed.flatMap((one) => one.insert)],
    options.unit,
  );
}
