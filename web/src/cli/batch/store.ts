/**
 * What has been found so far: one file for each job that has ended, by its key. These files are the truth
 * about a batch; everything else follows from them.
 */
import {mkdir, readdir, readFile, rm, stat} from 'node:fs/promises';
import {join} from 'node:path';

import type {SolveResult} from '../../model/result.js';
import {fileError} from '../../node/files.js';
import {UsageError} from '../arguments.js';
import {writeText} from '../files.js';
import {figuresOf, type JobFailure, type Outcome} from './outcome.js';

export type Status = Outcome['status'];

const kinds: Readonly<Record<Status, string>> = {done: 'results', failed: 'failures'};

/** A draft older than this was left behind by a process that was killed. [ms] */
const greatestDraftAge = 60_000;

export class Store {
  /** Without a slash at its end. */
  readonly folder: string;

  constructor(folder: string) {
    this.folder = folder.replace(/(?<=.)\/+$/, '');
  }

  /** @throws {FileError}, {UsageError} when the folder cannot be used */
  async open(): Promise<void> {
    const existing = await stat(this.folder).catch(() => null);
    if (existing && !existing.isDirectory()) {
      throw new UsageError(`${this.folder} is a file; name a folder for --out.`);
    }
    try {
      for (const kind of Object.values(kinds)) {
        await mkdir(join(this.folder, kind), {recursive: true});
      }
    } catch (error) {
      throw fileError(error, this.folder, 'written');
    }
  }

  /** Where the file of a job lies, counted from the folder. */
  fileOf(key: string, status: Status): string {
    return `${kinds[status]}/${key}.json`;
  }

  /** Every job that has ended. */
  async ended(): Promise<Map<string, Status>> {
    const found = new Map<string, Status>();
    for (const status of ['failed', 'done'] as const) {
      for (const name of await readdir(join(this.folder, kinds[status]))) {
        if (/^[\da-f]{64}\.json$/.test(name)) found.set(name.slice(0, 64), status);
      }
    }
    return found;
  }

  /** How a job ended; undefined when it has not. */
  async outcome(key: string): Promise<Outcome | undefined> {
    const result = await this.#read(key, 'done');
    if (result !== undefined) {
      const metrics = figuresOf(JSON.parse(result) as SolveResult);
      return {status: 'done', metrics, milliseconds: null};
    }
    const record = await this.#read(key, 'failed');
    if (record === undefined) return undefined;
    const failure = JSON.parse(record) as JobFailure;
    return {status: 'failed', failure, milliseconds: null, isFinal: true};
  }

  async #read(key: string, status: Status): Promise<string | undefined> {
    try {
      return await readFile(join(this.folder, this.fileOf(key, status)), 'utf8');
    } catch (error) {
      if (error instanceof Error && 'code' in error && error.code === 'ENOENT') return undefined;
      throw fileError(error, this.fileOf(key, status), 'read');
    }
  }

  /** Whole or not at all. @throws {FileError} */
  write(key: string, status: Status, text: string): Promise<void> {
    return writeText(join(this.folder, this.fileOf(key, status)), text);
  }

  /** Removes the drafts of processes that were killed. @param shared with others, whose drafts are younger */
  async sweep(shared: boolean): Promise<void> {
    for (const kind of Object.values(kinds)) {
      for (const name of await readdir(join(this.folder, kind))) {
        if (!name.endsWith('.tmp')) continue;
        const path = join(this.folder, kind, name);
        const found = await stat(path).catch(() => null);
        const age = found ? Date.now() - found.mtimeMs : 0;
        if (!shared || age > greatestDraftAge) await rm(path, {force: true});
      }
    }
  }
}
