/** Reads SVG as a drawing of pieces. */
import {after, scaling, shifting} from '../../model/geometry/plane-map.js';
import type {
  Drawing,
  DrawingOptions,
  DrawnPiece,
  Run,
  UnitGuess,
} from '../../model/garment/imported-drawing.js';
import type {FileUnit} from '../../model/garment/garment-document.js';
import {mappedFold} from '../../model/garment/folds.js';
import type {Point} from '../../model/geometry/vectors.js';
import {boxOf} from '../../model/geometry/polyline.js';
import {FileError} from '../../model/base/versioned-file.js';
import {mapped} from '../base/bezier.js';
import {cmPer, guessedUnit} from '../base/units.js';
import {readXml, type XmlDocument} from '../base/xml.js';
import {withArrows} from './arrows.js';
import {freesewingPieces} from './freesewing.js';
import {genericPieces, largestClosed, type Found} from './generic.js';
import {programOf, scaleOf} from './lengths.js';
import {ownSheet} from './own-sheet.js';
import {numbersOf} from './values.js';
import {measuredScale} from './scale-box.js';
import {classesOf} from './styles.js';
import {walked, type Sheet} from './walk.js';

/**
 * Reads an SVG file.
 * @param text content of the file
 * @param file file name for messages
 * @throws {FileError} without readable pieces
 */
export function readSvg(text: string, file: string, options: DrawingOptions = {}): Drawing {
  const document = svgOf(text, file);
  const {sheet, unit, notes, isMeasured = false} = scaled(document, file, options);
  const isKnown = isMeasured || options.units !== undefined || options.pixelsPerInch !== undefined;
  const {program} = sheet;
  const {pieces, notes: found} = foundIn(sheet);
  if (pieces.length === 0) throw new FileError(file, whyNone(sheet, found), {reason: 'outline'});
  const title = titleOf(sheet);
  return {
    kind: 'svg',
    ...(program !== undefined && {program}),
    ...(title !== undefined && {title}),
    sizes: [],
    unit: {...unit, isSure: unit.isSure && (isKnown || isUsual(pieces))},
    pieces: pieces.map((piece) => inUnit(piece, unit.unit)),
    seams: [],
    notes: [...notes, ...found, ...sheet.notes],
  };
}

/**
 * The purpose of an SVG file. A pattern draws outlines of pieces in an absolute size; other files
 * are images.
 */
export type SvgUse = 'pattern' | 'picture' | 'damaged';

export function useOfSvg(text: string): SvgUse {
  let document: XmlDocument;
  try {
    document = svgOf(text, '');
  } catch (error) {
    if (error instanceof FileError) return 'damaged';
    throw error;
  }
  return drawsPieces(document) ? 'pattern' : 'picture';
}

function drawsPieces(document: XmlDocument): boolean {
  try {
    if (!scaleOf(document, '').isStated) return false;
    const {sheet} = scaled(document, '');
    const drawn = sheet.drawn.filter(
      ({style, element}) => style.stroke !== 'none' || classesOf(element).length > 0,
    );
    return foundIn({...sheet, drawn}).pieces.length > 0;
  } catch (error) {
    if (error instanceof FileError) return false;
    throw error;
  }
}

function svgOf(text: string, file: string): XmlDocument {
  const document = readXml(text, file);
  const {name} = document.root;
  if (name === 'svg') return document;
  throw new FileError(file, `is XML, but no SVG: its outermost element is <${name}>.`, {
    reason: 'unreadable',
  });
}

/** A drawing in millimetres. */
interface Scaled {
  readonly sheet: Sheet;
  /** The unit of the output. */
  readonly unit: UnitGuess;
  readonly notes: readonly string[];
  /** True if a test square confirms the scale or sets it. */
  readonly isMeasured?: boolean;
}

/** Tolerance of a test square for the rounding of files. */
const rounding = 0.003;

