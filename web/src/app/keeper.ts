/** Keeps what somebody works on in their own browser, so that a reload or a crash loses nothing. */
import type {History} from '../model/history.js';
import type {Step, Workbench} from '../element/index.js';
import {Autosave, type RecentProject, type StorageTrouble} from './storage/autosave.js';

/** Of the history as it is stored; another form is not read. */
const version = 1;
/** After the last change. [ms] */
const patience = 400;
/** Names this tab's project for as long as the tab lives. */
const tabKey = 'seamwise.project';

interface Kept {
  readonly version: typeof version;
  readonly history: History<Step>;
}

const isKept = (state: unknown): state is Kept =>
  typeof state === 'object' && state !== null && Reflect.get(state, 'version') === version;

export class Keeper {
  readonly #desk: Workbench;
  readonly #autosave: Autosave;
  #id = crypto.randomUUID() as string;
  #saved: History<Step> | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

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
    const id = sessionStorage.getItem(tabKey);
    return id === null ? undefined : this.take(id);
  }

  recent(): Promise<readonly RecentProject[]> {
    return this.#autosave.recent();
  }

  /** The history of a project, which this tab works on from now on. */
  async take(id: string): Promise<History<Step> | undefined> {
    const project = await this.#autosave.load(id);
    if (!isKept(project?.state)) return undefined;
    await this.#flush();
    this.#own((await this.#autosave.claim(id)).id);
    this.#saved = project.state.history;
    return project.state.history;
  }

  /** Follows the desk. What nobody has changed is not worth keeping. */
  follow(signal: AbortSignal): void {
    const end = this.#desk.subscribe(() => {
      const {history} = this.#desk;
      if (!history || history === this.#saved || history.past.length + history.future.length === 0)
        return;
      clearTimeout(this.#timer);
      this.#timer = setTimeout(() => void this.#flush(), patience);
    });
    signal.addEventListener('abort', end);
    addEventListener('visibilitychange', () => void this.#flush(), {signal});
    addEventListener('pagehide', () => void this.#flush(), {signal});
  }

  async #flush(): Promise<void> {
    clearTimeout(this.#timer);
    const {history} = this.#desk;
    if (!history || history === this.#saved || history.past.length + history.future.length === 0)
      return;
    if (!this.#saved) this.#own((await this.#autosave.claim(this.#id)).id);
    this.#saved = history;
    const {name} = history.present.design.garment;
    await this.#autosave.save(this.#id, {name, state: {version, history}});
  }

  #own(id: string): void {
    this.#id = id;
    sessionStorage.setItem(tabKey, id);
  }
}
