/** Whether a part is to be drawn light or dark: as its user chose, or as what is around it. */
import {css, type ReactiveController} from 'lit';

import type {Appearance} from '../../viewer/strokes.js';
import type {WorkbenchElement} from './workbench-element.js';

/**
 * For the styles of whoever is drawn. It shows in a property that is seen nowhere else which `color-scheme` the
 * part has, and has the browser tell when that changes.
 */
export const colourScheme = css`
  :host {
    column-rule-color: light-dark(rgb(255 255 255), rgb(0 0 0));
    transition: column-rule-color 1ms step-start;
  }
`;

const shown: Readonly<Record<string, Appearance>> = {
  'rgb(255, 255, 255)': 'light',
  'rgb(0, 0, 0)': 'dark',
};

export class AppearanceController implements ReactiveController {
  readonly #host: WorkbenchElement;
  readonly #dark = matchMedia('(prefers-color-scheme: dark)');
  /** As last asked for. Asking at every update would have the page styled each time. */
  #around: Appearance | undefined;

  constructor(host: WorkbenchElement) {
    this.#host = host;
    host.addController(this);
  }

  get value(): Appearance {
    const {theme} = this.#host.workbench.preferences;
    if (theme !== 'system') return theme;
    return (this.#around ??= this.#ask());
  }

  hostConnected(): void {
    this.#around = undefined;
    this.#dark.addEventListener('change', this.#changed);
    this.#host.addEventListener('transitionend', this.#changed);
  }

  hostDisconnected(): void {
    this.#dark.removeEventListener('change', this.#changed);
    this.#host.removeEventListener('transitionend', this.#changed);
  }

  #ask(): Appearance {
    const device = this.#dark.matches ? 'dark' : 'light';
    return shown[getComputedStyle(this.#host).columnRuleColor] ?? device;
  }

  readonly #changed = (): void => {
    this.#around = undefined;
    this.#host.requestUpdate();
  };
}
