/** Reads the element's files once, within limits, with a message of one sentence for each error. */
import {SolverError, type FailureCode} from '../../model/result/failure.js';
import {fetchedBy} from '../../model/base/fetched.js';
import {sha256Of} from '../../model/documents/result-text.js';
import type {StoredFile} from '../../model/design/design.js';
import type {Texts} from '../../texts/texts.js';

export type FileWords = Texts['garment'];

/** Limit for a whole file. [ms] */
const patience = 30_000;
const megabyte = 2 ** 20;
/** Limits of an image file and of JSON; the solver reads no more than that. [MB] */
const most = {picture: 64, text: 20};

interface ReadFile {
  readonly place: StoredFile;
  readonly text: string;
}

const failure = (code: FailureCode, message: string): SolverError =>
  new SolverError({code, message});

/**
 * @throws {SolverError} `not-found`, `network`, `timeout`, `too-large`; the signal's reason when it
 * fires
 */
export async function fetchBlob(
  url: string,
  words: FileWords,
  signal?: AbortSignal,
  kind: keyof typeof most = 'picture',
): Promise<Blob> {
  const fetched = await fetchedBy(
    (either) => fetch(url, {credentials: 'same-origin', signal: either}),
    {signal, timeoutMs: patience, mostBytes: most[kind] * megabyte},
  );
  switch (fetched.kind) {
    case 'read':
      return new Blob(fetched.parts, {type: fetched.type});
    case 'refused':
      throw refused(url, fetched.status, words);
    case 'late':
      throw failure('timeout', words.timeout(url, String(patience / 1000)));
    case 'tooLarge':
      throw failure('too-large', words.tooLarge(url, `${most[kind]} MB`));
    case 'failed': {
      const {cause} = fetched;
      throw failure('network', words.network(url, cause instanceof Error ? cause.message : '?'));
    }
  }
}

const refused = (url: string, status: number, words: FileWords): SolverError =>
  status >= 400 && status < 500
    ? failure('not-found', words.notFound(url))
    : failure('network', words.network(url, `HTTP ${status}`));

/** @throws {SolverError} the errors of `fetchBlob` */
export async function fetchText(
  url: string,
  words: FileWords,
  signal: AbortSignal,
): Promise<ReadFile> {
  const bytes = new Uint8Array(await (await fetchBlob(url, words, signal, 'text')).arrayBuffer());
  return {place: {url, sha256: sha256Of(bytes)}, text: new TextDecoder().decode(bytes)};
}
