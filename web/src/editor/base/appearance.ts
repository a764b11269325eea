/** Light or dark appearance of a part: the user's choice, or that of its surroundings. */
import {css, type ReactiveController} from 'lit';

import type {Appearance} from '../../viewer/strokes.js';
import type {WorkbenchElement} from './workbench-element.js';

/**
 * Styles for hosts of an `AppearanceController`. `column-rule-color`, which is invisible there,
 * shows the computed `color-scheme`; its transition fires `transitionend` once that scheme changes.
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
  /** Cached, since reading it at every update would recompute the page's styles each time. */
  #around: Appearance | undefined;

  constructor(host: WorkbenchElement) {
    this.#host = host;
    host.addController(this);
  }

  get value(): Appearance {
    const {theme} = this.#host.workbench.preferences.chosen;
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
