/** Jobs as lines of a file, and the key of a job's answer. */
import {usualSeed, type Design} from '../../model/design/design.js';
import {seed as seedField} from '../../model/design/read-design.js';
import {FileError} from '../../model/base/versioned-file.js';
import {
  fail,
  flag,
  isTooDeep,
  listOf,
  Malformed,
  number,
  oneOf,
  shape,
  text,
  type Read,
} from '../../model/base/read.js';
import {methods} from '../../model/result/method.js';
import type {SolveOptions} from '../../model/design/options.js';
import type {Symmetry} from '../../model/garment/symmetries.js';
import {sha256Of} from '../../model/documents/result-text.js';
import {packageVersion} from '../../model/base/version.js';
import {addressFrom} from '../../node/addresses.js';
import {paperOf} from '../../paper/papers.js';
import {printInks} from '../../cutting/print-ink.js';
import {greatestAllowance} from '../../cutting/allowance-rule.js';
import type {CutWish} from '../base/cut-files.js';
import {layFields, type LayWish} from '../base/lay-wish.js';

/** A garment in a print. Addresses are absolute; options and symmetries are unchanged. */
export interface Job extends Omit<Design<string, string>, 'names' | 'fabric'> {
  readonly label: Label;
  /** Drapes the result and writes it as GLB. */
  readonly drape: boolean;
  /** Settings to write the cutting sheet as PDF; null for none. */
  readonly cut: CutWish | null;
  /** Settings to lay the pieces out; null for no layout. */
  readonly marker: LayWish | null;
}

/** The label of a job, which does not change its answer. */
export interface Label {
  readonly name: string | null;
  /** Unchanged from the line. */
  readonly garment: string;
  readonly print: string;
  readonly size: string | null;
}

/**
 * A job with the SHA-256 of its files, and its key: the SHA-256 of everything its answer depends
 * on.
 */
export interface KeyedJob extends Job {
  readonly key: string;
  readonly garmentSha256: string;
  readonly printSha256: string;
}

const singles = ['garment', 'print', 'size'] as const;
const known = [
  ...singles,
  ...singles.map((name) => `${name}s`),
  ...['symmetry', 'method', 'options', 'seed', 'name', 'drape', 'cut', 'marker'],
];
const mark = '{size}';

const word = text(/\S/, 'text');
/** The core checks the content. */
const object: Read<SolveOptions> = (value, at) =>
  typeof value === 'object' && value !== null && !Array.isArray(value)
    ? value
    : fail(at, 'an object');
const symmetryField: Read<Job['symmetry']> = (value, at) =>
  value === 'auto' || value === 'none'
    ? value
    : Array.isArray(value)
      ? (value as readonly Symmetry[])
      : fail(at, "'auto', 'none' or a list of symmetries");

const paper: Read<string> = (value, at) =>
  typeof value === 'string' && paperOf(value) ? value : fail(at, 'a paper, such as a4 or 60x90cm');
const allowance = number(0, greatestAllowance);
const cutFields: Read<CutWish> = shape(
  {},
  {paper, allowance, hem: allowance, ink: oneOf(printInks), guide: flag},
);

const fields = shape(
  {},
  {
    ...{garment: word, print: word, size: word, name: word},
    ...{garments: listOf(word), prints: listOf(word), sizes: listOf(word)},
    ...{symmetry: symmetryField, method: oneOf(methods), options: object, seed: seedField},
    drape: flag,
    cut: cutFields,
    marker: layFields,
  },
);

/**
 * The jobs of a line: every listed garment in every size and print.
 * @param base base of relative addresses
 * @throws {Malformed} if the line is no job
 * @throws {FileError} for an invalid address
 */
