/** A project while a tab works on it: saved at a pace as it changes. */
import type {Design} from '../../model/design.js';
import {mapped, type History} from '../../model/history.js';
import {nameOf} from '../../model/project-name.js';
import {fieldOf} from '../../model/read.js';
import {heldOf, written, type Written} from '../../model/written-design.js';
import type {Step} from '../../editor/index.js';
import type {Autosave} from '../storage/autosave.js';

/** Of the history as it is stored; another form is not read. */
const version = 1;
/** Between one save and the next, as under a drag. [ms] */
const pace = 400;
/** Names this tab's project for as long as the tab lives. */
export const tabKey = 'seamwise.project';

/**
 * `given`: what the page shows by itself or by its address, and would show again; `sample`: chosen, to be had
 * again at any time; `own`: anything else.
 */
type Origin = 'given' | 'sample' | 'own';

/** What is known of a project before its history is there. */
export interface Announced {
  readonly id?: string;
  readonly title?: string;
  readonly origin?: Origin;
  /** It was taken from the list, or for one that was. */
  readonly isListed?: boolean;
  /** The browser keeps this history already. */
  readonly isKept?: boolean;
}

interface Kept {
  readonly version: typeof version;
  readonly history: History<KeptStep>;
}

interface KeptStep extends Omit<Step, 'design'> {
  readonly design: Written<Design>;
}

const isKept = (state: unknown): state is Kept => fieldOf(state, 'version') === version;

/** Undefined for what no page has kept, or one that is newer than this. */
export const historyIn = (state: unknown): History<Step> | undefined =>
  isKept(state)
    ? mapped(state.history, ({design, ...step}): Step => ({...step, design: heldOf(design)}))
    : undefined;

export const stateOf = (history: History<Step>): Kept => ({
  version,
  history: mapped(history, ({design, ...step}): KeptStep => ({...step, design: written(design)})),
});

/** Whether anybody has done anything. */
const isTouched = ({past, future}: History<Step>): boolean => past.length + future.length > 0;

export class OpenProject {
  /** What its owner calls it. */
  title: string | undefined;
  /** Its picture, once there is one. */
  thumbnail: Blob | undefined;
  readonly #autosave: Autosave;
  readonly #origin: Origin;
  #id: string;
  #history: History<Step>;
  /** Once it is settled that this tab works on it; nobody asks before there is something to keep. */
  #claimed: Promise<void> | undefined;
  /** What is in the database, or on its way there. */
  #saved: History<Step> | undefined;
  /** What is in the database. */
  #written: History<Step> | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** When it was saved last. */
  #moment = -Infinity;

  constructor(autosave: Autosave, history: History<Step>, announced: Announced = {}) {
    const {id = crypto.randomUUID(), title, origin, isKept} = announced;
    this.#autosave = autosave;
    this.#id = id;
    this.title = title;
    this.#history = history;
    this.#origin = origin ?? (history.present.design.garment.sample ? 'sample' : 'own');
    if (isKept) {
      this.#saved = this.#written = history;
      this.#claimed = Promise.resolve(); // whoever takes one from the list has claimed it
    }
    sessionStorage.removeItem(tabKey);
    if (isKept) sessionStorage.setItem(tabKey, id);
    else this.follow(history);
  }

  get id(): string {
    return this.#id;
  }

  get history(): History<Step> {
    return this.#history;
  }

  get name(): string {
    return this.title ?? nameOf(this.#history.present.design.garment);
  }

  /** Whether it is worth a place in the list. */
  get isWorthListing(): boolean {
    return this.#origin === 'own' || this.title !== undefined || isTouched(this.#history);
  }

  /** What a page that is left at once would lose. */
  get unwritten(): History<Step> | undefined {
    return this.#isWorthKeeping && this.#history !== this.#written ? this.#history : undefined;
  }

  /** What it has become; saved soon. */
  follow(history: History<Step>): void {
    this.#history = history;
    if (!this.#isWorthKeeping || history === this.#saved) return;
    const wait = this.#moment + pace - performance.now();
    this.#timer ??= setTimeout(() => void this.flush(), Math.max(0, wait));
  }

  async rename(title: string | undefined): Promise<void> {
    this.title = title;
    if (this.#written || this.#autosave.isUnkept(this.#id))
      await this.#autosave.change(this.#id, {title, isDraft: !this.isWorthListing});
    else await this.flush();
  }

  /** Saves what is not saved yet. */
  async flush(): Promise<void> {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    const history = this.#history;
    if (!this.#isWorthKeeping || history === this.#saved) return;
    this.#saved = history;
    this.#moment = performance.now();
    await (this.#claimed ??= this.#claim());
    // once it is there, another tab may rename it
    const title = this.#written ? undefined : this.title;
    const isKept = await this.#autosave.save(this.#id, {
      name: nameOf(history.present.design.garment),
      state: stateOf(history),
      isDraft: !this.isWorthListing,
      ...(title !== undefined && {title}),
    });
    if (isKept) this.#written = history;
  }

  get #isWorthKeeping(): boolean {
    return this.#origin !== 'given' || this.isWorthListing;
  }

  async #claim(): Promise<void> {
    const {id} = await this.#autosave.claim(this.#id);
    this.#id = id;
    sessionStorage.setItem(tabKey, id);
  }
}
