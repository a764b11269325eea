import {dirname} from 'node:path';
import {pathToFileURL} from 'node:url';

import type {SolveOptions} from '../model/design/options.js';
import type {Method} from '../model/result/method.js';
import {sha256Of} from '../model/documents/result-text.js';
import type {SolveResult} from '../model/result/result.js';
import {designOf, readStoredDesign, writeStoredDesign} from '../model/documents/stored-design.js';
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

/**
 * The text of a design with file addresses relative to its own location.
 * @throws {FileError} if the design is invalid
 */
export function storedText(designFile: string, given: Aligned, result: SolveResult): string {
  const {symmetry, options, method, seed} = given;
  const stored = ({path, bytes}: InputFile) => ({
    url: relativeUrl(designFile, path),
    sha256: sha256Of(bytes),
  });
  const asked =
    symmetry === 'auto' || symmetry === 'none'
      ? symmetry
      : (JSON.parse(symmetry) as Symmetries).symmetries;
  const design = designOf(
    {
      ...{garment: stored(given.garment), print: stored(given.print)},
      ...{symmetry: asked, method, options: JSON.parse(options) as SolveOptions, seed},
    },
    result,
  );
  // reading it again drops fields that no solve depends on, and detects now what `order` would
  // reject
  return writeStoredDesign(readStoredDesign(writeStoredDesign(design), designFile));
}

function relativeUrl(from: string, to: string): string {
  const [folder, target] = [dirname(from), to].map((path) => pathToFileURL(path).pathname);
  const [own = [], other = []] = [folder, target].map((path) => path?.split('/'));
  const parting = own.findIndex((part, k) => part !== other[k]);
  const shared = parting < 0 ? own.length : parting;
  const way = [...own.slice(shared).map(() => '..'), ...other.slice(shared)].join('/');
  return /^[^/]*:/.test(way) ? `./${way}` : way; // otherwise a colon would end a scheme
}
