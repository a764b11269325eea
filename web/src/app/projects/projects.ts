/** The projects of this browser, and the one that this tab works on. Opening another one overwrites none. */
import type {Design} from '../../model/design.js';
import {begun, type History} from '../../model/history.js';
import {longestName, withoutEnding} from '../../model/project-name.js';
import {fieldOf} from '../../model/read.js';
import {textsOf, type Step, type Workbench} from '../../editor/index.js';
import {Autosave, type ProjectRecord, type StorageTrouble} from '../storage/autosave.js';
import {stash, unstashed} from '../storage/stash.js';
import {historyIn, OpenProject, stateOf, tabKey, type Announced} from './open-project.js';

/** A project as it is listed. */
export interface ProjectEntry extends Pick<ProjectRecord, 'id' | 'changed' | 'thumbnail'> {
  readonly name: string;
  /** Whether this tab works on it, or another. */
  readonly open?: 'here' | 'elsewhere';
  /** It can still be had back. */
  readonly isDeleted: boolean;
}

const shownName = ({title, name}: ProjectRecord): string => title ?? withoutEnding(name);

export class Projects {
  readonly #workbench: Workbench;
  readonly #autosave: Autosave;
  readonly #listeners = new Set<() => void>();
  readonly #troubles = new Set<StorageTrouble>();
  #present: OpenProject | undefined;
  /** Which of the beginnings of the workbench the present project is. */
  #beginning = -1;
  #announced: Announced | undefined;

  /** @param report hears once of each trouble that keeps work from being kept */
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

  /** Calls back whenever the list may be another, or a name. @returns what ends that */
  subscribe(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** What the present project is called; empty before there is one. */
  get name(): string {
    return this.#present?.name ?? '';
  }

  get present(): OpenProject | undefined {
    return this.#present;
  }

  /** What the browser did not let the page keep, the worst first. */
  get trouble(): StorageTrouble | undefined {
    return (['unavailable', 'full', 'failed'] as const).find((one) => this.#troubles.has(one));
  }

  /** Shows another project; the present one stays in the list as it is. */
  begin(history: History<Step>, announced: Announced = {}): void {
    this.#announced = announced;
    this.#workbench.begin(history);
  }

  beginWith(design: Design, announced: Announced = {}, view: Step['view'] = null): void {
    this.begin(begun({design, view}), announced);
  }

  /**
   * Shows what this tab showed before it was loaded again, or, in a new one, what was worked on last, unless that is
   * open elsewhere. @returns whether there is anything
   */
  async resume(): Promise<boolean> {
    const id = sessionStorage.getItem(tabKey);
    if (id !== null) return this.open(id);
    const [last] = await this.entries();
    return last !== undefined && !last.open && !last.isDeleted && this.open(last.id);
  }

  /** Keeps what the page before could not save any more. */
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

  /** Goes on with a project of the list. @returns false when it is not there any more */
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

  /** The one that was changed last comes first; the present one is always among them. */
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

  /** @param name empty for that of its garment */
  async rename(id: string, name: string): Promise<void> {
    const title = name.trim().slice(0, longestName) || undefined;
    const present = this.#present?.id === id ? this.#present : undefined;
    if (present) await present.rename(title);
    else await this.#autosave.change(id, {title});
  }

  /** Puts a copy into the list, under the same name with a number. */
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

  /** Takes a project that no other tab works on from the list; the page shows another one, then. */
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

  /** Gives the present project a picture. */
  async illustrate(thumbnail: Blob): Promise<void> {
    const present = this.#present;
    if (!present) return;
    present.thumbnail = thumbnail;
    await this.#autosave.change(present.id, {thumbnail});
  }

  /** Until the page is left: what is under way then is kept for when it is loaded again. */
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

  /** Saves what is not saved yet of a project. @returns whether this tab works on it */
  async #flushed(id: string): Promise<boolean> {
    const present = this.#present;
    if (present?.id !== id) return false;
    await present.flush();
    return true;
  }

  #follow(): void {
    const {history, beginnings} = this.#workbench;
    if (!history) return;
    if (this.#present && beginnings === this.#beginning) {
      const {garment} = this.#present.history.present.design;
      this.#present.follow(history);
      if (garment !== history.present.design.garment) this.#tell(); // its name may be another
      return;
    }
    const before = this.#present;
    const announced = this.#announced;
    void before?.flush();
    this.#beginning = beginnings;
    this.#announced = undefined;
    this.#present = new OpenProject(this.#autosave, history, announced);
    this.#tell();
    // who takes one from the list knows that
    if (before?.isWorthListing && !announced?.isListed) this.#offerBack(before);
  }

  #tell(): void {
    for (const listener of this.#listeners) listener();
  }

  /** Opening something else is no step that could be undone. */
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
    const texts = textsOf(this.#workbench.preferences.language);
    this.#workbench.say({tone: 'info', text: words(texts), ...(action && {action: action(texts)})});
  }
}
