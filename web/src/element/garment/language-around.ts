/** Observes the language of the surrounding page through all shadow roots. */
import type {ReactiveController, ReactiveControllerHost} from 'lit';

export class LanguageAround implements ReactiveController {
  readonly #host: ReactiveControllerHost & Element;
  readonly #changes: MutationObserver | undefined;

  constructor(host: ReactiveControllerHost & Element, changed: () => void) {
    this.#host = host;
    // servers have no MutationObserver
    if ('MutationObserver' in globalThis) this.#changes = new MutationObserver(changed);
    host.addController(this);
  }

  /** Undefined without a `lang` attribute. */
  get around(): string | undefined {
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
