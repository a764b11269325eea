/** Reads files from this machine or by HTTP. */
import {resolve} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

import {fetchedBy} from '../model/base/fetched.js';
import {FileError} from '../model/base/versioned-file.js';
import {inputLimit, readBytes, tooLarge} from './files.js';

export interface ReadingLimits {
  readonly signal?: AbortSignal;
  /** Folders and hosts to which reading is restricted; unrestricted without them. */
  readonly within?: readonly URL[];
  /** Time limit for one file. [ms] Default 30 000. */
  readonly timeoutMs?: number;
}

const mostRedirections = 5;

const isWeb = (address: URL): boolean => /^https?:$/.test(address.protocol);

/**
 * A URL unchanged, anything else as a local path.
 * @throws {FileError} for an invalid URL
 */
export function addressOf(word: string): URL {
  if (!/^(https?|file):\/\//i.test(word)) return pathToFileURL(resolve(word));
  if (URL.canParse(word)) return new URL(word);
  throw new FileError(word, 'is not a whole URL; correct it.');
}

/**
 * The address of a folder, as a base for relative addresses.
 * @throws {FileError} for an invalid URL
 */
export function folderOf(word: string): URL {
  const address = addressOf(word);
  if (!address.pathname.endsWith('/')) address.pathname += '/';
  return address;
}

/**
 * The address of a file named in another file.
 * @throws {FileError} if it is invalid, or if a file from the web names a local file
 */
export function addressFrom(base: URL, url: string): URL {
  if (!URL.canParse(url, base.href)) throw new FileError(url, 'is no URL; correct it.');
  const address = new URL(url, base);
  if (isWeb(address) || (address.protocol === 'file:' && !isWeb(base))) return address;
  throw new FileError(
    url,
    'is not on the web, but named from there; put it beside the file that names it.',
  );
}

/** The name of an address in messages. */
export const calledAs = (address: URL): string =>
  address.protocol === 'file:' && address.host === '' ? fileURLToPath(address) : address.href;

/**
 * The bytes at an address.
 * @throws {FileError} with the address and the reason; the signal's reason when it aborts
 */
export async function readAddress(address: URL, limits: ReadingLimits = {}): Promise<Uint8Array> {
  limits.signal?.throwIfAborted();
  checkWithin(address, limits.within);
  if (isWeb(address)) return fetchBytes(address, limits);
  let path: string;
  try {
    path = fileURLToPath(address);
  } catch (cause) {
    throw new FileError(address.href, 'names no file of this machine; correct it.', {cause});
  }
  return readBytes(path, inputLimit, limits.signal);
}

function checkWithin(address: URL, within: ReadingLimits['within']): void {
  if (within === undefined || within.some((place) => isIn(address, place))) return;
  const places = outermost(within).map((one) => (isWeb(one) ? one.origin : calledAs(one)));
  throw new FileError(
    calledAs(address),
    `lies outside of ${places.join(' and ')}, and only there may be read; put it there, or name its folder or host as the base.`,
  );
}

const isIn = (address: URL, {protocol, host, pathname}: URL): boolean =>
  address.protocol === protocol &&
  address.host === host &&
  (isWeb(address) || address.pathname.startsWith(pathname.replace(/\/*$/, '/')));

/** The places that are not inside another one. */
const outermost = (places: readonly URL[]): readonly URL[] =>
  places.reduce<readonly URL[]>(
    (kept, one) =>
      kept.some((other) => isIn(one, other))
        ? kept
        : [...kept.filter((other) => !isIn(other, one)), one],
    [],
  );

/** Follows redirections within the restrictions. */
async function answerOf(
  address: URL,
  within: ReadingLimits['within'],
  signal: AbortSignal,
): Promise<Response> {
  let at = address;
  for (let steps = 0; steps <= mostRedirections; steps++) {
    const response = await fetch(at, {signal, redirect: 'manual'});
    const location = response.headers.get('location');
    if (response.status < 300 || response.status > 399 || location === null) return response;
    await response.body?.cancel();
    at = addressFrom(at, location);
    checkWithin(at, within);
  }
  throw new FileError(address.href, 'is redirected in circles; correct the address.');
}

async function fetchBytes(
  address: URL,
  {signal, timeoutMs = 30_000, within}: ReadingLimits,
): Promise<Uint8Array> {
  const complaint = (what: string, options?: ErrorOptions): FileError =>
    new FileError(address.href, what, options);
  const limits = {signal, timeoutMs, mostBytes: inputLimit};
  const got = await fetchedBy((either) => answerOf(address, within, either), limits);
  switch (got.kind) {
    case 'read':
      return Buffer.concat(got.parts);
    case 'refused':
      throw complaint(
        `cannot be fetched: the server answered ${got.status}; put the file there, or correct the address.`,
      );
    case 'late':
      throw complaint(
        `cannot be fetched: the server did not answer within ${timeoutMs / 1000} s; try again.`,
      );
    case 'tooLarge':
      throw complaint(tooLarge(inputLimit));
    case 'failed': {
      const {cause} = got;
      if (cause instanceof FileError) throw cause;
      const why = `${reasonOf(cause)}; check the address and the connection`;
      throw complaint(`cannot be fetched: ${why}.`, {cause});
    }
  }
}

/** The reason in the cause of fetch's error, such as ECONNREFUSED. */
function reasonOf(error: unknown): string {
  const cause = error instanceof Error ? (error.cause ?? error) : error;
  if (cause instanceof Error) return 'code' in cause ? String(cause.code) : cause.message;
  return String(cause);
}
