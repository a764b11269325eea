/** Changes that make seams match, each at one click, apart from those that the list of seams offers. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {seamCount} from '../../model/result/seam-groups.js';
import type {Remedy} from '../../remedies/remedy.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {isInLine} from '../../workbench/lists/group-actions.js';
import {groupRows} from '../../workbench/lists/group-rows.js';
import {controls} from '../style/controls.js';
import type {Samples} from '../../workbench/samples.js';
import {remedied, remedyWords} from '../../workbench/remedies/remedied.js';

export class RemedyList extends WorkbenchElement {
  static override properties = {...WorkbenchElement.properties, samples: {attribute: false}};
  declare samples: Samples | undefined;

  static override styles = [
    controls,
    css`
      div {
        display: grid;
        gap: var(--sw-space-2);
      }
      button {
        height: auto;
        min-height: max(2.25rem, var(--sw-target));
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
    const {matched, counted} = seamCount(result.seamGroups ?? [], design.options.weights);
    const rows = groupRows(this.workbench, this.texts);
    const remedies = afterwards
      .remedies(design)
      // a smaller print is no help where all seams that are seen match
      .filter(({kind}) => kind !== 'smaller' || matched < counted)
      .filter((remedy) => !rows.some((row) => isInLine(remedy, row)));
    return html`<div role="status" aria-label=${this.texts.remedies.help}>
      ${remedies.map((remedy) => this.#remedy(remedy))}
    </div>`;
  }

  #remedy(remedy: Remedy): TemplateResult | typeof nothing {
    const {design} = this.workbench.history;
    const change = design && remedied(design, remedy, this.samples);
    const words = remedyWords(remedy, this.workbench, this.texts, this.format);
    if (!change) return html`<p>${words}</p>`;
    return html`<button
      class="outlined"
      @click=${() => {
        this.workbench.history.change(change);
      }}
    >
      ${words}
    </button>`;
  }
}
