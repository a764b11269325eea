/** Files that the element is pointed at: read once, within limits, and with a sentence for all that goes wrong. */
import {SolverError, type FailureCode} from '../../model/failure.js';
import {sha256Of} from '../../model/result-text.js';
import type {StoredFile} from '../../model/stored-file.js';
import type {Texts} from '../../texts/texts.js';

export type FileWords = Texts['garment'];

/** For a file as a whole. [ms] */
const patience = 30_000;
const megabyte = 2 ** 20;
/** Of a picture as it is stored, and of JSON, of which the solver reads no more. [MB] */
const most = {picture: 64, text: 20};

export interface ReadFile {
  readonly place: StoredFile;
  readonly text: string;
}

const failure = (code: FailureCode, message: string): SolverError =>
  new SolverError({code, message});

/** @throws {SolverError} `not-found`, `network`, `timeout`, `too-large`; the signal's reason when it fires */
export async function fetchBlob(
  url: string,
  words: FileWords,
  signal?: AbortSignal,
  kind: keyof typeof most = 'picture',
): Promise<Blob> {
  signal?.throwIfAborted();
  const late = new AbortController();
  const clock = setTimeout(() => {
    late.abort();
  }, patience);
  try {
    const either = signal ? AbortSignal.any([signal, late.signal]) : late.signal;
    const response = await fetch(url, {credentials: 'same-origin', signal: either});
    if (!response.ok) throw refused(url, response.status, words);
    return await limited(url, response, words, most[kind]);
  } catch (error) {
    signal?.throwIfAborted();
    if (error instanceof SolverError) throw error;
    if (late.signal.aborted) {
      throw failure('timeout', words.timeout(url, String(patience / 1000)));
    }
    throw failure('network', words.network(url, error instanceof Error ? error.message : '?'));
  } finally {
    clearTimeout(clock);
  }
}

const refused = (url: string, status: number, words: FileWords): SolverError =>
  status >= 400 && status < 500
    ? failure('not-found', words.notFound(url))
    : failure('network', words.network(url, `HTTP ${status}`));

async function limited(
  url: string,
  response: Response,
  words: FileWords,
  megabytes: number,
): Promise<Blob> {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let size = Number(response.headers.get('Content-Length') ?? 0);
  let read = 0;
  const reader = response.body?.getReader();
  for (;;) {
    if (Math.max(size, read) > megabytes * megabyte) {
      void reader?.cancel().catch(() => undefined);
      throw failure('too-large', words.tooLarge(url, `${megabytes} MB`));
    }
    size = 0;
    const next = await reader?.read();
    if (!next || next.done) break;
    parts.push(next.value);
    read += next.value.length;
  }
  return new Blob(parts, {type: response.headers.get('Content-Type') ?? ''});
}

/** @throws {SolverError} as `fetchBlob` does */
export async function fetchText(
  url: string,
  words: FileWords,
  signal: AbortSignal,
): Promise<ReadFile> {
  const bytes = new Uint8Array(await (await fetchBlob(url, words, signal, 'text')).arrayBuffer());
  return {place: {url, sha256: sha256Of(bytes)}, text: new TextDecoder().decode(bytes)};
}
