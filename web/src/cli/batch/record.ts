/** The record `done.ndjson`: one line per finished job, in order of completion. */
import {createReadStream, createWriteStream} from 'node:fs';
import {join} from 'node:path';
import {open, rename, rm, type FileHandle} from 'node:fs/promises';
import {pipeline} from 'node:stream/promises';

import {fieldOf} from '../../model/base/read.js';
import {sha256Of} from '../../model/documents/result-text.js';
import {fileError} from '../../node/files.js';
import type {Label} from './jobs.js';
import type {JobFailure, Outcome} from './outcome.js';
import type {Status, Store} from './store.js';

export class DoneRecord {
  readonly #store: Store;
  readonly #path: string;
  #file: FileHandle | undefined;
  /** Number of lines per key and label. */
  readonly #lines = new Map<string, number>();
  /** The last pending write. */
  #written: Promise<unknown> = Promise.resolve();

  constructor(store: Store) {
    this.#store = store;
    this.#path = join(store.folder, 'done.ndjson');
  }

  /**
   * Keeps earlier lines whose jobs are done. Removes incomplete lines after a crash, and lines of
   * jobs without a file, which are tried again.
   * @param isSound checks each successful job against its recorded SHA-256
   * @throws {FileError} if the record cannot be written
   */
  async open(
    ended: ReadonlyMap<string, Status>,
    isSound: (key: string, sha256: string) => Promise<boolean> = () => Promise.resolve(true),
  ): Promise<void> {
    const draft = `${this.#path}.tmp`;
    try {
      const earlier = await open(this.#path, 'a'); // creates the file if it is missing
      await earlier.close();
      await pipeline(() => this.#kept(ended, isSound), createWriteStream(draft, {flush: true}));
      await rename(draft, this.#path);
      this.#file = await open(this.#path, 'a');
    } catch (error) {
      throw fileError(error, this.#path, 'written');
    } finally {
      await rm(draft, {force: true});
    }
  }

  async *#kept(
    ended: ReadonlyMap<string, Status>,
    isSound: (key: string, sha256: string) => Promise<boolean>,
  ): AsyncGenerator<string> {
    for await (const {text, isWhole} of linesOf(this.#path)) {
      const line = text === undefined || !isWhole ? undefined : parsed(text);
      const key = fieldOf(line, 'key');
      if (typeof key !== 'string' || ended.get(key) !== fieldOf(line, 'status')) continue;
      const sha256 = fieldOf(line, 'sha256');
      if (typeof sha256 === 'string' && !(await isSound(key, sha256))) continue;
      this.#count(key, line as Label);
      yield `${text ?? ''}\n`;
    }
  }

  #count(key: string, label: Label): void {
    const identity = identityOf(key, label);
    this.#lines.set(identity, (this.#lines.get(identity) ?? 0) + 1);
  }

  /** Consumes one earlier line of a job, if there is one. */
  take(key: string, label: Label): boolean {
    const identity = identityOf(key, label);
    const left = this.#lines.get(identity) ?? 0;
    if (left === 1) this.#lines.delete(identity);
    else if (left > 1) this.#lines.set(identity, left - 1);
    return left > 0;
  }

  /**
   * Adds a finished job.
   * @throws {FileError} if the record cannot be written
   */
  add(key: string, label: Label, outcome: Outcome): Promise<void> {
    const {status, milliseconds} = outcome;
    const isFiled = status === 'done' || outcome.isFinal;
    return this.#append({
      ...{key, ...label, status},
      ...(status === 'done'
        ? {metrics: outcome.metrics, sha256: outcome.sha256}
        : {failure: outcome.failure}),
      milliseconds,
      file: isFiled ? this.#store.fileOf(key, status) : null,
    });
  }

  /**
   * Adds a line that is no job, or a job with unreadable files.
   * @throws {FileError} if the record cannot be written
   */
  addFailed(line: number, label: Label | null, failure: JobFailure): Promise<void> {
    return this.#append({key: null, line, ...label, status: 'failed', failure, file: null});
  }

  #append(content: object): Promise<void> {
    const write = this.#written.then(() => this.#file?.appendFile(`${JSON.stringify(content)}\n`));
    this.#written = write.catch(() => undefined);
    return write.catch((error: unknown) => {
      throw fileError(error, this.#path, 'written');
    });
  }

  async close(): Promise<void> {
    await this.#written;
    await this.#file?.sync();
    await this.#file?.close();
  }
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

/** Shortened, since there is one per line. */
const identityOf = (key: string, {name, garment, print, size}: Label): string =>
  sha256Of(JSON.stringify([key, name, garment, print, size])).slice(0, 32);

// Reads a file line by line, with bounded memory.

/** Greatest line length, above that of a job with pins for every piece. [characters] */
const greatestLength = 1_000_000;

interface Line {
  /** Counted from 1. */
  readonly number: number;
  /** Undefined if the line is too long. */
  readonly text: string | undefined;
  /** True if the line ends in a line break. */
  readonly isWhole: boolean;
}

/**
 * The lines of a file.
 * @throws {FileError} if the file cannot be read
 */
export async function* linesOf(path: string): AsyncGenerator<Line> {
  let [number, rest, isTooLong] = [1, '', false];
  const end = (isWhole: boolean): Line => {
    const text = isTooLong ? undefined : number === 1 ? rest.replace(/^\ufeff/, '') : rest;
    const line = {number, text, isWhole};
    [number, rest, isTooLong] = [number + 1, '', false];
    return line;
  };
  const take = (part: string) => {
    if (rest.length + part.length > greatestLength) [rest, isTooLong] = ['', true];
    else if (!isTooLong) rest += part;
  };
  try {
    for await (const chunk of createReadStream(path, 'utf8') as AsyncIterable<string>) {
      const parts = chunk.split('\n');
      for (const part of parts.slice(0, -1)) {
        take(part);
        yield end(true);
      }
      take(parts.at(-1) ?? '');
    }
  } catch (error) {
    throw fileError(error, path, 'read');
  }
  if (rest !== '' || isTooLong) yield end(false);
}
