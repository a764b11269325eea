/** A design as shops store it: decisions, their files, and the result. */
import {decisionsOf} from '../design/design.js';
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
import {fail, recordOf, shape, text, type Read} from '../base/read.js';
import type {FiledDesign} from './filed-design.js';
import {resultText, sha256Of} from './result-text.js';
import type {SolveResult} from '../result/result.js';
import {FileError, readVersioned, type FileKind} from '../base/versioned-file.js';
import {packageVersion} from '../base/version.js';

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
