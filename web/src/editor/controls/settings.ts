/** Language, units, theme and scale of the page, behind one button. */
import {css, html, type TemplateResult} from 'lit';

import {WorkbenchElement} from '../base/workbench-element.js';
import {controls, placeUnder} from '../style/controls.js';
import {icon} from '../style/icons.js';
import {languageNames, type Preferences} from '../../texts/preferences.js';

export class Settings extends WorkbenchElement {
  static override styles = [
    controls,
    css`
      button {
        width: var(--sw-target);
        padding: 0;
      }
      select {
        color: var(--sw-ink);
      }
      [popover] {
        width: 17rem;
      }
      [popover]:popover-open {
        display: grid;
        gap: var(--sw-space-3);
      }
    `,
  ];

  protected override render(): TemplateResult {
    const {app, controls: texts} = this.texts;
    const {language, units, theme, scale} = this.workbench.preferences.chosen;
    return html`
      <button popovertarget="panel" aria-label=${app.settings} title=${app.settings}>
        ${icon.settings}
      </button>
      <div
        id="panel"
        popover
        role="group"
        aria-label=${app.settings}
        @beforetoggle=${({currentTarget}: Event) => {
          placeUnder(this.renderRoot.querySelector('button'), currentTarget as HTMLElement);
        }}
      >
        ${this.#choice('language', app.language, language, languageNames)}
        ${this.#choice('units', app.units, units, texts.unitNames)}
        ${this.#choice('theme', app.theme, theme, app.themes)}
        <label class="inline">
          <input
            type="checkbox"
            .checked=${scale === 'paper'}
            @change=${(event: Event) => {
              const {checked} = event.target as HTMLInputElement;
              this.workbench.prefer({scale: checked ? 'paper' : 'absolute'});
            }}
          />
          ${texts.paperScale}
        </label>
      </div>
    `;
  }

  #choice<Name extends 'language' | 'units' | 'theme'>(
    name: Name,
    label: string,
    value: Preferences[Name],
    options: Readonly<Record<Preferences[Name], string>>,
  ): TemplateResult {
    return html`<label>
      ${label}
      <select
        @change=${(event: Event) => {
          this.workbench.prefer({[name]: (event.target as HTMLSelectElement).value});
        }}
      >
        ${Object.entries(options).map(
          ([option, words]) =>
            html`<option value=${option} .selected=${option === value}>${words}</option>`,
        )}
      </select>
    </label>`;
  }
}
