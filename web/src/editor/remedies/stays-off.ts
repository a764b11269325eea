/** Seams that do not match, the reasons, and remedies at one click. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {Remedy} from '../../remedies/remedy.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {offSeams, seamRows, type SeamRow} from '../../workbench/lists/rows.js';
import {controls} from '../style/controls.js';
import type {Samples} from '../../workbench/samples.js';
import {remedied, remedyWords} from '../../workbench/remedies/remedied.js';

/** Greatest number of listed seams; any others are only counted. */
const mostSeams = 3;

export class StaysOff extends WorkbenchElement {
  static override properties = {...WorkbenchElement.properties, samples: {attribute: false}};
  declare samples: Samples | undefined;

  static override styles = [
    controls,
    css`
      section {
        padding: var(--sw-space-3);
        border-radius: var(--sw-radius);
        background: var(--sw-tint);
      }
      ul {
        display: grid;
        gap: var(--sw-space-1);
        margin: var(--sw-space-1) 0 0;
        padding: 0;
        list-style: none;
      }
      li,
      li .link {
        text-align: start;
        white-space: normal;
      }
      li .link {
        display: inline;
      }
      .remedy {
        width: 100%;
        height: auto;
        min-height: max(2.25rem, var(--sw-target));
        margin-top: var(--sw-space-2);
        justify-content: start;
        padding-block: var(--sw-space-1);
        text-align: start;
        white-space: normal;
      }
    `,
  ];

  protected override render(): TemplateResult | typeof nothing {
    const {afterwards} = this.workbench;
    const {design} = this.workbench.history;
    const {result, state} = this.workbench.solving;
    if (!design || !result || state.kind !== 'done') return nothing;
    const off = offSeams(seamRows(this.workbench, this.texts));
    if (off.length === 0) return nothing;
    const {remedies} = this.texts;
    const left = off.length - mostSeams;
    return html`<section aria-labelledby="title">
      <h3 id="title">${remedies.title(off.length)}</h3>
      <ul>
        ${off.slice(0, mostSeams).map((row) => this.#seam(row))}
        ${left > 0 ? html`<li class="soft">${remedies.more(left)}</li>` : nothing}
      </ul>
      <div role="status" aria-label=${remedies.help}>
        ${afterwards.remedies(design).map((remedy) => this.#remedy(remedy))}
      </div>
    </section>`;
  }

  #seam(row: SeamRow): TemplateResult {
    const {remedies} = this.texts;
    return html`<li>
      <button
        class="link"
        @click=${() => {
          this.workbench.selection.select({kind: 'seam', seam: row.seam, side: 'a'});
        }}
      >
        ${row.name}</button
      >: ${this.format.fine(row.after)}${row.why ? html`, ${remedies.why[row.why]}` : nothing}
    </li>`;
  }

  #remedy(remedy: Remedy): TemplateResult | typeof nothing {
    const {design} = this.workbench.history;
    const change = design && remedied(design, remedy, this.samples);
    const words = remedyWords(remedy, this.workbench, this.texts, this.format);
    if (!change) return html`<p>${words}</p>`;
    return html`<button
      class="outlined remedy"
      @click=${() => {
        this.workbench.history.change(change);
      }}
    >
      ${words}
    </button>`;
  }
}
