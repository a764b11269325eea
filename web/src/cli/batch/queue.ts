/** Distributes jobs over several processes and machines with Redis. */
import {randomUUID} from 'node:crypto';
import {link, readFile, rm, writeFile} from 'node:fs/promises';
import {join} from 'node:path';
import {setTimeout as sleep} from 'node:timers/promises';

import type {Job as QueuedJob, Queue, QueueEvents, Worker} from 'bullmq';
import type {Redis} from 'ioredis';

import {packageVersion} from '../../model/base/version.js';
import {UsageError} from '../base/arguments.js';
import type {Crew, Threads} from './crew.js';
import {checkedJob, complaintAbout, type KeyedJob} from './jobs.js';
import {failedFor, type Outcome} from './outcome.js';
import type {Store} from './store.js';

interface Packages {
  readonly bullmq: typeof import('bullmq');
  readonly Redis: typeof Redis;
}

/** Lifetime of a job's lock, which its worker renews at half of it. [ms] */
const patience = 5000;
/** Number of lost workers after which a job fails. */
const mostLosses = 10;
/** Interval of looking for outcomes on disk, for lost events. [ms] */
const lookEvery = 5000;

/** Queue of one folder and version, so that workers solve only the jobs of their batch. */
interface QueuePlace {
  readonly packages: Packages;
  readonly url: string;
  readonly name: string;
}

/**
 * Connects to the queue of a folder.
 * @throws {UsageError} if packages are missing or the server is unreachable
 */
export async function queueAt(url: string, store: Store): Promise<QueuePlace> {
  if (!/^rediss?:\/\//.test(url) || !URL.canParse(url)) {
    throw new UsageError(`--queue is '${url}', but must be redis://HOST:PORT[/DB].`);
  }
  const packages = await optionalPackages();
  await checkServer(packages, url);
  return {packages, url, name: `seamwise-${packageVersion}-${await idOf(store)}`};
}

async function optionalPackages(): Promise<Packages> {
  try {
    const {Redis: Client} = await import('ioredis');
    return {bullmq: await import('bullmq'), Redis: Client};
  } catch (error) {
    if (!(error instanceof Error && 'code' in error && error.code === 'ERR_MODULE_NOT_FOUND')) {
      throw error;
    }
    throw new UsageError(
      '--queue needs two packages more; install them with: npm install bullmq ioredis.',
    );
  }
}

async function checkServer({Redis: Client}: Packages, url: string): Promise<void> {
  const settings = {lazyConnect: true, retryStrategy: () => null, connectTimeout: 5000};
  const client = new Client(url, settings);
  let reason = '';
  client.on(
    'error',
    (error) => (reason = ('code' in error && String(error.code)) || error.message),
  );
  try {
    await client.connect();
    await client.ping();
  } catch (error) {
    if (reason === '') reason = error instanceof Error ? error.message : String(error);
    throw new UsageError(
      `the Redis server at ${new URL(url).host} cannot be used (${reason}); start it, or correct --queue.`,
    );
  } finally {
    client.disconnect();
  }
}

/** An identifier of the folder, independent of machine and path. */
async function idOf({folder}: Store): Promise<string> {
  const file = join(folder, 'queue-id');
  const draft = `${file}.${randomUUID()}`;
  await writeFile(draft, randomUUID());
  try {
    await link(draft, file).catch((error: unknown) => {
      if (!(error instanceof Error && 'code' in error && error.code === 'EEXIST')) throw error;
    });
  } finally {
    await rm(draft, {force: true});
  }
  return readFile(file, 'utf8');
}

/** Takes jobs from a queue and solves them on threads. */
export class QueueWorker {
  readonly #client: Redis;
  readonly #worker: Worker<KeyedJob, Outcome>;
  readonly #threads: Threads;
  #isClosing = false;

