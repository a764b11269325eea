/** The user's preferences, and the texts in the preferred language. */
import {loadTexts, textsOf, type Texts} from '../texts/texts.js';
import type {Preferences} from '../texts/preferences.js';
import {Observable} from './observable.js';

export class ChosenPreferences extends Observable {
  #chosen: Preferences;

  constructor(chosen: Preferences) {
    super();
    this.#chosen = chosen;
    void this.#learn();
  }

  get chosen(): Preferences {
    return this.#chosen;
  }

  get texts(): Texts {
    const {language, messages} = this.#chosen;
    return textsOf(language, messages);
  }

  prefer(change: Partial<Preferences>): void {
    this.#chosen = {...this.#chosen, ...change};
    this.changed();
    void this.#learn();
  }

  async #learn(): Promise<void> {
    if (!(await loadTexts(this.#chosen.language))) return;
    this.#chosen = {...this.#chosen}; // a new object: cached views are redrawn
    this.changed();
  }
}
