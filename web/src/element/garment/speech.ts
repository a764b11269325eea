/**
 * Language of an element: the one requested, or else that of the surrounding page, or else the
 * browser's.
 */
import type {ReactiveControllerHost} from 'lit';

import type {Units} from '../../model/base/length-text.js';
import {textsOf, type Messages, type Texts} from '../../texts/texts.js';
import {preferencesFor} from '../../texts/preferences.js';
import type {Workbench} from '../../workbench/workbench.js';
import {localeOf} from './attributes.js';
import {LanguageAround} from './language-around.js';

/** The element's language and units. */
interface Speaker extends ReactiveControllerHost, Element {
  readonly locale: string | null;
  readonly units: Units;
}

export class Speech {
  readonly #speaker: Speaker;
  readonly #workbench: Workbench;
  readonly #language: LanguageAround;
  #messages: Messages | undefined;

  constructor(speaker: Speaker & Element, workbench: Workbench) {
    this.#speaker = speaker;
    this.#workbench = workbench;
    this.#language = new LanguageAround(speaker, () => {
      this.prefer();
    });
  }

  /** Messages that replace the element's own. */
  get messages(): Messages | undefined {
    return this.#messages;
  }

  set messages(messages: Messages | undefined) {
    this.#messages = messages;
    this.prefer();
  }

  get texts(): Texts {
    const {language, messages} = this.#workbench.preferences.chosen;
    return textsOf(language, messages);
  }

  /** Updates the language and the units after a change. */
  prefer(): void {
    const {locale, units} = this.#speaker;
    const {language} = preferencesFor(localeOf(locale, this.#language.around, navigator.language));
    const messages = this.#messages;
    const known = this.#workbench.preferences.chosen;
    const isKnown =
      language === known.language && units === known.units && messages === known.messages;
    if (!isKnown) this.#workbench.prefer({language, units, messages});
  }
}
