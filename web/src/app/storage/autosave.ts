/** What people were working on, kept in their own browser. */
import {openDB, type DBSchema, type IDBPDatabase, type IDBPTransaction} from 'idb';

import {Claim} from './claim.js';
import {packed, unpacked} from './shared-texts.js';

/** `unavailable`: nothing can be kept, as in some private windows; `full`: the disk is; `failed`: anything else. */
export type StorageTrouble = 'unavailable' | 'full' | 'failed';

export interface RecentProject {
  readonly id: string;
  readonly name: string;
  /** [ms since 1970] */
  readonly changed: number;
  readonly thumbnail?: Blob;
}

export interface KeptProject extends RecentProject {
  /** Whatever the page has to remember, as data that can be cloned. */
  readonly state: unknown;
}

interface StoredProject extends RecentProject {
  /** Names of the long texts in its state. */
  readonly texts: readonly string[];
}

interface Schema extends DBSchema {
  projects: {key: string; value: StoredProject; indexes: {changed: number; texts: string}};
  states: {key: string; value: unknown};
  texts: {key: string; value: string};
}

const stores = ['projects', 'states', 'texts'] as const;
type Database = IDBPDatabase<Schema>;
type Transaction = IDBPTransaction<Schema, (typeof stores)[number][], 'readwrite'>;

/** Older projects are forgotten. */
const keptProjects = 20;

export class Autosave {
  readonly #report: (trouble: StorageTrouble) => void;
  readonly #claim = new Claim();
  #database: Promise<Database> | undefined;
  /** One after the other, in the order in which they were asked for. */
  #queue: Promise<unknown> = Promise.resolve();

  /** @param report hears of whatever goes wrong; no method ever throws */
  constructor(report: (trouble: StorageTrouble) => void) {
    this.#report = report;
  }

  /** @returns whether it is kept now */
  save(id: string, {name, state, thumbnail}: Pick<KeptProject, 'name' | 'state' | 'thumbnail'>) {
    return this.#safely(false, async (database) => {
      const {data, texts} = await packed(state);
      const changed = Date.now();
      await inTransaction(database, async (transaction) => {
        for (const [hash, text] of texts) {
          await transaction.objectStore('texts').put(text, hash);
        }
        await put(transaction, data, {
          ...{id, name, changed, texts: [...texts.keys()]},
          ...(thumbnail && {thumbnail}),
        });
        const oldest = await transaction.objectStore('projects').index('changed').getAllKeys();
        for (const old of oldest.slice(0, -keptProjects)) await drop(transaction, old);
      });
      return true;
    });
  }

  /** The one that was changed last comes first. */
  recent(): Promise<readonly RecentProject[]> {
    return this.#safely([], async (database) => {
      const projects = await database.getAllFromIndex('projects', 'changed');
      return projects.reverse().map(recentOf);
    });
  }

  load(id: string): Promise<KeptProject | undefined> {
    return this.#safely(undefined, async (database) => {
      const transaction = database.transaction(stores);
      const project = await transaction.objectStore('projects').get(id);
      if (!project) return undefined;
      const data = await transaction.objectStore('states').get(id);
      const texts = new Map<string, string>();
      for (const hash of project.texts) {
        texts.set(hash, (await transaction.objectStore('texts').get(hash)) ?? '');
      }
      return {...recentOf(project), state: unpacked({data, texts})};
    });
  }

  remove(id: string): Promise<void> {
    return this.#safely(undefined, (database) =>
      inTransaction(database, (transaction) => drop(transaction, id)),
    );
  }

  /**
   * Makes this tab the one that works on a project, and lets go of the one before. Where another tab works on
   * it, this one gets a copy.
   */
  async claim(id: string): Promise<{readonly id: string; readonly copied: boolean}> {
    if (!('locks' in navigator)) return {id, copied: false};
    if (await this.#claim.take(id)) return {id, copied: false};
    const copy = crypto.randomUUID();
    await this.#claim.take(copy);
    await this.#safely(undefined, (database) =>
      inTransaction(database, async (transaction) => {
        const project = await transaction.objectStore('projects').get(id);
        if (!project) return;
        const state = await transaction.objectStore('states').get(id);
        await put(transaction, state, {...project, id: copy});
      }),
    );
    return {id: copy, copied: true};
  }

  /** Lets other tabs work on the project. */
  release(): void {
    this.#claim.release();
  }

  #open(): Promise<Database> {
    const forget = (): void => {
      this.#database = undefined;
    };
    return (this.#database ??= openDB<Schema>('seamwise', 1, {
      upgrade: (database) => {
        const projects = database.createObjectStore('projects', {keyPath: 'id'});
        projects.createIndex('changed', 'changed');
        projects.createIndex('texts', 'texts', {multiEntry: true});
        database.createObjectStore('states');
        database.createObjectStore('texts');
      },
      // a newer page in another tab wants to change the database
      blocking: (_current, _blocked, event) => {
        forget();
        (event.target as IDBDatabase).close();
      },
      terminated: forget,
    }));
  }

  #safely<T>(otherwise: T, work: (database: Database) => Promise<T>): Promise<T> {
    const done = this.#queue.then(async () => {
      let trouble: StorageTrouble = 'unavailable';
      try {
        const database = await this.#open();
        trouble = 'failed';
        return await work(database);
      } catch (error) {
        if (trouble === 'unavailable') this.#database = undefined;
        const isFull = error instanceof DOMException && error.name === 'QuotaExceededError';
        this.#report(isFull ? 'full' : trouble);
        return otherwise;
      }
    });
    this.#queue = done;
    return done;
  }
}

const recentOf = ({id, name, changed, thumbnail}: StoredProject): RecentProject => ({
  ...{id, name, changed},
  ...(thumbnail && {thumbnail}),
});

/** All of it or nothing. */
async function inTransaction(
  database: Database,
  work: (transaction: Transaction) => Promise<void>,
): Promise<void> {
  const transaction = database.transaction([...stores], 'readwrite');
  const done = transaction.done.catch((error: unknown) => {
    throw transaction.error ?? error;
  });
  // whichever fails, both are waited for
  const [end, own] = await Promise.allSettled([done, work(transaction)]);
  for (const outcome of [end, own]) {
    if (outcome.status === 'rejected') throw outcome.reason;
  }
}

async function put(
  transaction: Transaction,
  state: unknown,
  project: StoredProject,
): Promise<void> {
  const before = await transaction.objectStore('projects').get(project.id);
  await transaction.objectStore('projects').put(project);
  await transaction.objectStore('states').put(state, project.id);
  await sweep(transaction, before);
}

async function drop(transaction: Transaction, id: string): Promise<void> {
  const before = await transaction.objectStore('projects').get(id);
  await transaction.objectStore('projects').delete(id);
  await transaction.objectStore('states').delete(id);
  await sweep(transaction, before);
}

/** Texts that no project holds any more go with the last one that did. */
async function sweep(transaction: Transaction, before: StoredProject | undefined): Promise<void> {
  for (const hash of before?.texts ?? []) {
    const holders = await transaction.objectStore('projects').index('texts').count(hash);
    if (holders === 0) await transaction.objectStore('texts').delete(hash);
  }
}
