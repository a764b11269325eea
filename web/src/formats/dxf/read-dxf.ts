/** Reads DXF files of pattern programs, AAMA and ASTM, as drawings. */
import {
  type Drawing,
  type DrawingOptions,
  drawingTitle,
} from '../../model/garment/imported-drawing.js';
import {FileError} from '../../model/base/versioned-file.js';
import {cmPer} from '../base/units.js';
import {Blocks} from './blocks.js';
import {documentOf} from './document.js';
import {drawnPiece} from './drawn-piece.js';
import {checkCount} from './count.js';
import {flatPieces} from './flat.js';
import {blockPieces} from './pieces.js';
import {chooseSize} from './sizes.js';
import {systemText, type SystemText} from './system-text.js';
import {textOf} from './text.js';
import {largestOf, unitOf} from './units.js';
import {vendorOf} from './vendors.js';

/**
 * Reads a DXF file.
 * @throws {FileError} with the file, the error and a remedy
 */
export function readDxf(bytes: Uint8Array, file: string, options: DrawingOptions): Drawing {
  const document = documentOf(textOf(bytes), file);
  const blocks = new Blocks(document, file);
  const style = systemText(document.entities.filter((entity) => entity.kind === 'text'));
  const words = {style, header: document.header, chosen: options.units};
  const inBlocks = blockPieces(blocks);
  const all =
    inBlocks.length > 0
      ? inBlocks
      : flatPieces(blocks.flat(), file, (largest) => cmPer(unitOf(largest, words).unit));
  if (all.length === 0) {
    throw new FileError(file, 'has no closed outline; export the pieces as DXF (AAMA or ASTM).');
  }
  const stated = style.value('sample size');
  const {pieces, ...sizes} = chooseSize(all, {stated, wanted: options.size, file});
  checkCount(pieces.length, file);
  const unit = unitOf(largestOf(pieces), words);
  const vendor = vendorOf(style.value('author'));
  const drawn = pieces.map((piece) =>
    drawnPiece(piece, {cmPerUnit: cmPer(unit.unit), vendor, file}),
  );
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
      ...[...blocks.missing].map((name) => `It inserts a block '${name}' that it does not hold.`),
      ...(blocks.isTooDeep ? ['Blocks in blocks more than four levels deep are left out.'] : []),
      ...(drawn.some(({isInterpolated}) => isInterpolated)
        ? [
            `Outlines are drawn by key points, and curves are put through them as ${vendor.rule === 'natural' ? 'natural cubic splines' : 'Catmull-Rom splines, as Gerber does'}.`,
          ]
        : []),
    ],
  };
}

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
