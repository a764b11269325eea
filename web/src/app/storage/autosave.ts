/** Saves projects in the user's browser; without storage, for the life of the tab. */
import {
  drop,
  inTransaction,
  openDatabase,
  put,
  stores,
  type Database,
  type ProjectRecord,
} from './database.js';
import {packed, unpacked} from './shared-texts.js';

export type {ProjectRecord} from './database.js';

/**
 * `unavailable`: no storage, as in some private windows; `full`: no space left; `failed`: any other
 * error.
 */
export type StorageTrouble = 'unavailable' | 'full' | 'failed';

interface KeptProject extends ProjectRecord {
  /** The page's data, in a form that can be cloned. */
  readonly state: unknown;
}

/** A project with a new title. */
interface Renamed {
  readonly id: string;
  readonly title: string | undefined;
}

/** Time within which a deleted project can be restored. [ms] */
const graceMs = 10 * 60_000;
/** Time after which an unused draft is deleted. [ms] */
const draftMs = 24 * 3_600_000;

const isOver = ({isDraft = false, deleted, changed}: ProjectRecord): boolean =>
  (deleted !== undefined && Date.now() - deleted > graceMs) ||
  (isDraft && Date.now() - changed > draftMs);

export class Autosave {
  readonly #report: (trouble: StorageTrouble, isLoss: boolean) => void;
  readonly #claim = new Claim();
  readonly #channel = new BroadcastChannel('seamwise-projects');
  readonly #listeners = new Set<(renamed?: Renamed) => void>();
  /** Projects that the browser did not store, by id. */
  readonly #unkept = new Map<string, KeptProject>();
  /** Last trouble. */
  #trouble: StorageTrouble = 'failed';
  #database: Promise<Database> | undefined;
  /** Runs tasks one after the other, in the order of their requests. */
  #queue: Promise<unknown> = Promise.resolve();

  /**
   * @param report called with each trouble, and whether it prevents saving; no method ever throws
   */
  constructor(report: (trouble: StorageTrouble, isLoss: boolean) => void) {
    this.#report = report;
    this.#channel.addEventListener('message', ({data}: MessageEvent<Renamed | undefined>) => {
      for (const listener of this.#listeners) listener(data);
    });
  }

  /**
   * Calls `listener` after each change, of this tab or another.
   * @returns a function that stops this
   */
  subscribe(listener: (renamed?: Renamed) => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Returns whether a project exists in this tab only. */
  isUnkept(id: string): boolean {
    return this.#unkept.has(id);
  }

  /**
   * Saves a project; it keeps its stored title and thumbnail unless new ones are given.
   * @returns true if the browser has stored it
   */
  async save(
    id: string,
    {state, ...given}: Pick<KeptProject, 'name' | 'state' | 'title' | 'thumbnail' | 'isDraft'>,
  ): Promise<boolean> {
    const changed = Date.now();
    const isKept = await this.#safely(false, async (database) => {
      const {data, texts} = await packed(state);
      await inTransaction(database, async (transaction) => {
        for (const [hash, text] of texts) {
          await transaction.objectStore('texts').put(text, hash);
        }
        const before = this.#unkept.get(id) ?? (await transaction.objectStore('projects').get(id));
        const project = {...lasting(before), ...given, id, changed, texts: [...texts.keys()]};
        await put(transaction, data, project);
      });
      return true;
    });
    if (isKept) this.#unkept.delete(id);
    else {
      this.#unkept.set(id, {...lasting(this.#unkept.get(id)), ...given, id, changed, state});
      this.#report(this.#trouble, true);
    }
    this.#tell();
    return isKept;
  }

  /**
   * Returns the projects, the last changed one first, including drafts and those that can still be
   * restored.
   */
  async list(): Promise<readonly ProjectRecord[]> {
    const kept = await this.#safely([], (database) =>
      database.getAllFromIndex('projects', 'changed'),
    );
    const all = new Map([...kept, ...this.#unkept.values()].map((one) => [one.id, one]));
    return [...all.values()]
      .filter((one) => !isOver(one))
      .sort((a, b) => b.changed - a.changed)
      .map(recordOf);
  }

  async load(id: string): Promise<KeptProject | undefined> {
    const unkept = this.#unkept.get(id);
    if (unkept) return unkept;
    return this.#safely(undefined, async (database) => {
      const transaction = database.transaction(stores);
      const project = await transaction.objectStore('projects').get(id);
      if (!project) return undefined;
      const data = await transaction.objectStore('states').get(id);
      const texts = new Map<string, string>();
      for (const hash of project.texts) {
        texts.set(hash, (await transaction.objectStore('texts').get(hash)) ?? '');
      }
      return {...recordOf(project), state: unpacked({data, texts})};
    });
  }

  /** Changes a project; its place in the list stays the same. */
  async change(
    id: string,
    change: Pick<Partial<ProjectRecord>, 'title' | 'thumbnail' | 'deleted' | 'isDraft'>,
  ): Promise<void> {
    const unkept = this.#unkept.get(id);
    if (unkept) this.#unkept.set(id, {...unkept, ...change});
    else {
      await this.#safely(undefined, async (database) => {
        const transaction = database.transaction('projects', 'readwrite');
        const project = await transaction.store.get(id);
        if (project) await transaction.store.put({...project, ...change});
        await transaction.done;
      });
    }
    this.#tell('title' in change ? {id, title: change.title} : undefined);
  }

  /** Deletes old drafts, and projects that can no longer be restored. */
  async tidy(): Promise<void> {
    await this.#safely(undefined, async (database) => {
      const all = await database.getAll('projects');
      for (const {id} of all.filter(isOver)) {
        await inTransaction(database, (transaction) => drop(transaction, id));
      }
    });
  }

  /** @returns the id of the copy; undefined if there is nothing to copy */
  async copy(id: string, title?: string): Promise<string | undefined> {
    const project = await this.load(id);
    if (!project) return undefined;
    const copy = crypto.randomUUID();
    const {name, state, thumbnail} = project;
    const named = title ?? project.title;
    await this.save(copy, {
      ...{name, state},
      ...(named !== undefined && {title: named}),
      ...(thumbnail && {thumbnail}),
    });
    return copy;
  }

  /**
   * Claims a project for this tab, and releases the one before. If another tab has it open, this
   * one gets a copy.
   */
  async claim(id: string): Promise<{readonly id: string; readonly isCopy: boolean}> {
    if (!('locks' in navigator)) return {id, isCopy: false};
    if (await this.#claim.take(id)) return {id, isCopy: false};
    const copy = (await this.copy(id)) ?? crypto.randomUUID();
    await this.#claim.take(copy);
    return {id: copy, isCopy: true};
  }

  /** Returns the projects that are open in any tab. */
  claimed(): Promise<ReadonlySet<string>> {
    return this.#claim.all();
  }

  #tell(renamed?: Renamed): void {
    this.#channel.postMessage(renamed);
    for (const listener of this.#listeners) listener(renamed);
  }

  #open(): Promise<Database> {
    return (this.#database ??= openDatabase(() => {
      this.#database = undefined;
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
        this.#trouble = isFull ? 'full' : trouble;
        this.#report(this.#trouble, false);
        return otherwise;
      }
    });
    this.#queue = done;
    return done;
  }
}