export function* jobsOf(line: string, base: URL): Generator<Job> {
  let value: unknown;
  try {
    value = JSON.parse(line);
  } catch {
    throw new Malformed('it is not JSON');
  }
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    throw new Malformed('it is not an object');
  }
  if (isTooDeep(value)) throw new Malformed('it is nested too deep');
  const given = fields(value, '');
  const unknown = Object.keys(value).find((name) => !known.includes(name));
  if (unknown !== undefined) {
    throw new Malformed(`there is no field '${unknown}', but ${known.join(', ')}`);
  }
  const garments = oneOrList(given, 'garment');
  const prints = oneOrList(given, 'print');
  const sizes = (given.size ?? given.sizes) ? oneOrList(given, 'size') : [null];
  const unsized = garments.find((garment) => sizes.length > 1 && !garment.includes(mark));
  if (unsized !== undefined) fail('garment', `a name with ${mark} in it, since there are sizes`);
  const {name = null, symmetry = 'auto', method = 'best', options = {}, seed = usualSeed} = given;
  const {drape = false, cut = null, marker = null} = given;
  for (const garment of garments) {
    for (const size of sizes) {
      const file = size === null ? garment : garment.replaceAll(mark, size);
      const garmentAddress = addressFrom(base, file).href;
      for (const print of prints) {
        yield {
          label: {name, garment: file, print, size},
          garment: garmentAddress,
          print: addressFrom(base, print).href,
          ...{symmetry, method, options, seed, drape, cut, marker},
        };
      }
    }
  }
}

function oneOrList(
  given: ReturnType<typeof fields>,
  name: (typeof singles)[number],
): readonly string[] {
  const [one, list] = [given[name], given[`${name}s`]];
  if (one !== undefined && list !== undefined) {
    throw new Malformed(`'${name}' and '${name}s' are both given, but only one may be`);
  }
  const all = list ?? (one === undefined ? [] : [one]);
  return all.length > 0 ? all : fail(name, 'given');
}

/**
 * A job with its key.
 * @throws {FileError} if a file cannot be read
 */
export async function keyed(
  job: Job,
  sha256At: (address: string) => Promise<string>,
): Promise<KeyedJob> {
  const [garmentSha256, printSha256] = [await sha256At(job.garment), await sha256At(job.print)];
  const hashed = {...job, garmentSha256, printSha256};
  return {...hashed, key: keyOf(hashed)};
}

/** The SHA-256 of everything a job's answer depends on. */
function keyOf(job: Omit<KeyedJob, 'key'>): string {
  const {garmentSha256, printSha256, symmetry, method, options, seed, drape, cut, marker} = job;
  const content = sorted({
    ...{garment: garmentSha256, print: printSha256},
    ...{symmetry, method, options, seed, solver: packageVersion},
    ...(drape && {drape}), // an absent field keeps the key of jobs without a drape
    ...(cut && {cut}),
    ...(marker && {marker}),
  });
  return sha256Of(JSON.stringify(content));
}

const hash = text(/^[\da-f]{64}$/, 'a sha256');
const orNull =
  <T>(read: Read<T>): Read<T | null> =>
  (value, at) =>
    value === null ? null : read(value, at);
const keyedFields: Read<KeyedJob> = shape({
  label: shape({name: orNull(word), garment: word, print: word, size: orNull(word)}),
  ...{garment: word, print: word, symmetry: symmetryField, method: oneOf(methods)},
  ...{
    options: object,
    seed: seedField,
    drape: flag,
    cut: orNull(cutFields),
    marker: orNull(layFields),
    key: hash,
    garmentSha256: hash,
    printSha256: hash,
  },
});

/**
 * A job from a queue, to which others can write.
 * @throws {Malformed} if it is invalid or its key does not match
 */
export function checkedJob(value: unknown): KeyedJob {
  if (isTooDeep(value)) throw new Malformed('it is nested too deep');
  const job = keyedFields(value, '');
  return job.key === keyOf(job) ? job : fail('key', "the sha256 of the job's content");
}

/** The value with sorted object keys. */
function sorted(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(sorted);
  if (typeof value !== 'object' || value === null) return value;
  const entries = Object.entries(value).sort(([one], [other]) => (one < other ? -1 : 1));
  return Object.fromEntries(entries.map(([name, entry]) => [name, sorted(entry)]));
}

/** The reason why a line is no job, without its full stop. */
export const complaintAbout = (error: unknown): string | undefined =>
  error instanceof Malformed || error instanceof FileError
    ? error.message.replace(/\.$/, '')
    : undefined;
