/**
 * The projects of this browser, and the one open in this tab. Opening another one overwrites none.
 */
import type {Design, DesignGarment} from '../../model/design/design.js';
import {begun, type History} from '../../model/design/history.js';
import {longestName, nameOf, withoutEnding} from '../../model/documents/project-name.js';
import {fieldOf} from '../../model/base/read.js';
import {textsOf} from '../../texts/texts.js';
import type {Step} from '../../workbench/state.js';
import type {Workbench} from '../../workbench/workbench.js';
import {Autosave, type ProjectRecord, type StorageTrouble} from '../storage/autosave.js';
import {historyIn, OpenProject, stateOf, tabKey, type Announced} from './open-project.js';

/** An entry of the list of projects. */
export interface ProjectEntry extends Pick<ProjectRecord, 'id' | 'changed' | 'thumbnail'> {
  readonly name: string;
  /** Open in this tab, or in another. */
  readonly open?: 'here' | 'elsewhere';
  /** It can still be restored. */
  readonly isDeleted: boolean;
}

const shownName = ({title, name}: ProjectRecord): string => title ?? withoutEnding(name);

export class Projects {
  readonly #workbench: Workbench;
  readonly #autosave: Autosave;
  readonly #listeners = new Set<() => void>();
  readonly #troubles = new Set<StorageTrouble>();
  #present: OpenProject | undefined;
  /** Number of the workbench's beginning that started the current project. */
  #beginning = -1;
  #announced: Announced | undefined;