const recordOf = ({id, name, title, changed, thumbnail, isDraft, deleted}: ProjectRecord) => ({
  ...{id, name, changed},
  ...(title !== undefined && {title}),
  ...(thumbnail && {thumbnail}),
  ...(isDraft && {isDraft}),
  ...(deleted !== undefined && {deleted}),
});

/** Returns the fields that stay after a save. */
const lasting = (
  before: ProjectRecord | undefined,
): Pick<ProjectRecord, 'title' | 'thumbnail'> => ({
  ...(before?.title !== undefined && {title: before.title}),
  ...(before?.thumbnail && {thumbnail: before.thumbnail}),
});

// Locks a project to one tab: two tabs that save the same project would undo each other's changes.

/** Time limit for a lock: the previous page may still be closing, as in a reload. [ms] */
const patience = 400;
const prefix = 'seamwise-project-';

/** Locks one project at a time, until the page is left. */
class Claim {
  #release = (): void => undefined;
  #last: Promise<unknown> = Promise.resolve();

  /** Unlocks the previous project. @returns false if another tab has locked this one */
  take(id: string): Promise<boolean> {
    const taken = this.#last.then(() => this.#take(id));
    this.#last = taken;
    return taken;
  }

  #take(id: string): Promise<boolean> {
    this.#release();
    return new Promise((resolve) => {
      navigator.locks
        .request(`${prefix}${id}`, {signal: AbortSignal.timeout(patience)}, () => {
          resolve(true);
          return new Promise<void>((release) => {
            this.#release = release;
          });
        })
        .catch(() => {
          resolve(false);
        });
    });
  }

  /** Returns the projects locked by any tab. */
  async all(): Promise<ReadonlySet<string>> {
    if (!('locks' in navigator)) return new Set();
    const {held = []} = await navigator.locks.query();
    const names = held.flatMap(({name}) => (name?.startsWith(prefix) ? [name] : []));
    return new Set(names.map((name) => name.slice(prefix.length)));
  }
}
