/** Whether a part is to be drawn light or dark: as its user chose, or as the device is. */
import type {ReactiveController} from 'lit';

import type {Appearance} from '../viewer/strokes.js';
import type {DeskElement} from './desk-element.js';

export class AppearanceController implements ReactiveController {
  readonly #host: DeskElement;
  readonly #dark = matchMedia('(prefers-color-scheme: dark)');

  constructor(host: DeskElement) {
    this.#host = host;
    host.addController(this);
  }

  get value(): Appearance {
    const {theme} = this.#host.desk.preferences;
    if (theme !== 'system') return theme;
    return this.#dark.matches ? 'dark' : 'light';
  }

  hostConnected(): void {
    this.#dark.addEventListener('change', this.#changed);
  }

  hostDisconnected(): void {
    this.#dark.removeEventListener('change', this.#changed);
  }

  readonly #changed = (): void => {
    this.#host.requestUpdate();
  };
}