  /** Names a project after its garment, a sample in the user's language. */
  readonly #named = (garment: DesignGarment): string => {
    const {samples} = this.#workbench.preferences.texts;
    return nameOf(garment, samples.garments[garment.sample?.style ?? '']);
  };

  /** @param report called once for each kind of trouble that prevents saving */
  constructor(workbench: Workbench, report: (trouble: StorageTrouble) => void) {
    this.#workbench = workbench;
    const told = new Set<StorageTrouble>();
    this.#autosave = new Autosave((trouble, isLoss) => {
      this.#troubles.add(trouble);
      if (!isLoss || told.has(trouble)) return;
      told.add(trouble);
      report(trouble);
    });
    this.#autosave.subscribe((renamed) => {
      if (renamed && this.#present?.id === renamed.id) this.#present.title = renamed.title;
      this.#tell();
    });
    workbench.subscribe(['history'], () => {
      this.#follow();
    });
  }

  /**
   * Calls `listener` after changes of the list or of a name.
   * @returns a function that stops this
   */
  subscribe(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Name of the current project; empty before there is one. */
  get name(): string {
    return this.#present?.name ?? '';
  }

  get present(): OpenProject | undefined {
    return this.#present;
  }

  /** Reason for missing storage, the worst first. */
  get trouble(): StorageTrouble | undefined {
    return (['unavailable', 'full', 'failed'] as const).find((one) => this.#troubles.has(one));
  }

  /** Shows another project; the current one stays in the list unchanged. */
  begin(history: History<Step>, announced: Announced = {}): void {
    this.#announced = announced;
    this.#workbench.history.begin(history);
  }

  beginWith(design: Design, announced: Announced = {}, view: Step['view'] = null): void {
    this.begin(begun({design, view}), announced);
  }

  /** Shows the design of an order, a result or a link, whose answer stays as it was given. */
  beginAsGiven(design: Design, announced: Announced): void {
    this.begin(begun({design, view: null, isGiven: true}), announced);
  }

  /**
   * Shows the tab's project from before a reload, or in a new tab the last changed one, unless it
   * is open elsewhere.
   * @returns true if there is one
   */
  async resume(): Promise<boolean> {
    const id = sessionStorage.getItem(tabKey);
    if (id !== null) return this.open(id);
    const [last] = await this.entries();
    return last !== undefined && !last.open && !last.isDeleted && this.open(last.id);
  }

  /** Saves the changes that the previous page could no longer save. */
  async rescue(): Promise<void> {
    const left = unstashed();
    const history = historyIn(left);
    if (!history) return;
    const id = fieldOf(left, 'id') ?? sessionStorage.getItem(tabKey);
    const [name, title] = [fieldOf(left, 'name'), fieldOf(left, 'title')];
    if (typeof id !== 'string') return;
    sessionStorage.setItem(tabKey, id);
    await this.#autosave.save(id, {
      name: typeof name === 'string' ? name : history.present.design.garment.name,
      state: stateOf(history),
      ...(typeof title === 'string' && {title}),
    });
  }

  /** Continues a project of the list. @returns false if it no longer exists */
  async open(id: string): Promise<boolean> {
    if (id === this.#present?.id) return true;
    if (!historyIn((await this.#autosave.load(id))?.state)) return false;
    await this.#present?.flush();
    const claimed = await this.#autosave.claim(id);
    const project = await this.#autosave.load(claimed.id);
    const history = historyIn(project?.state);
    if (!history) return false;
    if (project?.deleted !== undefined) {
      await this.#autosave.change(claimed.id, {deleted: undefined});
    }
    this.begin(history, {
      ...{id: claimed.id, origin: 'own', isListed: true},
      isKept: !this.#autosave.isUnkept(claimed.id),
      ...(project?.title !== undefined && {title: project.title}),
    });
    if (claimed.isCopy) this.#say(({projects}) => projects.isCopy);
    return true;
  }

  /** Returns the projects, the last changed one first; the current one is always among them. */
  async entries(): Promise<readonly ProjectEntry[]> {
    const present = this.#present;
    const [records, claimed] = await Promise.all([this.#autosave.list(), this.#autosave.claimed()]);
    const entries = records
      .filter(({id, isDraft}) => !isDraft || id === present?.id)
      .map((record): ProjectEntry => {
        const {id, changed, thumbnail, deleted} = record;
        const open = id === present?.id ? 'here' : claimed.has(id) ? 'elsewhere' : undefined;
        return {
          ...{id, changed, name: shownName(record), isDeleted: deleted !== undefined},
          ...(thumbnail && {thumbnail}),
          ...(open && {open}),
        };
      });
    if (!present || entries.some(({id}) => id === present.id)) return entries;
    const {id, name, thumbnail} = present;
    const entry = {id, name, changed: Date.now(), open: 'here', isDeleted: false} as const;
    return [{...entry, ...(thumbnail && {thumbnail})}, ...entries];
  }

  /** Returns the present design of a project; undefined if it no longer exists. */
  async designOf(id: string): Promise<Design | undefined> {
    return historyIn((await this.#autosave.load(id))?.state)?.present.design;
  }

  /** Returns the first garment of a project that is as asked; undefined if there is none. */
  async findGarment(
    isIt: (garment: DesignGarment) => Promise<boolean>,
  ): Promise<DesignGarment | undefined> {
    for (const {id} of await this.#autosave.list()) {
      const history = historyIn((await this.#autosave.load(id))?.state);
      const {garment, added = []} = history?.present.design ?? {};
      for (const one of [garment, ...added.map((other) => other.garment)]) {
        if (one && (await isIt(one))) return one;
      }
    }
    return undefined;
  }

  /** @param name new name; empty for the garment's name */
  async rename(id: string, name: string): Promise<void> {
    const title = name.trim().slice(0, longestName) || undefined;
    const present = this.#present?.id === id ? this.#present : undefined;
    if (present) await present.rename(title);
    else await this.#autosave.change(id, {title});
  }

  /** Adds a copy to the list, under the same name with a number. */
  async duplicate(id: string): Promise<void> {
    await this.#flushed(id);
    const names = new Set((await this.#autosave.list()).map(shownName));
    const project = await this.#autosave.load(id);
    if (!project) return;
    const stem = shownName(project).replace(/ \d+$/, '');
    let number = 2;
    while (names.has(`${stem} ${number}`)) number++;
    await this.#autosave.copy(id, `${stem} ${number}`);
  }

  /** Removes a project that is not open in another tab; the page then shows another one. */
  async remove(id: string, instead: () => Promise<Design>): Promise<void> {
    const isPresent = await this.#flushed(id);
    await this.#autosave.change(id, {deleted: Date.now()});
    if (!isPresent) return;
    const next = (await this.entries()).find(({open, isDeleted}) => !open && !isDeleted);
    if (!next || !(await this.open(next.id)))
      this.beginWith(await instead(), {origin: 'given', isListed: true});
  }

  restore(id: string): Promise<void> {
    return this.#autosave.change(id, {deleted: undefined});
  }

  /** Stores a preview image of the current project. */
  async illustrate(thumbnail: Blob): Promise<void> {
    const present = this.#present;
    if (!present) return;
    present.thumbnail = thumbnail;
    await this.#autosave.change(present.id, {thumbnail});
  }

  /** Keeps unsaved changes when the page is left, for its next load, until `signal` fires. */
  keep(signal: AbortSignal): void {
    void this.#autosave.tidy();
    addEventListener('visibilitychange', () => void this.#present?.flush(), {signal});
    addEventListener(
      'pagehide',
      () => {
        const {unwritten, id, name, title} = this.#present ?? {};
        stash(unwritten && {...stateOf(unwritten), id, name, title});
      },
      {signal},
    );
  }

  /** Saves unsaved changes of a project. @returns true if it is open in this tab */
  async #flushed(id: string): Promise<boolean> {
    const present = this.#present;
    if (present?.id !== id) return false;
    await present.flush();
    return true;
  }

  #follow(): void {
    const {steps: history, beginnings} = this.#workbench.history;
    if (!history) return;
    if (this.#present && beginnings === this.#beginning) {
      const {garment} = this.#present.history.present.design;
      this.#present.follow(history);
      if (garment !== history.present.design.garment) this.#tell(); // its name may have changed
      return;
    }
    const before = this.#present;
    const announced = this.#announced;
    void before?.flush();
    this.#beginning = beginnings;
    this.#announced = undefined;
    this.#present = new OpenProject(this.#autosave, history, announced, this.#named);
    this.#tell();
    // users of the list know that the previous project stays in it
    if (before?.isWorthListing && !announced?.isListed) this.#offerBack(before);
  }

  #tell(): void {
    for (const listener of this.#listeners) listener();
  }

  /** Offers to return to the previous project, since opening another one cannot be undone. */
  #offerBack({id, name}: OpenProject): void {
    this.#say(
      ({projects}) => projects.isKept(name),
      ({projects}) => ({label: projects.back, act: () => void this.open(id)}),
    );
  }

  #say(
    words: (texts: ReturnType<typeof textsOf>) => string,
    action?: (texts: ReturnType<typeof textsOf>) => {label: string; act: () => void},
  ): void {
    const texts = textsOf(this.#workbench.preferences.chosen.language);
    this.#workbench.notices.say({
      tone: 'info',
      text: words(texts),
      ...(action && {action: action(texts)}),
    });
  }
}

/**
 * Keeps unsaved changes when a page is left, since a database needs more time than the page has.
 */
const key = 'seamwise.unsaved';
/**
 * Length from which a text is written only once, even if many steps of a history contain it.
 * [characters]
 */
const longText = 1000;
/** The only field of an object that replaces a text. */
const mark = 'seamwise-text';

/** Keeps data for this tab's next page; `undefined` removes it. */
function stash(state: unknown): void {
  sessionStorage.removeItem(key);
  if (state === undefined) return;
  const texts = new Map<string, number>();
  const data = JSON.stringify(state, (_, value: unknown) => {
    if (typeof value !== 'string' || value.length < longText) return value;
    const number = texts.get(value) ?? texts.size;
    texts.set(value, number);
    return {[mark]: number};
  });
  try {
    sessionStorage.setItem(key, JSON.stringify({data, texts: [...texts.keys()]}));
  } catch {
    // exceeds the tab's storage: the database contains all but the last moment
  }
}

/** Returns and removes the data of the previous page. */
function unstashed(): unknown {
  const text = sessionStorage.getItem(key);
  sessionStorage.removeItem(key);
  if (text === null) return undefined;
  const {data, texts} = JSON.parse(text) as {readonly data: string; readonly texts: string[]};
  return JSON.parse(data, (_, value: unknown) => {
    const number: unknown = fieldOf(value, mark);
    return typeof number === 'number' ? texts[number] : value;
  });
}
