import {stat} from 'node:fs/promises';
import {availableParallelism} from 'node:os';

import {fileError} from '../../node/files.js';
import {parseArguments, UsageError, wholeNumber, type Arguments} from '../base/arguments.js';
import {print, remark} from '../base/terminal.js';
import {Threads, type Crew} from './crew.js';
import {lockFolder} from './lock.js';
import {BatchProgress} from './progress.js';
import {queueAt, QueueCrew, QueueWorker} from './queue.js';
import {DoneRecord} from './record.js';
import {runBatch, type Tally} from './run.js';
import {Store} from './store.js';

const grammar = {
  files: ['the file of jobs'],
  valued: ['--out', '--workers', '--queue', '--job-timeout'],
  switches: ['--json', '--check', '--retry-timeouts'],
};
const workGrammar = {files: [], valued: grammar.valued, switches: ['--work']};

const mostWorkers = 256;
/** Default time limit of a job, far above the need of any garment. [s] */
const usualTimeout = 600;
/** Greatest delay of a timer. [s] */
const greatestTimeout = 2_000_000;
/** Exit code of an interrupted program, by shell convention. */
const interruptedCode = 130;

/** `batch`: solves every job of a file on all cores, and resumes an interrupted run. */
export async function batch(words: readonly string[]): Promise<void> {
  const isWork = words.includes('--work');
  const args = parseArguments(words, isWork ? workGrammar : grammar);
  const out = args.value('--out');
  if (out === undefined) throw new UsageError('--out FOLDER is missing.');
  const interruption = new AbortController();
  const interrupt = () => {
    interruption.abort();
  };
  for (const name of ['SIGINT', 'SIGTERM'] as const) process.once(name, interrupt);
  const store = new Store(out);
  await (isWork ? work(args, store, interruption.signal) : lead(args, store, interruption.signal));
  // an explicit exit, since the connection to a missing server retries forever
  if (interruption.signal.aborted) process.exit(interruptedCode);
}

function workersOf(args: Arguments): number {
  const least = args.value('--queue') === undefined || args.has('--work') ? 1 : 0;
  const count = wholeNumber(args, '--workers') ?? availableParallelism();
  if (count >= least && count <= mostWorkers) return count;
  throw new UsageError(`--workers is ${count}, but must be from ${least} to ${mostWorkers}.`);
}

function timeoutOf(args: Arguments): number {
  const timeout = wholeNumber(args, '--job-timeout') ?? usualTimeout;
  if (timeout <= greatestTimeout) return timeout;
  throw new UsageError(
    `--job-timeout is ${timeout}, but must be from 1 to ${greatestTimeout} seconds, or 0 for none.`,
  );
}

/** Solves jobs from a queue until it is interrupted. */
async function work(args: Arguments, store: Store, signal: AbortSignal): Promise<void> {
  const url = args.value('--queue');
  if (url === undefined) throw new UsageError('--work belongs to --queue, which is missing.');
  const count = workersOf(args);
  const timeout = timeoutOf(args);
  await store.open();
  const place = await queueAt(url, store);
  const worker = new QueueWorker(place, new Threads(store, count, timeout), count);
  await new Promise<void>((resolve) => {
    if (signal.aborted) resolve();
    signal.addEventListener('abort', () => {
      resolve();
    });
  });
  await worker.close();
}

/** Reads the jobs and keeps the record. */
async function lead(args: Arguments, store: Store, signal: AbortSignal): Promise<void> {
  const [jobsFile = ''] = args.files;
  const count = workersOf(args);
  const [url, timeout] = [args.value('--queue'), timeoutOf(args)];
  await checkJobs(jobsFile);
  await store.open();
  const unlock = await lockFolder(store.folder);
  const started = performance.now();
  const progress = new BatchProgress();
  let tally: Tally;
  try {
    await store.sweep(url !== undefined);
    if (args.has('--retry-timeouts')) await store.forgetTimeouts();
    const record = new DoneRecord(store);
    await record.open(await store.ended(), args.has('--check') ? checkIn(store) : undefined);
    if (progress.isShown) await progress.expect(jobsFile);
    const crew = await crewFor(url, store, count, timeout);
    const leave = () => void crew.close();
    signal.addEventListener('abort', leave);
    if (signal.aborted) leave();
    try {
      const onTally = (now: Readonly<Tally>) => {
        progress.show(now);
      };
      tally = await runBatch({jobsFile, store, record, crew, signal, onTally});
    } finally {
      await crew.close();
      await record.close();
    }
    if (signal.aborted) await store.sweep(url !== undefined);
  } finally {
    progress.clear();
    await unlock();
  }
  report(args, store, tally, performance.now() - started);
  if (signal.aborted) remark('the batch was interrupted; the same command goes on from there.');
  else if (tally.failed > 0) process.exitCode = 1;
}

/** Checks that results still match their recorded hash. */
const checkIn =
  (store: Store) =>
  async (key: string, sha256: string): Promise<boolean> => {
    if (await store.check(key, sha256)) return true;
    const file = `${store.folder}/${store.fileOf(key, 'done')}`;
    remark(`${file} is not what it was when it was written; it is solved again.`);
    return false;
  };

/**
 * @throws {UsageError} if the path is no file
 * @throws {FileError} if it cannot be read
 */
async function checkJobs(path: string): Promise<void> {
  const found = await stat(path).catch((error: unknown) => {
    throw fileError(error, path, 'read');
  });
  if (!found.isFile()) throw new UsageError(`${path} is no file; name a file with one job a line.`);
}

/** Threads of this process; with a queue, any of its workers, including threads of this process. */
async function crewFor(
  url: string | undefined,
  store: Store,
  count: number,
  timeout: number,
): Promise<Crew> {
  if (url === undefined) return new Threads(store, count, timeout);
  const place = await queueAt(url, store);
  if (count === 0) return QueueCrew.open(place, store);
  const worker = new QueueWorker(place, new Threads(store, count, timeout), count);
  return QueueCrew.open(place, store, worker);
}

function report(args: Arguments, {folder}: Store, tally: Tally, milliseconds: number): void {
  const {done, failed, now} = tally;
  if (args.has('--json')) {
    print(JSON.stringify({out: folder, done, failed, now, milliseconds: Math.round(milliseconds)}));
    return;
  }
  const seconds = milliseconds / 1000;
  print(
    `${folder}: ${done} done, ${failed} failed; ${now} of them now, in ${seconds.toFixed(1)} s; see ${folder}/done.ndjson`,
  );
}
