/** The open project of a tab; saves its changes at a limited rate. */
import type {Design, DesignGarment} from '../../model/design/design.js';
import {mapped, type History} from '../../model/design/history.js';
import {nameOf} from '../../model/documents/project-name.js';
import {fieldOf} from '../../model/base/read.js';
import {heldOf, written, type Written} from '../../model/design/written-design.js';
import type {Step} from '../../workbench/state.js';
import type {Autosave} from '../storage/autosave.js';

/** Version of the stored history; others are not read. */
const version = 1;
/** Least time between two saves, for example during a drag. [ms] */
const pace = 400;
/** Session key of this tab's project. */
export const tabKey = 'seamwise.project';

/**
 * `given`: shown by default or by the URL, and reproducible; `sample`: chosen from the samples, and
 * reproducible; `own`: anything else.
 */
type Origin = 'given' | 'sample' | 'own';

/** Properties of a project that are known before its history. */
export interface Announced {
  readonly id?: string;
  readonly title?: string;
  readonly origin?: Origin;
  /** The user opened it from the list, or it replaces a project of the list. */
  readonly isListed?: boolean;
  /** The browser has stored this history already. */
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

/** Returns undefined for other data, or a history of another version. */
export const historyIn = (state: unknown): History<Step> | undefined =>
  isKept(state)
    ? mapped(state.history, ({design, ...step}): Step => ({...step, design: heldOf(design)}))
    : undefined;

export const stateOf = (history: History<Step>): Kept => ({
  version,
  history: mapped(history, ({design, ...step}): KeptStep => ({...step, design: written(design)})),
});

/** Returns whether the user has changed the project. */
const isTouched = ({past, future}: History<Step>): boolean => past.length + future.length > 0;

export class OpenProject {
  /** Title given by the user. */
  title: string | undefined;
  /** Preview image, once there is one. */
  thumbnail: Blob | undefined;
  readonly #autosave: Autosave;
  /** Names a project without a title. */
  readonly #named: (garment: DesignGarment) => string;
  readonly #origin: Origin;
  #id: string;
  #history: History<Step>;
  /** Resolves once this tab has claimed the project; it starts with the first save. */
  #claimed: Promise<void> | undefined;
  /** History in the database, or being written to it. */
  #saved: History<Step> | undefined;
  /** History in the database. */
  #written: History<Step> | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** Time of the last save. [ms] */
  #moment = -Infinity;

  constructor(
    autosave: Autosave,
    history: History<Step>,
    announced: Announced = {},
    named: (garment: DesignGarment) => string = nameOf,
  ) {
    const {id = crypto.randomUUID(), title, origin, isKept} = announced;
    this.#autosave = autosave;
    this.#named = named;
    this.#id = id;
    this.title = title;
    this.#history = history;
    this.#origin = origin ?? (history.present.design.garment.sample ? 'sample' : 'own');
    if (isKept) {
      this.#saved = this.#written = history;
      this.#claimed = Promise.resolve(); // opening a project from the list has claimed it
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
    return this.title ?? this.#named(this.#history.present.design.garment);
  }

  /** Returns whether the project belongs in the list. */
  get isWorthListing(): boolean {
    return this.#origin === 'own' || this.title !== undefined || isTouched(this.#history);
  }

  /** History that would be lost if the page were left now. */
  get unwritten(): History<Step> | undefined {
    return this.#isWorthKeeping && this.#history !== this.#written ? this.#history : undefined;
  }

  /** Takes over a changed history; saves it soon. */
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

  /** Saves unsaved changes. */
  async flush(): Promise<void> {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    const history = this.#history;
    if (!this.#isWorthKeeping || history === this.#saved) return;
    this.#saved = history;
    this.#moment = performance.now();
    await (this.#claimed ??= this.#claim());
    // another tab may rename it once it is stored
    const title = this.#written ? undefined : this.title;
    const isKept = await this.#autosave.save(this.#id, {
      name: this.#named(history.present.design.garment),
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
