/** The database of projects. All that it has learned since its first form may be absent from a record. */
import {openDB, type DBSchema, type IDBPDatabase, type IDBPTransaction} from 'idb';

export interface ProjectRecord {
  readonly id: string;
  /** Of its garment; used to be the name of the garment's file. */
  readonly name: string;
  /** What its owner calls it. */
  readonly title?: string | undefined;
  /** [ms since 1970] */
  readonly changed: number;
  readonly thumbnail?: Blob;
  /** Nobody has done anything to it yet, and it can be had again at any time. */
  readonly isDraft?: boolean;
  /** When it was thrown away. [ms since 1970] */
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

/** @param closed called once it has to be opened again */
export const openDatabase = (closed: () => void): Promise<Database> =>
  openDB<Schema>('seamwise', 1, {
    upgrade: (database) => {
      const projects = database.createObjectStore('projects', {keyPath: 'id'});
      projects.createIndex('changed', 'changed');
      projects.createIndex('texts', 'texts', {multiEntry: true});
      database.createObjectStore('states');
      database.createObjectStore('texts');
    },
    // a newer page in another tab wants to change the database
    blocking: (_current, _blocked, event) => {
      closed();
      (event.target as IDBDatabase).close();
    },
    terminated: closed,
  });

/** All of it or nothing. */
export async function inTransaction(
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

/** Texts that no project holds any more go with the last one that did. */
async function sweep(transaction: Transaction, before: StoredProject | undefined): Promise<void> {
  for (const hash of before?.texts ?? []) {
    const holders = await transaction.objectStore('projects').index('texts').count(hash);
    if (holders === 0) await transaction.objectStore('texts').delete(hash);
  }
}
