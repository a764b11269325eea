/** Photos behind prints, kept in this browser beside the projects and in no design. */
import type {KeptPhoto} from '../../photo/photo-keeper.js';
import {scaledStep} from '../../photo/photo-step.js';
import {digestOf} from '../../model/base/digest.js';
import {fieldOf} from '../../model/base/read.js';

interface PhotoRecord extends KeptPhoto {
  /** SHA-256 of the print's image. */
  readonly key: string;
  /** [ms since 1970] */
  readonly kept: number;
}

/** Longest side. [px] */
const longest = 2048;
/** Number of kept photos; older ones are deleted. */
const most = 20;
const store = 'photos';

const answerOf = <T>(request: IDBRequest<T>): Promise<T> =>
  new Promise((resolve, reject) => {
    request.onsuccess = () => {
      resolve(request.result);
    };
    request.onerror = () => {
      reject(request.error ?? new Error('The database is broken.'));
    };
  });

async function inStore<T>(
  mode: IDBTransactionMode,
  work: (photos: IDBObjectStore) => Promise<T>,
): Promise<T> {
  const opening = indexedDB.open('seamwise-photos', 1);
  opening.onupgradeneeded = () => {
    opening.result.createObjectStore(store, {keyPath: 'key'}).createIndex('kept', 'kept');
  };
  const database = await answerOf(opening);
  try {
    return await work(database.transaction(store, mode).objectStore(store));
  } finally {
    database.close();
  }
}

/** Returns a reduced photo, with the step scaled to its pixels. */
async function small({picture, name, step}: KeptPhoto): Promise<KeptPhoto> {
  const {width, height} = step.reading;
  const scale = Math.min(1, longest / Math.max(width, height));
  const bitmap = await createImageBitmap(picture, {
    ...{imageOrientation: 'from-image', resizeQuality: 'high'},
    resizeWidth: Math.round(scale * width),
    resizeHeight: Math.round(scale * height),
  });
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  canvas.getContext('2d')?.drawImage(bitmap, 0, 0);
  bitmap.close();
  const written = await canvas.convertToBlob({type: 'image/jpeg', quality: 0.92});
  return {picture: written, name, step: scaledStep(step, canvas)};
}

/** Keeps a photo, if the browser allows it. @param image image of the print made from it */
export async function keepPhoto(image: string, photo: KeptPhoto): Promise<void> {
  try {
    const [key, kept] = await Promise.all([digestOf(image), small(photo)]);
    await inStore('readwrite', async (photos) => {
      await answerOf(photos.put({...kept, key, kept: Date.now()} satisfies PhotoRecord));
      const keys = await answerOf(photos.index('kept').getAllKeys());
      await Promise.all(keys.slice(0, -most).map((old) => answerOf(photos.delete(old))));
    });
  } catch {
    // it can be opened again from its file
  }
}

/** Returns the photo behind a print, if it is kept. */
export async function keptPhoto(image: string): Promise<KeptPhoto | undefined> {
  try {
    const key = await digestOf(image);
    const found: unknown = await inStore('readonly', (photos) => answerOf(photos.get(key)));
    return fieldOf(found, 'picture') instanceof Blob ? (found as PhotoRecord) : undefined;
  } catch {
    return undefined;
  }
}
