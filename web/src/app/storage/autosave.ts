/** What people were working on, kept in their own browser; for as long as a tab lives where that keeps nothing. */
import {Claim} from './claim.js';
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

/** `unavailable`: nothing can be kept, as in some private windows; `full`: the disk is; `failed`: anything else. */
export type StorageTrouble = 'unavailable' | 'full' | 'failed';

interface KeptProject extends ProjectRecord {
  /** Whatever the page has to remember, as data that can be cloned. */
  readonly state: unknown;
}

/** A project that is called otherwise from now on. */
interface Renamed {
  readonly id: string;
  readonly title: string | undefined;
}

/** What was thrown away can be had back within this. [ms] */
const graceMs = 10 * 60_000;
/** Drafts that nobody came back to are forgotten. [ms] */
const draftMs = 24 * 3_600_000;

const isOver = ({isDraft = false, deleted, changed}: ProjectRecord): boolean =>
  (deleted !== undefined && Date.now() - deleted > graceMs) ||
  (isDraft && Date.now() - changed > draftMs);

export class Autosave {
  readonly #report: (trouble: StorageTrouble, isLoss: boolean) => void;
  readonly #claim = new Claim();
  readonly #channel = new BroadcastChannel('seamwise-projects');
  readonly #listeners = new Set<(renamed?: Renamed) => void>();
  /** What the browser would not keep, by id. */
  readonly #unkept = new Map<string, KeptProject>();
  /** What went wrong last. */
  #trouble: StorageTrouble = 'failed';
  #database: Promise<Database> | undefined;
  /** One after the other, in the order in which they were asked for. */
  #queue: Promise<unknown> = Promise.resolve();

  /** @param report hears of whatever goes wrong, and whether work is not kept for it; no method ever throws */
  constructor(report: (trouble: StorageTrouble, isLoss: boolean) => void) {
    this.#report = report;
    this.#channel.addEventListener('message', ({data}: MessageEvent<Renamed | undefined>) => {
      for (const listener of this.#listeners) listener(data);
    });
  }

  /** Calls back after every change, of this tab or another. @returns what ends that */
  subscribe(listener: (renamed?: Renamed) => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Whether nothing but this tab keeps a project. */
  isUnkept(id: string): boolean {
    return this.#unkept.has(id);
  }

  /** Title and thumbnail of what is there already stay, unless there is another. @returns whether the browser keeps it */
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

  /** The one that was changed last comes first. Drafts and what can still be had back are among them. */
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

  /** Its place in the list stays as it was. */
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

  /** Forgets for good what was thrown away or left as a draft long enough ago. */
  async tidy(): Promise<void> {
    await this.#safely(undefined, async (database) => {
      const all = await database.getAll('projects');
      for (const {id} of all.filter(isOver)) {
        await inTransaction(database, (transaction) => drop(transaction, id));
      }
    });
  }

  /** @returns the id of the copy, if there is anything to copy */
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
   * Makes this tab the one that works on a project, and lets go of the one before. Where another tab works on
   * it, this one gets a copy.
   */
  async claim(id: string): Promise<{readonly id: string; readonly isCopy: boolean}> {
    if (!('locks' in navigator)) return {id, isCopy: false};
    if (await this.#claim.take(id)) return {id, isCopy: false};
    const copy = (await this.copy(id)) ?? crypto.randomUUID();
    await this.#claim.take(copy);
    return {id: copy, isCopy: true};
  }

  /** Those that some tab works on. */
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

/** What outlives a save. */
const lasting = (
  before: ProjectRecord | undefined,
): Pick<ProjectRecord, 'title' | 'thumbnail'> => ({
  ...(before?.title !== undefined && {title: before.title}),
  ...(before?.thumbnail && {thumbnail: before.thumbnail}),
});
