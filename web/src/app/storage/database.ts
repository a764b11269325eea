/** The database of projects. Fields added after the first version may be absent from a record. */
import {openDB, type DBSchema, type IDBPDatabase, type IDBPTransaction} from 'idb';

export interface ProjectRecord {
  readonly id: string;
  /** Garment's name; formerly that of the garment's file. */
  readonly name: string;
  /** Title given by the user. */
  readonly title?: string | undefined;
  /** [ms since 1970] */
  readonly changed: number;
  readonly thumbnail?: Blob;
  /** The user has not changed it yet, and it can be reproduced at any time. */
  readonly isDraft?: boolean;
  /** Time of deletion. [ms since 1970] */
  readonly deleted?: number | undefined;
}

interface StoredProject extends ProjectRecord {
  /** Names of the long texts in its state. */
  readonly texts: readonly string[];
}

interface Schema extends DBSchema {
  projects: {key: string; value: StoredProject; indexes: {changed: number; texts: string}};
  states: {key: string; value: unknown};
  texts: {key: string; value: string};
}

export const stores = ['projects', 'states', 'texts'] as const;
export type Database = IDBPDatabase<Schema>;
type Transaction = IDBPTransaction<Schema, (typeof stores)[number][], 'readwrite'>;

/** @param closed called when the database has to be reopened */
export const openDatabase = (closed: () => void): Promise<Database> =>
  openDB<Schema>('seamwise', 1, {
    upgrade: (database) => {
      const projects = database.createObjectStore('projects', {keyPath: 'id'});
      projects.createIndex('changed', 'changed');
      projects.createIndex('texts', 'texts', {multiEntry: true});
      database.createObjectStore('states');
      database.createObjectStore('texts');
    },
    // a newer page in another tab needs to upgrade the database
    blocking: (_current, _blocked, event) => {
      closed();
      (event.target as IDBDatabase).close();
    },
    terminated: closed,
  });

/** Runs `work` as one transaction: all of it or nothing. */
export async function inTransaction(
  database: Database,
  work: (transaction: Transaction) => Promise<void>,
): Promise<void> {
  const transaction = database.transaction([...stores], 'readwrite');
  const done = transaction.done.catch((error: unknown) => {
    throw transaction.error ?? error;
  });
  // waits for both, whichever fails
  const [end, own] = await Promise.allSettled([done, work(transaction)]);
  for (const outcome of [end, own]) {
    if (outcome.status === 'rejected') throw outcome.reason;
  }
}

export async function put(
  transaction: Transaction,
  state: unknown,
  project: StoredProject,
): Promise<void> {
  const before = await transaction.objectStore('projects').get(project.id);
  await transaction.objectStore('projects').put(project);
  await transaction.objectStore('states').put(state, project.id);
  await sweep(transaction, before);
}

export async function drop(transaction: Transaction, id: string): Promise<void> {
  const before = await transaction.objectStore('projects').get(id);
  await transaction.objectStore('projects').delete(id);
  await transaction.objectStore('states').delete(id);
  await sweep(transaction, before);
}

/** Deletes texts that no project uses any more. */
async function sweep(transaction: Transaction, before: StoredProject | undefined): Promise<void> {
  for (const hash of before?.texts ?? []) {
    const holders = await transaction.objectStore('projects').index('texts').count(hash);
    if (holders === 0) await transaction.objectStore('texts').delete(hash);
  }
}
