/** What somebody looks at, means and is told, whatever they work on. */
import {loadTexts} from '../texts/texts.js';
import {Observable} from './observable.js';
import type {Preferences} from '../texts/preferences.js';
import type {Scenes} from './scenes.js';
import {
  sameTarget,
  type DoubtfulPicture,
  type Notice,
  type SheetWindow,
  type Target,
} from './state.js';

export class ViewState extends Observable {
  /** Asked for the view when a step is taken, and told when one is to be restored; the page sets it. */
  view: SheetWindow | undefined;
  #preferences: Preferences;
  #notice: Notice | undefined;
  #doubtful: DoubtfulPicture | undefined;
  #scenes: Scenes | undefined;
  #selected: Target | undefined;
  #pointed: Target | undefined;

  constructor(preferences: Preferences) {
    super();
    this.#preferences = preferences;
    void this.#learn();
  }

  get preferences(): Preferences {
    return this.#preferences;
  }

  prefer(change: Partial<Preferences>): void {
    this.#preferences = {...this.#preferences, ...change};
    this.changed();
    void this.#learn();
  }

  async #learn(): Promise<void> {
    if (!(await loadTexts(this.#preferences.language))) return;
    this.#preferences = {...this.#preferences}; // what is kept by them is drawn again
    this.changed();
  }

  get notice(): Notice | undefined {
    return this.#notice;
  }

  say(notice: Notice | undefined): void {
    this.#notice = notice;
    this.changed();
  }

  /** What has to be decided before it becomes the print. */
  get doubtful(): DoubtfulPicture | undefined {
    return this.#doubtful;
  }

  set doubtful(picture: DoubtfulPicture | undefined) {
    if (picture === this.#doubtful) return;
    this.#doubtful = picture;
    this.changed();
  }

  /** The sheets that the pattern shows, for everything beside it that speaks of the same. */
  get scenes(): Scenes | undefined {
    return this.#scenes;
  }

  set scenes(scenes: Scenes | undefined) {
    if (scenes?.now === this.#scenes?.now && scenes?.before === this.#scenes?.before) return;
    this.#scenes = scenes;
    this.changed();
  }

  /** What was picked last: it stays when the pointer moves on. */
  get selected(): Target | undefined {
    return this.#selected;
  }

  select(target: Target | undefined): void {
    if (sameTarget(target, this.#selected)) return;
    this.#selected = target;
    this.changed();
  }

  /** What the pointer is over, in the picture or in a list. */
  get pointed(): Target | undefined {
    return this.#pointed;
  }

  point(target: Target | undefined): void {
    if (sameTarget(target, this.#pointed)) return;
    this.#pointed = target;
    this.changed();
  }

  /** Takes back what was said, as a part of a change that is told later. */
  protected clearNotice(): void {
    this.#notice = undefined;
  }

  /** Forgets what was meant, as a part of a change that is told later. */
  protected clearTargets(): void {
    this.#selected = undefined;
    this.#pointed = undefined;
  }
}
