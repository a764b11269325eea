/** Settings of the solver: greatest change of pieces, grain, cutting and method. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {GrainLock} from '../../model/garment/grain.js';
import {methods, type Method} from '../../model/result/method.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {
  solveSettingsOf,
  presetNames,
  presetOf,
  withSolveSettings,
  withPreset,
  type SolveSettings,
} from '../../workbench/presets.js';
import {section} from './section.js';

const grainLocks: readonly GrainLock[] = ['on', 'across', 'bias', 'free'];

/** The greatest change is entered in millimetres or inches. */
const changeUnit = {
  cm: {name: 'mm', cm: 0.1, step: 1, digits: 1},
  inch: {name: 'in', cm: 2.54, step: 0.05, digits: 3},
} as const;
const leastChangeCm = 0;
const mostChangeCm = 2;

const chosen = (event: Event): string => (event.target as HTMLSelectElement).value;

export class SolvePanel extends WorkbenchElement {
  static override styles = [
    controls,
    section,
    css`
      .presets {
        display: grid;
        grid-template-columns: minmax(0, 1fr);
        gap: var(--sw-space-1);
      }
      .presets button {
        justify-content: start;
        line-height: 1.2;
        text-align: start;
        white-space: normal;
      }
      [role='switch'] {
        justify-content: space-between;
        width: 100%;
        padding: 0;
      }
      [role='switch']:hover {
        background: none;
      }
      .track {
        width: 2.25rem;
        height: 1.25rem;
        padding: 2px;
        border: 1px solid var(--sw-strong-line);
        border-radius: 1rem;
        background: var(--sw-raised);
      }
      .track::before {
        content: '';
        display: block;
        height: 100%;
        aspect-ratio: 1;
        border-radius: 50%;
        background: var(--sw-strong-line);
      }
      [aria-checked='true'] .track {
        border-color: var(--sw-accent);
        background: var(--sw-accent);
      }
      [aria-checked='true'] .track::before {
        margin-left: auto;
        background: var(--sw-on-accent);
      }
    `,
  ];

  protected override render(): TemplateResult | typeof nothing {
    const {design} = this.workbench.history;
    if (!design) return nothing;
    const texts = this.texts.controls;
    const settings = solveSettingsOf(design);
    const preset = presetOf(design);
    return html`<section aria-labelledby="title">
      <h2 id="title">${texts.fit}</h2>
      <div class="presets" role="group" aria-label=${texts.presets}>
        ${presetNames.map(
          (name) =>
            html`<button
              class="outlined"
              aria-pressed=${name === preset}
              title=${texts.presetNotes[name]}
              @click=${() => {
                this.workbench.history.change(withPreset(design, name));
              }}
            >
              ${texts.presetNames[name]}
            </button>`,
        )}
        ${preset ? html`<p class="soft">${texts.presetNotes[preset]}</p>` : nothing}
      </div>
      ${this.#change(settings)}
      <label>
        ${texts.grain}
        <select
          @change=${(event: Event) => {
            this.#set({grain: chosen(event) as GrainLock});
          }}
        >
          ${grainLocks.map(
            (lock) =>
              html`<option value=${lock} .selected=${lock === settings.grain}>
                ${texts.grains[lock]}
              </option>`,
          )}
        </select>
      </label>
      <div>
        <label class="inline">
          <input
            type="checkbox"
            aria-describedby="continuous"
            .checked=${settings.continuousOnly}
            @change=${(event: Event) => {
              this.#set({continuousOnly: (event.target as HTMLInputElement).checked});
            }}
          />
          ${texts.continuousOnly}
        </label>
        <p id="continuous" class="soft beside">${texts.continuousNote}</p>
      </div>
      <label class="inline">
        <input
          type="checkbox"
          .checked=${design.options.openEdges !== 'free'}
          @change=${({target}: Event) => {
            const openEdges = (target as HTMLInputElement).checked ? 'kept' : 'free';
            this.workbench.history.change({options: {...design.options, openEdges}});
          }}
        />
        ${this.texts.keep.openEdges}
      </label>
      <details>
        <summary>${texts.method}</summary>
        <select
          aria-label=${texts.method}
          @change=${(event: Event) => {
            this.#set({method: chosen(event) as Method});
          }}
        >
          ${methods.map(
            (method) =>
              html`<option value=${method} .selected=${method === settings.method}>
                ${texts.methods[method]}
              </option>`,
          )}
        </select>
      </details>
      ${this.#solveAsIGo()}
    </section>`;
  }

  #change({maxChangeCm}: SolveSettings): TemplateResult {
    const texts = this.texts.controls;
    const {name, cm, step, digits} = changeUnit[this.workbench.preferences.chosen.units];
    const [least, most] = [leastChangeCm / cm, mostChangeCm / cm];
    return html`<sw-number-field
      .label=${texts.greatestChange(name)}
      .value=${maxChangeCm / cm}
      .least=${least}
      .most=${most}
      .step=${step}
      .digits=${digits}
      .fractions=${this.workbench.preferences.chosen.units === 'inch'}
      .wrong=${texts.between(this.format.fine(leastChangeCm), this.format.fine(mostChangeCm))}
      @entered=${({detail}: CustomEvent<number>) => {
        this.#set({maxChangeCm: detail * cm}, 'greatest change');
      }}
    ></sw-number-field>`;
  }

  #solveAsIGo(): TemplateResult {
    const {solveAsIGo} = this.workbench.preferences.chosen;
    return html`<button
      role="switch"
      aria-checked=${solveAsIGo}
      @click=${() => {
        this.workbench.prefer({solveAsIGo: !solveAsIGo});
      }}
    >
      ${this.texts.controls.solveAsIGo}
      <span class="track"></span>
    </button>`;
  }

  #set(change: Partial<SolveSettings>, kind = ''): void {
    const {design} = this.workbench.history;
    if (design)
      this.workbench.history.change(
        withSolveSettings(design, {...solveSettingsOf(design), ...change}),
        kind,
      );
  }
}
