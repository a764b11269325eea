/** The photo of a tab without a print so far, kept in this browser until there is one. */
import {openDB, type DBSchema, type IDBPDatabase} from 'idb';

import type {FoundPhoto, PhotoKeeper, UnfinishedPhoto} from '../../photo/photo-keeper.js';
import {keepPhoto, keptPhoto} from './kept-photos.js';
import {digestOf} from '../../model/base/digest.js';

interface Schema extends DBSchema {
  /** Photos by tab. Each is written once, since they are large. */
  pictures: {key: string; value: StoredPicture; indexes: {kept: number}};
  steps: {key: string; value: Omit<UnfinishedPhoto, 'picture'>};
}

interface StoredPicture {
  readonly picture: Blob;
  /** Key of the image of the design's print. */
  readonly print: string;
  /** [ms since 1970] */
  readonly kept: number;
}

/** Number of tabs with a kept photo; the oldest are deleted first. */
const most = 4;
const stores = ['pictures', 'steps'] as const;
/** Session key of this tab's name. */
const tabKey = 'seamwise.photo';

/** Photo that this page has written. */
let written: (Pick<UnfinishedPhoto, 'picture'> & {readonly image: string}) | undefined;
/** Runs tasks one after the other, in the order of their requests. */
let queue: Promise<unknown> = Promise.resolve();

/** Runs a task, and ignores errors: the photo can be opened again from its file. */
function safely<T>(
  work: (database: IDBPDatabase<Schema>, tab: string) => Promise<T>,
): Promise<T | undefined> {
  const done = queue.then(async () => {
    let database: IDBPDatabase<Schema> | undefined;
    try {
      const tab = sessionStorage.getItem(tabKey) ?? crypto.randomUUID();
      sessionStorage.setItem(tabKey, tab);
      database = await openDB<Schema>('seamwise-unfinished', 1, {
        upgrade: (made) => {
          made.createObjectStore('pictures').createIndex('kept', 'kept');
          made.createObjectStore('steps');
        },
      });
      return await work(database, tab);
    } catch {
      return undefined;
    } finally {
      database?.close();
    }
  });
  queue = done;
  return done;
}

const drop = async (database: IDBPDatabase<Schema>, tabs: readonly string[]): Promise<void> => {
  const transaction = database.transaction(stores, 'readwrite');
  const dropped = tabs.flatMap((tab) =>
    stores.map((store) => transaction.objectStore(store).delete(tab)),
  );
  await Promise.all([...dropped, transaction.done]);
};

/** Replaces the tab's previous photo. @param image image of the design's print */
const keepUnfinished = (image: string, photo: UnfinishedPhoto): Promise<void> =>
  safely(async (database, tab) => {
    const {picture, ...steps} = photo;
    const isWritten = written?.picture === picture && written.image === image;
    if (!isWritten || (await database.getKey('pictures', tab)) === undefined) {
      written = undefined;
      await drop(database, [tab]); // never combines the steps of one photo with another photo
      const stored = {picture, print: await digestOf(image), kept: Date.now()};
      await database.put('pictures', stored, tab);
      written = {picture, image};
      const tabs = await database.getAllKeysFromIndex('pictures', 'kept');
      await drop(database, tabs.slice(0, -most));
    }
    await database.put('steps', steps, tab);
  });

export const unfinished = (image: string): Promise<FoundPhoto | undefined> =>
  safely(async (database, tab) => {
    const [found, steps] = await Promise.all([
      database.get('pictures', tab),
      database.get('steps', tab),
    ]);
    if (!(found?.picture instanceof Blob)) return undefined;
    const {picture, print} = found;
    return {
      ...{name: '', history: undefined, ...steps},
      picture,
      isOfPrint: print === (await digestOf(image)),
    };
  });

const forgetUnfinished = (): Promise<void> =>
  safely(async (database, tab) => {
    written = undefined;
    await drop(database, [tab]);
  });

/** Storage of photos in this browser. */
export const photoStorage: PhotoKeeper = {
  ...{keep: keepPhoto, kept: keptPhoto},
  ...{keepUnfinished, unfinished, forgetUnfinished},
};
