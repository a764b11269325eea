import {dirname} from 'node:path';
import {pathToFileURL} from 'node:url';

import type {SolveOptions} from '../model/design/options.js';
import type {Method} from '../model/result/method.js';
import {sha256Of} from '../model/documents/result-text.js';
import type {SolveResult} from '../model/result/result.js';
import {readPrintFile} from '../model/print/read-print-file.js';
import {asSewn, withFabric} from '../model/print/as-sewn.js';
import type {Delivered, Print} from '../model/print/repeating-print.js';
import {asVariant, variedRepeat, type PrintVariant} from '../model/print/print-variant.js';
import {repeatOf} from '../model/print/repeat.js';
import {changesOf, type PrintChanges} from '../model/documents/filed-design.js';
import {designOf, readStoredDesign, writeStoredDesign} from '../model/documents/stored-design.js';
import {textOf} from '../node/files.js';
import type {Symmetries} from '../model/garment/symmetries.js';

interface InputFile {
  readonly path: string;
  readonly bytes: Uint8Array;
}

/** The input of `align`. */
export interface Aligned {
  readonly garment: InputFile;
  readonly print: InputFile;
  /** `auto`, `none` or the text of a symmetry file. */
  readonly symmetry: string;
  readonly method: Method;
  readonly options: string;
  readonly seed: number;
  /** The fabric by flags, in place of that of the print's file. */
  readonly delivered?: Delivered;
}

/** The input with size, turn and seed that were chosen for the result. */
export interface Chosen extends Aligned {
  /** The result's print relative to its file. */
  readonly variant: PrintVariant;
}

/**
 * The text of a design with file addresses relative to its own location.
 * @throws {FileError} if the design is invalid
 */
export function storedText(designFile: string, given: Chosen, result: SolveResult): string {
  const {symmetry, options, method, seed} = given;
  const stored = ({path, bytes}: InputFile) => ({
    url: relativeUrl(designFile, path),
    sha256: sha256Of(bytes),
  });
  const print = {...stored(given.print), ...variedIn(given)};
  const asked =
    symmetry === 'auto' || symmetry === 'none'
      ? symmetry
      : (JSON.parse(symmetry) as Symmetries).symmetries;
  const design = designOf(
    {
      ...{garment: stored(given.garment), print},
      ...{symmetry: asked, method, options: JSON.parse(options) as SolveOptions, seed},
    },
    result,
  );
  // reading it again drops fields that no solve depends on, and detects now what `order` would
  // reject
  return writeStoredDesign(readStoredDesign(writeStoredDesign(design), designFile));
}

/** The chosen size and turn of the print, if they are not those of its file. */
function variedIn({print, variant, delivered}: Chosen): PrintChanges {
  if (delivered) return sewnIn(readPrintFile(textOf(print.bytes), print.path), variant, delivered);
  const {size, turnDeg} = variedRepeat(
    repeatOf(readPrintFile(textOf(print.bytes), print.path)),
    variant,
  );
  return {...(variant.scale !== 1 && {size}), ...(variant.turnDeg !== 0 && {turnDeg})};
}

/** The print after the wash, as changes of its file. */
function sewnIn(file: Print, variant: PrintVariant, delivered: Delivered): PrintChanges {
  const sewn = asSewn(withFabric(asVariant(file, variant), delivered));
  const {group, cell = 'primitive', oneWay = false} = sewn;
  return changesOf({group, cell, oneWay, ...repeatOf(sewn), delivered: {...delivered}}, file);
}

function relativeUrl(from: string, to: string): string {
  const [folder, target] = [dirname(from), to].map((path) => pathToFileURL(path).pathname);
  const [own = [], other = []] = [folder, target].map((path) => path?.split('/'));
  const parting = own.findIndex((part, k) => part !== other[k]);
  const shared = parting < 0 ? own.length : parting;
  const way = [...own.slice(shared).map(() => '..'), ...other.slice(shared)].join('/');
  return /^[^/]*:/.test(way) ? `./${way}` : way; // otherwise a colon would end a scheme
}
