/**
 * Language of an element: the one requested, or else that of the surrounding page, or else the
 * browser's.
 */
import type {ReactiveController, ReactiveControllerHost} from 'lit';

import type {Units} from '../../model/base/length-text.js';
import {textsOf, type Messages, type Texts} from '../../texts/texts.js';
import {preferencesFor} from '../../texts/preferences.js';
import type {Workbench} from '../../workbench/workbench.js';
import {localeOf} from './attributes.js';

/** The element's language and units. */
interface LanguageOwner extends ReactiveControllerHost, Element {
  readonly locale: string | null;
  readonly units: Units;
}

export class ElementLanguage {
  readonly #owner: LanguageOwner;
  readonly #workbench: Workbench;
  readonly #around: LanguageAround;
  #messages: Messages | undefined;

  constructor(owner: LanguageOwner & Element, workbench: Workbench) {
    this.#owner = owner;
    this.#workbench = workbench;
    this.#around = new LanguageAround(owner, () => {
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
    const {locale, units} = this.#owner;
    const {language} = preferencesFor(localeOf(locale, this.#around.language, navigator.language));
    const messages = this.#messages;
    const known = this.#workbench.preferences.chosen;
    const isKnown =
      language === known.language && units === known.units && messages === known.messages;
    if (!isKnown) this.#workbench.prefer({language, units, messages});
  }
}

/** Observes the language of the surrounding page through all shadow roots. */
class LanguageAround implements ReactiveController {
  readonly #host: ReactiveControllerHost & Element;
  readonly #changes: MutationObserver | undefined;

  constructor(host: ReactiveControllerHost & Element, changed: () => void) {
    this.#host = host;
    // servers have no MutationObserver
    if ('MutationObserver' in globalThis) this.#changes = new MutationObserver(changed);
    host.addController(this);
  }

  /** Undefined without a `lang` attribute. */
  get language(): string | undefined {
    for (
      let at: Node | null = this.#host;
      at;
      at = at instanceof ShadowRoot ? at.host : at.parentNode
    ) {
      const lang = at instanceof Element && at.getAttribute('lang');
      if (lang) return lang;
    }
    return undefined;
  }

  hostConnected(): void {
    for (let root = this.#host.getRootNode(); ; root = root.host.getRootNode()) {
      this.#changes?.observe(root, {attributeFilter: ['lang'], subtree: true});
      if (!(root instanceof ShadowRoot)) break;
    }
  }

  hostDisconnected(): void {
    this.#changes?.disconnect();
  }
}