function scaled(
  document: XmlDocument,
  file: string,
  {units, pixelsPerInch, scale}: DrawingOptions = {},
): Scaled {
  const {millimetres, because, note, stretch = 1} = scaleOf(document, file, pixelsPerInch);
  const times = scale ?? 1;
  const at = (factor: number): Sheet =>
    sheetOf(document, [times * factor, times * factor * stretch], file);
  const sure = {isSure: true, others: []};
  if (units !== undefined) {
    const unit: UnitGuess = {unit: units, because: 'stated', ...sure};
    return {sheet: at(10 * cmPer(units)), unit, notes: []};
  }
  if (pixelsPerInch !== undefined || (scale !== undefined && millimetres !== undefined)) {
    const unit: UnitGuess = {unit: 'mm', because: 'stated', ...sure};
    return {sheet: at(millimetres ?? 1), unit, notes: []};
  }
  const notes = note === undefined ? [] : [note];
  const sheet = at(millimetres ?? 1);
  const ratio = measuredScale(sheet);
  const isMeasured = ratio !== undefined;
  if (ratio !== undefined && (Math.abs(ratio - 1) > rounding || millimetres === undefined)) {
    const unit: UnitGuess = {unit: 'mm', because: 'measured', ...sure};
    return {sheet: at((millimetres ?? 1) * ratio), unit, notes: [measuredNote(ratio)], isMeasured};
  }
  if (millimetres === undefined) {
    const unit = guessedUnit({largest: largestClosed(sheet), because});
    return {sheet: at(10 * cmPer(unit.unit)), unit, notes};
  }
  return {sheet, unit: {unit: 'mm', because, ...sure}, notes, isMeasured};
}

function sheetOf(document: XmlDocument, [x, y]: Point, file: string): Sheet {
  const {root} = document;
  const {name: program} = programOf(document);
  const [left = 0, top = 0, across = 0, down = 0] = numbersOf(root.attributes.get('viewBox'));
  const map = after(scaling(x, -y), shifting(-left, -top));
  const page: Point = [x * across, y * down];
  return {...walked(root, map, file), page, ...(program !== undefined && {program})};
}

const measuredNote = (ratio: number): string =>
  `By its test square it is drawn at ${(100 / ratio).toFixed(1)} % of its size, and taken ${ratio.toFixed(4)} times as large.`;

function foundIn(sheet: Sheet): Found {
  const found = freesewingPieces(sheet);
  if (found.pieces.length > 0) return found;
  const own = ownSheet(sheet);
  const {drawn, ...rest} = own ?? sheet;
  const isNamedByGroup = own !== undefined;
  return genericPieces({...rest, drawn: withArrows(drawn)}, {isNamedByGroup});
}

/** Returns whether pieces have a wearable size. [mm] */
function isUsual(pieces: readonly DrawnPiece[]): boolean {
  const sides = pieces.map(({sewn}) => {
    const {low, high} = boxOf(sewn.flatMap(({start, cubics}) => [start, ...cubics.flat()]));
    return Math.max(high[0] - low[0], high[1] - low[1]);
  });
  return guessedUnit({largest: Math.max(...sides), stated: ['mm']}).isSure;
}

function whyNone(sheet: Sheet, notes: readonly string[]): string {
  const first = notes.find((note) => /does not close|as no pattern has/.test(note));
  if (first !== undefined) return `shows no piece: ${first}`;
  const largest = largestClosed(sheet) / 10;
  if (largest > 0) {
    return `shows no piece: its largest closed line is ${largest.toFixed(1)} cm long, and pieces have 4 cm² or more; correct its size, or give its units.`;
  }
  return sheet.drawn.length === 0 && sheet.texts.length > 0
    ? 'shows text alone, and no outline of a piece; export the outlines, too.'
    : 'shows no closed line, as outlines of pieces are; join the ends of its lines.';
}

function titleOf({texts}: Sheet): string | undefined {
  const lines = texts.flatMap((text) => text.lines);
  return lines.flatMap((line) => /^FreeSewing (.+?) v\d/.exec(line)?.[1] ?? [])[0];
}

/** Converts a piece from millimetres. */
function inUnit(piece: DrawnPiece, unit: FileUnit): DrawnPiece {
  const factor = 0.1 / cmPer(unit);
  if (factor === 1) return piece;
  const at = ([x, y]: Point): Point => [factor * x, factor * y];
  const runs = (loop: readonly Run[]): Run[] => loop.map((run) => mapped(run, at));
  const line = ([a, b]: readonly [Point, Point]): [Point, Point] => [at(a), at(b)];
  return {
    ...piece,
    sewn: runs(piece.sewn),
    ...(piece.cut && {cut: runs(piece.cut)}),
    holes: piece.holes.map(runs),
    notches: piece.notches.map((notch) => ({...notch, at: at(notch.at)})),
    ...(piece.grain && {grain: line(piece.grain)}),
    ...(piece.grains && {grains: piece.grains.map((one) => ({...one, line: line(one.line)}))}),
    ...(piece.fold && {fold: line(piece.fold)}),
    ...(piece.folds && {folds: piece.folds.map((one) => mappedFold(one, at))}),
    internalLines: piece.internalLines.map((points) => points.map(at)),
    drillHoles: piece.drillHoles.map(at),
  };
}
