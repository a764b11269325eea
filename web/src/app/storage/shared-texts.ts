/**
 * Separates long texts from the data that contains them, each once: most steps of a history share
 * the same garment.
 */

import {digestOf} from '../../model/base/digest.js';
import {fieldOf} from '../../model/base/read.js';

/** Length below which a text stays in place. [characters] */
const longText = 1000;
/** The only field of an object that replaces a text. */
const mark = 'seamwise-text';

interface Packed {
  readonly data: unknown;
  /** Texts by the SHA-256 of their content. */
  readonly texts: ReadonlyMap<string, string>;
}

const isPlain = (value: object): value is Readonly<Record<string, unknown>> =>
  Object.getPrototypeOf(value) === Object.prototype;

/**
 * Returns data with its leaves replaced, and any other parts that `leaf` changes; shared parts stay
 * shared.
 */
function replaced(value: unknown, leaf: (value: unknown) => unknown): unknown {
  const known = new Map<unknown, unknown>();
  const visit = (part: unknown): unknown => {
    if (typeof part !== 'object' || part === null) return leaf(part);
    const before = known.get(part);
    if (before !== undefined) return before;
    const found = leaf(part);
    const made = found === part ? within(part) : found;
    known.set(part, made);
    return made;
  };
  const within = (part: object): unknown => {
    if (Array.isArray(part)) return part.map(visit);
    if (!isPlain(part)) return part;
    return Object.fromEntries(Object.entries(part).map(([name, inner]) => [name, visit(inner)]));
  };
  return visit(value);
}

export async function packed(value: unknown): Promise<Packed> {
  const long = new Set<string>();
  replaced(value, (leaf) => {
    if (typeof leaf === 'string' && leaf.length >= longText) long.add(leaf);
    return leaf;
  });
  const hashes = new Map(
    await Promise.all([...long].map(async (text) => [text, await digestOf(text)] as const)),
  );
  const data = replaced(value, (leaf) => {
    const hash = typeof leaf === 'string' ? hashes.get(leaf) : undefined;
    return hash === undefined ? leaf : {[mark]: hash};
  });
  return {data, texts: new Map([...hashes].map(([text, hash]) => [hash, text]))};
}

/** Inverse of `packed`. A missing text is empty. */
export const unpacked = ({data, texts}: Packed): unknown =>
  replaced(data, (leaf) => {
    const hash: unknown = fieldOf(leaf, mark);
    return typeof hash === 'string' ? (texts.get(hash) ?? '') : leaf;
  });
