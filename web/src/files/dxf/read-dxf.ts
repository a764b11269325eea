/** Reads DXF files of pattern programs, AAMA and ASTM, as drawings. */
import {
  type Drawing,
  type DrawingOptions,
  type UnitGuess,
  drawingTitle,
} from '../../model/garment/imported-drawing.js';
import {FileError} from '../../model/base/versioned-file.js';
import {cmPer} from '../base/units.js';
import {Blocks, scaled, type Drawn} from './blocks.js';
import {documentOf, type DxfDocument} from './document.js';
import {drawnPiece, type DrawnDxfPiece, type DrawnWith} from './drawn-piece.js';
import {checkCount} from './count.js';
import {flatPieces, largestLine, type FlatDrawing} from './flat.js';
import {isPieceBlock, pieceOf, type DxfPiece} from './pieces.js';
import {chooseSize} from './sizes.js';
import {systemText, type SystemText} from './system-text.js';
import {textOf} from './text.js';
import {largestOf, timesOf, unitOf, type UnitWords} from './units.js';
import {vendorOf} from './vendors.js';

/**
 * Reads a DXF file.
 * @throws {FileError} with the file, the error and a remedy
 */
export function readDxf(bytes: Uint8Array, file: string, options: DrawingOptions): Drawing {
  const document = scaledDocument(documentOf(textOf(bytes), file), options);
  const blocks = new Blocks(document, file);
  const style = styleOf(document);
  const words = {style, header: document.header, chosen: options.units};
  const {pieces: all, notes: found, unit} = piecesOf(blocks, words, file, options);
  const stated = style.value('sample size');
  const {pieces, ...sizes} = chooseSize(all, {stated, wanted: options.size, file});
  checkCount(pieces.length, file);
  const vendor = vendorOf(style.value('author'));
  const how = {cmPerUnit: cmPer(unit.unit), vendor, file};
  const {drawn, notes: lost} = drawnPieces(pieces, how);
  const title = style.value('style name');
  return {
    kind: 'dxf',
    ...(vendor.program !== undefined && {program: vendor.program}),
    ...(title !== undefined && {title: drawingTitle(title, file)}),
    ...sizes,
    unit,
    pieces: drawn.map(({piece}) => piece),
    seams: [],
    notes: [
      ...styleNotes(style),
      ...hiddenNotes(document),
      ...[...blocks.missing].map((name) => `It inserts a block '${name}' that it does not hold.`),
      ...(blocks.isTooDeep ? ['Blocks in blocks more than four levels deep are left out.'] : []),
      ...(drawn.some(({isInterpolated}) => isInterpolated)
        ? [
            `The file holds points of each outline; smooth curves are drawn through them, as ${vendor.rule === 'natural' ? 'usual' : 'Gerber does'}.`,
          ]
        : []),
      ...found,
      ...lost,
      ...drawn.flatMap(({notes}) => notes),
    ],
  };
}

const styleOf = ({entities}: DxfDocument): SystemText =>
  systemText(entities.filter((entity) => entity.kind === 'text'));

/** The document in a unit that patterns use. */
function scaledDocument(document: DxfDocument, {units, scale = 1}: DrawingOptions): DxfDocument {
  const times = scale * timesOf({style: styleOf(document), header: document.header, chosen: units});
  return times === 1 ? document : scaled(document, times);
}

/** Lines that belong together: those of a block, or those outside of blocks. */
interface FlatGroup extends Pick<FlatDrawing, 'name' | 'others' | 'inserted'> {
  readonly entities: readonly Drawn[];
}

interface FoundPieces {
  /** Pieces in all sizes. */
  readonly pieces: readonly DxfPiece[];
  readonly unit: UnitGuess;
  readonly notes: readonly string[];
}

/**
 * Pieces of blocks with a boundary, then those of other blocks and loose lines.
 * @throws {FileError} without any
 */
function piecesOf(
  blocks: Blocks,
  words: UnitWords,
  file: string,
  {size}: DrawingOptions,
): FoundPieces {
  const placed = blocks.placed();
  const inBlocks = placed.filter(isPieceBlock).map(pieceOf);
  const stated = words.style.value('sample size');
  const groups: readonly FlatGroup[] =
    inBlocks.length > 0
      ? [
          ...placed.filter((block) => !isPieceBlock(block) && block.isInserted),
          {entities: blocks.loose(), others: placed.map(({entities}) => entities)},
        ]
      : [{entities: blocks.flat()}];
  const largest =
    inBlocks.length > 0
      ? largestOf(chooseSize(inBlocks, {stated, wanted: size, file}).pieces)
      : Math.max(...groups.map(({entities}) => largestLine(entities)));
  const unit = unitOf(largest, words);
  const cmPerUnit = cmPer(unit.unit);
  const flat = groups.map(({entities, ...group}) =>
    flatPieces(entities, {...group, cmPerUnit, file}),
  );
  const pieces = [...inBlocks, ...flat.flatMap((group) => group.pieces)];
  const notes = flat.flatMap((group) => group.notes);
  const taken = pieces.filter(({doubt}) => doubt === undefined);
  checkCount(inBlocks.length > 0 ? 0 : taken.length, file);
  if (taken.length > 0) return {pieces, unit, notes};
  const why = notes.find((note) => note.includes('does not close'));
  throw new FileError(
    file,
    why === undefined
      ? 'has no closed outline; export the pieces as DXF (AAMA or ASTM).'
      : `has no closed outline: ${why}`,
    {reason: 'outline'},
  );
}

/**
 * Draws the pieces, except those without an outline.
 * @throws {FileError} if none has one
 */
function drawnPieces(
  pieces: readonly DxfPiece[],
  how: DrawnWith,
): {readonly drawn: readonly DrawnDxfPiece[]; readonly notes: readonly string[]} {
  const drawn: DrawnDxfPiece[] = [];
  const errors: FileError[] = [];
  for (const piece of pieces) {
    try {
      drawn.push(drawnPiece(piece, how));
    } catch (error) {
      if (!(error instanceof FileError)) throw error;
      errors.push(error);
    }
  }
  const [first] = errors;
  if (first && drawn.every(({piece}) => piece.doubt !== undefined)) throw first;
  return {
    drawn,
    notes: errors.map(
      ({message}) => `A piece is left out: the file ${message.slice(how.file.length + 1)}`,
    ),
  };
}

/** Notes on lines that the program of the file does not show. */
const hiddenNotes = ({hidden}: DxfDocument): string[] =>
  [...hidden].map(([reason, count]) =>
    `${count} ${count === 1 ? 'line or block' : 'lines or blocks'} ${reason}, ${count === 1 ? 'is' : 'are'} left out.`.replace(
      /( marked as invisible| in paper space),/,
      '$1',
    ),
  );

function styleNotes(style: SystemText): string[] {
  const styles = [...new Set(style.all('style name'))];
  const rules = style.value('grade rule table');
  return [
    ...(styles.length > 1
      ? [`It holds ${styles.length} styles, ${styles.join(', ')}, whose pieces are all opened.`]
      : []),
    ...(rules === undefined
      ? []
      : [
          `Grade rules are in a table of their own, ${rules}, which is not read: other sizes are those in the file.`,
        ]),
  ];
}
