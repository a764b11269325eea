import {dirname} from 'node:path';
import {pathToFileURL} from 'node:url';

import type {SolveOptions} from '../model/design/options.js';
import type {Method} from '../model/result/method.js';
import {sha256Of} from '../model/documents/result-text.js';
import type {SolveResult} from '../model/result/result.js';
import {readPrintFile} from '../model/print/read-print-file.js';
import {repeatOf} from '../model/print/repeat.js';
import {
  designOf,
  readStoredDesign,
  writeStoredDesign,
  type PrintChanges,
} from '../model/documents/stored-design.js';
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
}

/** The input with the size and seed that were chosen for the result. */
export interface Chosen extends Aligned {
  /** Scale of the result's print relative to its file. */
  readonly scale: number;
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
  const print = {...stored(given.print), ...sizeOf(given)};
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

/** The chosen size of the print, if it is not that of its file. */
function sizeOf({print, scale}: Chosen): Pick<PrintChanges, 'size'> {
  const file = readPrintFile(textOf(print.bytes), print.path);
  const ratio = scale / (file.scale ?? 1);
  if (ratio === 1) return {};
  const {width, height, angleDeg} = repeatOf(file).size;
  return {size: {width: ratio * width, height: ratio * height, angleDeg}};
}

function relativeUrl(from: string, to: string): string {
  const [folder, target] = [dirname(from), to].map((path) => pathToFileURL(path).pathname);
  const [own = [], other = []] = [folder, target].map((path) => path?.split('/'));
  const parting = own.findIndex((part, k) => part !== other[k]);
  const shared = parting < 0 ? own.length : parting;
  const way = [...own.slice(shared).map(() => '..'), ...other.slice(shared)].join('/');
  return /^[^/]*:/.test(way) ? `./${way}` : way; // otherwise a colon would end a scheme
}
