/** The language that a page says of the place where an element stands, through all shadow roots, and as it changes. */
import type {ReactiveController, ReactiveControllerHost} from 'lit';

export class LanguageAround implements ReactiveController {
  readonly #host: ReactiveControllerHost & Element;
  readonly #changes: MutationObserver | undefined;

  constructor(host: ReactiveControllerHost & Element, changed: () => void) {
    this.#host = host;
    // there is none on a server
    if ('MutationObserver' in globalThis) this.#changes = new MutationObserver(changed);
    host.addController(this);
  }

  /** Undefined where nobody has said it. */
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
