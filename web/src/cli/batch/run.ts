/** Runs a batch. The jobs file is read while the first jobs run. */
import {stat} from 'node:fs/promises';
import {basename, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

import {sha256Of} from '../../model/documents/result-text.js';
import {FileError} from '../../model/base/versioned-file.js';
import {addressOf, calledAs, readAddress} from '../../node/addresses.js';
import type {Crew} from './crew.js';
import {complaintAbout, jobsOf, keyed, type Job, type KeyedJob} from './jobs.js';
import {linesOf, type DoneRecord} from './record.js';
import type {Outcome} from './outcome.js';
import type {Status, Store} from './store.js';

/** Progress of a batch. */
export interface Tally {
  done: number;
  failed: number;
  /** The number of both that this run recorded. */
  now: number;
}

interface Batch {
  readonly jobsFile: string;
  readonly store: Store;
  readonly record: DoneRecord;
  readonly crew: Crew;
  /** Aborts the batch; no further jobs start. */
  readonly signal: AbortSignal;
  readonly onTally: (tally: Readonly<Tally>) => void;
}

interface Listed {
  /** Line number, from 1. */
  readonly line: number;
  readonly entry: Job | {readonly complaint: string};
}

/**
 * The jobs of a file, and the errors of invalid lines.
 * @throws {FileError} if the file cannot be read
 */
export async function* listedIn(jobsFile: string): AsyncGenerator<Listed> {
  const base = new URL('.', pathToFileURL(resolve(jobsFile)));
  for await (const {number: line, text} of linesOf(jobsFile)) {
    if (text?.trim() === '') continue;
    const complain = (what: string): Listed => {
      const complaint = `line ${line} of ${basename(jobsFile)} is no job: ${what}; correct it.`;
      return {line, entry: {complaint}};
    };
    if (text === undefined) {
      yield complain('it is too long');
      continue;
    }
    try {
      for (const entry of jobsOf(text, base)) yield {line, entry};
    } catch (error) {
      const complaint = complaintAbout(error);
      if (complaint === undefined) throw error;
      yield complain(complaint);
    }
  }
}

/**
 * Runs all unfinished jobs.
 * @throws {FileError} if files cannot be read or written
 * @throws {Error} if a result cannot be written
 */
export async function runBatch(batch: Batch): Promise<Tally> {
  const run = new BatchRun(batch, await batch.store.ended());
  await run.all();
  return run.tally;
}

class BatchRun {
  readonly tally: Tally = {done: 0, failed: 0, now: 0};
  readonly #batch: Batch;
  readonly #ended: Map<string, Status>;
  /** Running jobs by key; equal jobs in other lines share their answer. */
  readonly #atWork = new Map<string, Promise<Outcome>>();
  readonly #hashes = new Map<string, Promise<string>>();
  /** The error that ends the batch. */
  #broken: {readonly cause: unknown} | undefined;

  constructor(batch: Batch, ended: Map<string, Status>) {
    this.#batch = batch;
    this.#ended = ended;
  }

  async all(): Promise<void> {
    const {jobsFile, crew, signal} = this.#batch;
    const begun = new Set<Promise<void>>();
    for await (const listed of listedIn(jobsFile)) {
      if (signal.aborted || this.#broken) break;
      const one = this.#handle(listed)
        .catch((cause: unknown) => {
          this.#broken ??= {cause};
        })
        .finally(() => begun.delete(one));
      begun.add(one);
      if (begun.size >= crew.atOnce) await Promise.race(begun);
    }
    await Promise.all(begun);
    if (this.#broken && !signal.aborted) throw this.#broken.cause;
  }

  async #handle({line, entry}: Listed): Promise<void> {
    const {record, signal} = this.#batch;
    if ('complaint' in entry) {
      await record.addFailed(line, null, failureOf('bad-line', entry.complaint));
      this.#count('failed', true);
      return;
    }
    const job = await this.#keyed(entry);
    if ('message' in job) {
      await record.addFailed(line, entry.label, failureOf('not-found', job.message));
      this.#count('failed', true);
      return;
    }
    const ended = this.#ended.get(job.key);
    if (ended !== undefined && record.take(job.key, job.label)) {
      this.#count(ended, false);
      return;
    }
    const outcome = await this.#outcome(job);
    if (signal.aborted && !this.#ended.has(job.key)) return; // the job was aborted
    await record.add(job.key, job.label, outcome);
    this.#count(outcome.status, true);
  }

  async #keyed(job: Job): Promise<KeyedJob | {readonly message: string}> {
    try {
      return await keyed(job, (address) => this.#sha256At(address));
    } catch (error) {
      const complaint = complaintAbout(error);
      if (complaint === undefined) throw error;
      return {message: `${complaint}.`};
    }
  }

  #sha256At(address: string): Promise<string> {
    const known = this.#hashes.get(address);
    if (known) return known;
    const reading = this.#bytesAt(addressOf(address)).then(sha256Of);
    this.#hashes.set(address, reading);
    return reading;
  }

  async #bytesAt(address: URL): Promise<Uint8Array> {
    const path = calledAs(address);
    const found = address.protocol === 'file:' ? await stat(path).catch(() => null) : null;
    if (found?.isFIFO()) {
      throw new FileError(path, 'is a pipe, which can be read only once; name a file.');
    }
    return readAddress(address, {signal: this.#batch.signal});
  }

  async #outcome(job: KeyedJob): Promise<Outcome> {
    if (this.#ended.has(job.key)) {
      const found = await this.#batch.store.outcome(job.key);
      if (found) return found;
    }
    const atWork = this.#atWork.get(job.key) ?? this.#solve(job);
    return atWork;
  }

  #solve(job: KeyedJob): Promise<Outcome> {
    const solving = this.#batch.crew.run(job).then((outcome) => {
      if (outcome.status === 'done' || outcome.isFinal) this.#ended.set(job.key, outcome.status);
      return outcome;
    });
    this.#atWork.set(job.key, solving);
    const forget = () => this.#atWork.delete(job.key);
    solving.then(forget, forget);
    return solving;
  }

  #count(status: Status, isNew: boolean): void {
    this.tally[status] += 1;
    if (isNew) this.tally.now += 1;
    this.#batch.onTally(this.tally);
  }
}

const failureOf = (code: 'bad-line' | 'not-found', message: string) => ({
  ...{code, message, piece: null, seam: null},
});