  constructor({packages, url, name}: QueuePlace, threads: Threads, count: number) {
    this.#threads = threads;
    this.#client = connection(packages, url);
    const solve = async ({data}: QueuedJob<KeyedJob, Outcome>) => {
      const outcome = await this.#outcome(data);
      if (!this.#isClosing || outcome.status === 'done' || outcome.isFinal) return outcome;
      return new Promise<never>(() => undefined); // another worker takes over the aborted job
    };
    this.#worker = new packages.bullmq.Worker<KeyedJob, Outcome>(name, solve, {
      connection: this.#client,
      concurrency: count,
      ...{lockDuration: patience, stalledInterval: patience / 2, maxStalledCount: mostLosses},
      ...{removeOnComplete: {count: 0}, removeOnFail: {count: 0}},
    });
    this.#worker.on('error', ignore); // the client reconnects, or the lock passes to another worker
  }

  async #outcome(data: unknown): Promise<Outcome> {
    let job: KeyedJob;
    try {
      job = checkedJob(data);
    } catch (error) {
      const complaint = complaintAbout(error);
      if (complaint === undefined) throw error;
      return failedFor('bad-line', `What came from the queue is no job: ${complaint}.`);
    }
    return this.#threads.run(job);
  }

  /** Closes within about a second. Other workers take over unfinished jobs. */
  async close(): Promise<void> {
    this.#isClosing = true;
    await inTime(this.#worker.pause(true)); // takes no more jobs
    await this.#threads.close();
    await sleep(50); // lets finished jobs report their outcome
    await inTime(this.#worker.close(true));
    this.#client.disconnect();
  }
}

/** Adds jobs to a queue and waits for their outcomes. */
export class QueueCrew implements Crew {
  /** Enough jobs for many machines; the rest stays in the file. */
  readonly atOnce = 1000;
  readonly #store: Store;
  readonly #clients: readonly Redis[];
  readonly #queue: Queue<KeyedJob, Outcome>;
  readonly #events: QueueEvents;
  readonly #pending = new Map<string, {job: KeyedJob; settle: (outcome: Outcome) => void}>();
  readonly #looking: NodeJS.Timeout;
  readonly #worker: QueueWorker | undefined;
  #isLooking = false;
  #closing: Promise<void> | undefined;

  private constructor(place: QueuePlace, store: Store, worker: QueueWorker | undefined) {
    const {packages, url, name} = place;
    this.#store = store;
    this.#worker = worker;
    const [first, second] = [connection(packages, url), connection(packages, url)];
    this.#clients = [first, second];
    this.#queue = new packages.bullmq.Queue(name, {
      connection: first,
      streams: {events: {maxLen: 2000}},
    });
    this.#events = new packages.bullmq.QueueEvents(name, {connection: second});
    this.#queue.on('error', ignore);
    this.#events.on('error', ignore);
    this.#events.on('completed', ({jobId, returnvalue}) => {
      this.#settle(jobId, returnvalue as Outcome);
    });
    this.#events.on('failed', ({jobId, failedReason}) => {
      this.#settle(jobId, failedFor('internal', `No worker could end the job: ${failedReason}.`));
    });
    this.#looking = setInterval(() => void this.#look().catch(ignore), lookEvery);
  }

  /**
   * Opens a queue for adding jobs.
   * @param worker worker of this process, closed with the crew
   */
  static async open(place: QueuePlace, store: Store, worker?: QueueWorker): Promise<QueueCrew> {
    const crew = new QueueCrew(place, store, worker);
    await crew.#events.waitUntilReady();
    return crew;
  }

  async run(job: KeyedJob): Promise<Outcome> {
    const end = new Promise<Outcome>((settle) => this.#pending.set(job.key, {job, settle}));
    if (this.#closing) this.#leave();
    else await this.#add([job]);
    return end;
  }

  /** Adds jobs; the queue ignores those it already contains. */
  async #add(jobs: readonly KeyedJob[]): Promise<void> {
    await this.#queue.addBulk(
      jobs.map((job) => ({name: 'solve', data: job, opts: {jobId: job.key}})),
    );
  }

  #settle(key: string, outcome: Outcome): void {
    const pending = this.#pending.get(key);
    this.#pending.delete(key);
    pending?.settle(outcome);
  }

  /**
   * Polls the disk, since events are lost with a connection, and jobs with a server without
   * persistence.
   */
  async #look(): Promise<void> {
    if (this.#isLooking) return;
    this.#isLooking = true;
    try {
      const lost: KeyedJob[] = [];
      for (const [key, {job}] of [...this.#pending]) {
        const outcome = await this.#store.outcome(key);
        if (outcome) this.#settle(key, outcome);
        else lost.push(job);
      }
      if (!this.#closing) await this.#add(lost.filter(({key}) => this.#pending.has(key)));
    } finally {
      this.#isLooking = false;
    }
  }

  #leave(): void {
    for (const key of [...this.#pending.keys()]) {
      this.#settle(key, failedFor('cancelled', 'The batch was ended.'));
    }
  }

  close(): Promise<void> {
    return (this.#closing ??= this.#end());
  }

  async #end(): Promise<void> {
    clearInterval(this.#looking);
    this.#leave();
    await this.#worker?.close();
    await inTime(Promise.all([this.#queue.close(), this.#events.close()]));
    for (const client of this.#clients) client.disconnect();
  }
}

function connection({Redis: Client}: Packages, url: string): Redis {
  const client = new Client(url, {maxRetriesPerRequest: null});
  client.on('error', ignore); // the client retries until it is disconnected
  return client;
}

/** Limits the time to close a connection to a server that may be gone. */
const inTime = (farewell: Promise<unknown>): Promise<unknown> =>
  Promise.race([farewell.catch(ignore), sleep(300)]);

const ignore = (): void => undefined;
