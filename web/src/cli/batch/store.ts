/** Stores one file per finished job, by its key. These files alone define the state of a batch. */
import {mkdir, readdir, readFile, rm, stat} from 'node:fs/promises';
import {join} from 'node:path';

import {fieldOf} from '../../model/base/read.js';
import {sha256Of} from '../../model/documents/result-text.js';
import type {SolveResult} from '../../model/result/result.js';
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

/** Age of drafts that a killed process left behind. [ms] */
const greatestDraftAge = 60_000;

export class Store {
  /** Without a trailing slash. */
  readonly folder: string;

  constructor(folder: string) {
    this.folder = folder.replace(/(?<=.)\/+$/, '');
  }

  /**
   * Creates the folders if they are missing.
   * @throws {FileError} if the folder cannot be written
   * @throws {UsageError} if it is a file
   */
  async open(): Promise<void> {
    const existing = await stat(this.folder).catch(() => null);
    if (existing && !existing.isDirectory()) {
      throw new UsageError(`${this.folder} is a file; name a folder for --out.`);
    }
    for (const kind of Object.values(kinds)) {
      const folder = join(this.folder, kind);
      try {
        await mkdir(folder, {recursive: true});
      } catch (error) {
        throw fileError(error, folder, 'written');
      }
    }
  }

  /** The path of a job's file, relative to the folder. */
  fileOf(key: string, status: Status): string {
    if (!isKey(key)) throw new Error(`'${key}' is no key of a job.`); // also excludes other paths
    return `${kinds[status]}/${key}.json`;
  }

  /** All finished jobs. Empty files, which some broken disks leave, do not count. */
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

  /** Removes the outcomes of jobs that timed out, so that they run again. */
  async forgetTimeouts(): Promise<void> {
    for (const key of await this.#keys('failed')) {
      const outcome = await this.outcome(key);
      if (outcome?.status === 'failed' && outcome.failure.code === 'timeout') {
        await rm(join(this.folder, this.fileOf(key, 'failed')), {force: true});
      }
    }
  }

  /**
   * Returns whether a result matches its hash. Removes it otherwise, so that the job runs again.
   */
  async check(key: string, sha256: string): Promise<boolean> {
    const result = await this.#read(key, 'done');
    if (result !== undefined && sha256Of(result) === sha256) return true;
    await rm(join(this.folder, this.fileOf(key, 'done')), {force: true});
    return false;
  }

  /**
   * The outcome of a job; undefined if it is unfinished or its file is damaged, so that it runs
   * again.
   */
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

  /**
   * Writes a file atomically.
   * @throws {FileError} if it cannot be written
   */
  write(key: string, status: Status, text: string): Promise<void> {
    return writeWhole(join(this.folder, this.fileOf(key, status)), text);
  }

  /**
   * Atomically writes a file beside a job's result, before the result itself.
   * @throws {FileError} if it cannot be written
   */
  writeBeside(key: string, ending: string, content: string | Uint8Array): Promise<void> {
    const result = this.fileOf(key, 'done');
    return writeWhole(join(this.folder, result.replace(/\.json$/, ending)), content);
  }

  /**
   * Removes the drafts of killed processes.
   * @param shared keeps recent drafts, which may belong to other processes
   */
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
