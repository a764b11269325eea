/** A better match from the longer search, and a sign that the search is running. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';

export class BetterMatch extends WorkbenchElement {
  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: var(--sw-space-1);
      }
      p {
        display: flex;
        flex-wrap: wrap;
        align-items: baseline;
        gap: var(--sw-space-2);
      }
      [role='status']:empty {
        display: none;
      }
    `,
  ];

  protected override render(): TemplateResult | typeof nothing {
    const {searches, history, solving} = this.workbench;
    const {design} = history;
    if (!design || !solving.result || solving.state.kind !== 'done') return nothing;
    const {longer} = this.texts;
    const better = searches.better(design);
    return html`
      <p role="status" aria-label=${longer.label}>
        ${
          better &&
          html`${longer.better(better.gained)}
            <button
              class="outlined"
              @click=${() => {
                history.change({seed: better.seed});
              }}
            >
              ${longer.use}
            </button>`
        }
      </p>
      ${
        searches.isRunning('longer', design)
          ? html`<p class="soft">
              ${longer.running}
              <button
                class="link"
                @click=${() => {
                  searches.end('longer', design);
                }}
              >
                ${longer.stop}
              </button>
            </p>`
          : nothing
      }
    `;
  }
}
