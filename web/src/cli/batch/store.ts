/**
 * What has been found so far: one file for each job that has ended, by its key. These files are the truth
 * about a batch; everything else follows from them.
 */
import {mkdir, readdir, readFile, rm, stat} from 'node:fs/promises';
import {join} from 'node:path';

import {fieldOf} from '../../model/read.js';
import {sha256Of} from '../../model/result-text.js';
import type {SolveResult} from '../../model/result.js';
import {fileError} from '../../node/files.js';
import {UsageError} from '../base/arguments.js';
import {writeWhole} from '../base/files.js';
import {figuresOf, type JobFailure, type Outcome} from './outcome.js';

export type Status = Outcome['status'];

const kinds: Readonly<Record<Status, string>> = {done: 'results', failed: 'failures'};

const isKey = (word: string): boolean => /^[\da-f]{64}$/.test(word);

function parsed(text: string | undefined): unknown {
  try {
    return text === undefined ? undefined : JSON.parse(text);
  } catch {
    return undefined;
  }
}

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
    if (!isKey(key)) throw new Error(`'${key}' is no key of a job.`); // nor part of a path
    return `${kinds[status]}/${key}.json`;
  }

  /** Every job that has ended. An empty file, as some broken disks leave them, is no end. */
  async ended(): Promise<Map<string, Status>> {
    const found = new Map<string, Status>();
    for (const status of ['failed', 'done'] as const) {
      const keys = await this.#keys(status);
      for (let k = 0; k < keys.length; k += 100) {
        const some = keys.slice(k, k + 100);
        const sizes = await Promise.all(some.map((key) => this.#size(key, status)));
        for (const [n, key] of some.entries()) if (sizes[n] !== 0) found.set(key, status);
      }
    }
    return found;
  }

  async #keys(status: Status): Promise<readonly string[]> {
    const names = await readdir(join(this.folder, kinds[status]));
    return names
      .filter((name) => name.endsWith('.json') && isKey(name.slice(0, -5)))
      .map((name) => name.slice(0, -5));
  }

  async #size(key: string, status: Status): Promise<number> {
    return (await stat(join(this.folder, this.fileOf(key, status)))).size;
  }

  /** Lets jobs be tried again that took too long. */
  async forgetTimeouts(): Promise<void> {
    for (const key of await this.#keys('failed')) {
      const outcome = await this.outcome(key);
      if (outcome?.status === 'failed' && outcome.failure.code === 'timeout') {
        await rm(join(this.folder, this.fileOf(key, 'failed')), {force: true});
      }
    }
  }

  /** Whether the result of a job is what it was; if not, it goes, and the job is solved again. */
  async check(key: string, sha256: string): Promise<boolean> {
    const result = await this.#read(key, 'done');
    if (result !== undefined && sha256Of(result) === sha256) return true;
    await rm(join(this.folder, this.fileOf(key, 'done')), {force: true});
    return false;
  }

  /** How a job ended; undefined when it has not, or when its file is damaged: it is solved again then. */
  async outcome(key: string): Promise<Outcome | undefined> {
    const text = await this.#read(key, 'done');
    const result = parsed(text);
    if (text !== undefined && typeof fieldOf(result, 'metrics') === 'object') {
      const metrics = figuresOf(result as SolveResult);
      return {status: 'done', metrics, sha256: sha256Of(text), milliseconds: null};
    }
    const failure = parsed(await this.#read(key, 'failed'));
    if (typeof fieldOf(failure, 'code') !== 'string') return undefined;
    return {
      ...{status: 'failed', failure: failure as JobFailure},
      ...{milliseconds: null, isFinal: true},
    };
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
    return writeWhole(join(this.folder, this.fileOf(key, status)), text);
  }

  /** What is written beside the result of a job, before that: whole or not at all. @throws {FileError} */
  writeBeside(key: string, ending: string, content: string | Uint8Array): Promise<void> {
    const result = this.fileOf(key, 'done');
    return writeWhole(join(this.folder, result.replace(/\.json$/, ending)), content);
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
