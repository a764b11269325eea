/** The user's preferences, and the texts in the preferred language. */
import {loadTexts, textsOf, type Texts} from '../texts/texts.js';
import type {Preferences} from '../texts/preferences.js';
import {Observable} from './observable.js';

export class ChosenPreferences extends Observable {
  #preferences: Preferences;

  constructor(preferences: Preferences) {
    super();
    this.#preferences = preferences;
    void this.#learn();
  }

  get preferences(): Preferences {
    return this.#preferences;
  }

  get texts(): Texts {
    const {language, messages} = this.#preferences;
    return textsOf(language, messages);
  }

  prefer(change: Partial<Preferences>): void {
    this.#preferences = {...this.#preferences, ...change};
    this.changed();
    void this.#learn();
  }

  async #learn(): Promise<void> {
    if (!(await loadTexts(this.#preferences.language))) return;
    this.#preferences = {...this.#preferences}; // a new object: cached views are redrawn
    this.changed();
  }
}
