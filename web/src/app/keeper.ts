/** Keeps what somebody works on in their own browser, so that a reload or a crash loses nothing. */
import type {History} from '../model/history.js';
import {fieldOf} from '../model/read.js';
import type {Step, Workbench} from '../element/index.js';
import {Autosave, type RecentProject, type StorageTrouble} from './storage/autosave.js';
import {stash, unstashed} from './storage/stash.js';

/** Of the history as it is stored; another form is not read. */
const version = 1;
/** Between one save and the next, as under a drag. [ms] */
const pace = 400;
/** Names this tab's project for as long as the tab lives. */
const tabKey = 'seamwise.project';

interface Kept {
  readonly version: typeof version;
  readonly history: History<Step>;
}

const isKept = (state: unknown): state is Kept => fieldOf(state, 'version') === version;

export class Keeper {
  readonly #desk: Workbench;
  readonly #autosave: Autosave;
  #id = crypto.randomUUID() as string;
  /** This tab works on its project once that is settled; nobody asks before there is something to keep. */
  #claimed: Promise<void> | undefined;
  /** What is in the database, or on its way there. */
  #saved: History<Step> | undefined;
  /** What is in the database. */
  #written: History<Step> | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** When it was saved last. */
  #moment = -Infinity;

  /** @param report hears of trouble once */
  constructor(desk: Workbench, report: (trouble: StorageTrouble) => void) {
    this.#desk = desk;
    const told = new Set<StorageTrouble>();
    this.#autosave = new Autosave((trouble) => {
      if (told.has(trouble)) return;
      told.add(trouble);
      report(trouble);
    });
  }

  /** What this tab showed before it was loaded again. */
  async resumed(): Promise<History<Step> | undefined> {
    const left = unstashed();
    const id = sessionStorage.getItem(tabKey);
    const kept = id === null ? undefined : await this.take(id);
    return isKept(left) ? left.history : kept;
  }

  recent(): Promise<readonly RecentProject[]> {
    return this.#autosave.recent();
  }

  /** The history of a project, which this tab works on from now on. */
  async take(id: string): Promise<History<Step> | undefined> {
    const project = await this.#autosave.load(id);
    if (!isKept(project?.state)) return undefined;
    await this.#flush();
    await (this.#claimed = this.#claim(id));
    this.#saved = this.#written = project.state.history;
    return project.state.history;
  }

  /** Follows the desk. What nobody has changed is not worth keeping. */
  follow(signal: AbortSignal): void {
    void this.#flush(); // what the page before has left
    const end = this.#desk.subscribe(() => {
      if (!this.#isWorthKeeping || this.#desk.history === this.#saved) return;
      const wait = this.#moment + pace - performance.now();
      this.#timer ??= setTimeout(() => void this.#flush(), wait);
    });
    signal.addEventListener('abort', end);
    addEventListener('visibilitychange', () => void this.#flush(), {signal});
    addEventListener(
      'pagehide',
      () => {
        const {history} = this.#desk;
        const isLeft = this.#isWorthKeeping && history !== this.#written;
        stash(isLeft ? {version, history} : undefined);
      },
      {signal},
    );
  }

  get #isWorthKeeping(): boolean {
    return this.#desk.canUndo || this.#desk.canRedo;
  }

  async #flush(): Promise<void> {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    const {history} = this.#desk;
    if (!history || !this.#isWorthKeeping || history === this.#saved) return;
    this.#claimed ??= this.#claim(this.#id);
    this.#saved = history;
    this.#moment = performance.now();
    await this.#claimed;
    const {name} = history.present.design.garment;
    if (await this.#autosave.save(this.#id, {name, state: {version, history}}))
      this.#written = history;
  }

  async #claim(wanted: string): Promise<void> {
    const {id} = await this.#autosave.claim(wanted);
    this.#id = id;
    sessionStorage.setItem(tabKey, id);
  }
}
