/** Designs of an element: after a change of the request, from a stored design, and as one. */
import {
  decisionsOf,
  usualFabric,
  type Design,
  type DesignPrint,
} from '../../model/design/design.js';
import type {GarmentDocument} from '../../model/garment/garment-document.js';
import {newDesign} from '../../workbench/samples.js';
import type {Asked, FileWords, Loaded} from './sources.js';
import {SolverError} from '../../model/base/failure.js';
import {designOf, type StoredDesign} from '../../model/documents/stored-design.js';
import {filedDesign} from '../../model/documents/design-problem.js';
import type {SolveResult} from '../../model/result/result.js';

/**
 * Converts a stored design to an editable one.
 * @throws {SolverError} `file-changed` if a file differs from the one used for the design
 */
export function restored({garment, print}: Loaded, stored: StoredDesign, words: FileWords): Design {
  for (const [found, sold] of [
    [garment.file, stored.garment],
    [print.file?.place, stored.print],
  ] as const) {
    if (found?.sha256 !== sold.sha256) {
      throw new SolverError({code: 'file-changed', message: words.fileChanged(sold.url)});
    }
  }
  return {garment, print: changed(print, stored.print), ...decisionsOf(stored)};
}

function changed(print: DesignPrint, stored: StoredDesign['print']): DesignPrint {
  const {
    group = print.group,
    size = print.size,
    turnDeg = print.turnDeg,
    oneWay = print.oneWay,
    cell = print.cell,
  } = stored;
  const isMeasured = print.unscaled && stored.size !== undefined;
  return {...print, group, size, turnDeg, oneWay, cell, ...(isMeasured && {unscaled: false})};
}

/**
 * Returns the design of an element with its answer, to be stored.
 * @throws {SolverError} if the garment or the print has no URL to store; the message is one
 * sentence
 */
export function storedDesign(design: Design, result: SolveResult, words: FileWords): StoredDesign {
  const missing = !design.garment.file
    ? words.garment
    : !design.print.file?.place
      ? words.print
      : undefined;
  if (missing !== undefined) {
    throw new SolverError({code: 'options', message: words.notStorable(missing)});
  }
  return designOf(filedDesign(design), result);
}

/** A request and the loaded files. */
export interface Answered {
  readonly asked: Asked;
  readonly loaded: Loaded;
}

type Pins = Design['options']['pins'];

/** Garment documents, if they have been read. */
export interface ReadGarments {
  readonly before?: GarmentDocument | undefined;
  readonly next?: GarmentDocument | undefined;
}

/**
 * Makes the design after a change of the request; the user's other changes stay.
 * @param before undefined for a fresh start
 * @param now the current design, which came from `before`
 */
export function nextDesign(
  {asked, loaded}: Answered,
  before: Answered | undefined,
  now: Design | undefined,
  read: ReadGarments = {},
): Design {
  const {garment, print} = loaded;
  const fresh = newDesign(garment, print);
  const isSameGarment = before?.loaded.garment === garment;
  const kept = now && before ? now : fresh;
  const {pins, ...options} = isSameGarment || !before ? kept.options : fresh.options;
  const isSameMost = before?.asked.maxChangeCm === asked.maxChangeCm;
  const most = isSameMost ? kept.options.maxChangeCm : asked.maxChangeCm;
  const placed =
    pins ??
    (before && !isSameGarment
      ? pinsFor(kept.options.pins, {asked, loaded}, before, read)
      : undefined);
  const fabric = before?.asked.fabric === asked.fabric ? kept.fabric : asked.fabric;
  const isSameSymmetry = isSameGarment && before.asked.symmetry === asked.symmetry;
  return {
    garment: isSameGarment ? kept.garment : garment, // keeps the seams that the user has sewn
    print: before?.loaded.print === print ? kept.print : print,
    symmetry: isSameSymmetry && now ? now.symmetry : loaded.symmetry,
    method: kept.method,
    options: {
      ...options,
      ...(most !== undefined && {maxChangeCm: most}),
      ...(placed && {pins: placed}),
    },
    seed: kept.seed,
    ...(isSameGarment && kept.names && {names: kept.names}),
    ...(fabric && fabric !== usualFabric && {fabric}),
  };
}

/**
 * Keeps pins from one size to another. Another pattern may have pieces of the same names, which do
 * not indicate where a customer wants its print.
 */
function pinsFor(pins: Pins, next: Answered, before: Answered, read: ReadGarments): Pins {
  if (!pins || !isOtherSize(next, before, read)) return undefined;
  const names = new Set(read.next?.pieces.map(({name}) => name));
  const kept = Object.entries(pins).filter(([name]) => names.has(name));
  return kept.length > 0 ? Object.fromEntries(kept) : undefined;
}

/**
 * Returns whether two garments are sizes of one: the same template, or the same title in both
 * files.
 */
function isOtherSize(next: Answered, before: Answered, read: ReadGarments): boolean {
  if (typeof next.asked.garment === 'string' && next.asked.garment === before.asked.garment) {
    return true;
  }
  const title = read.next?.title;
  return title !== undefined && title === read.before?.title;
}
