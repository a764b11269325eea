/** A better answer, looked for when somebody asks for it and for as long as they like. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {DeskElement} from '../desk-element.js';
import {controls} from '../style/controls.js';
import {mostEffort} from '../workbench/improvement.js';

export class KeepImproving extends DeskElement {
  static override styles = [
    controls,
    css`
      :host {
        display: flex;
        flex-wrap: wrap;
        align-items: baseline;
        min-height: 1.5rem;
        color: var(--sw-soft);
      }
      span:not(:empty) {
        margin-inline-end: var(--sw-space-2);
      }
    `,
  ];

  protected override render(): TemplateResult | typeof nothing {
    const {afterwards, design, result, state} = this.desk;
    if (!design || !result || state.kind !== 'done' || result.seams.length === 0) return nothing;
    const {improve} = this.texts;
    const improving = afterwards.improving(design);
    const isDone = 2 * (design.options.effort ?? 1) > mostEffort;
    return html`
      <span role="status" aria-label=${improve.label}>${this.#words(improving)}</span>
      ${
        improving?.isRunning
          ? this.#button(improve.stop, () => {
              afterwards.stopImproving();
            })
          : improving || isDone || design.method !== 'best'
            ? nothing
            : this.#button(improve.begin, () => {
                void afterwards.improve(design, result);
              })
      }
    `;
  }

  #words(improving: ReturnType<DeskElement['desk']['afterwards']['improving']>): string {
    const {improve} = this.texts;
    if (!improving) return '';
    const {isRunning, gained} = improving;
    if (gained === 0) return isRunning ? improve.looking : improve.nothing;
    const words = isRunning ? improve.soFar : improve.gained;
    return words(this.format.fine(gained));
  }

  #button(label: string, act: () => void): TemplateResult {
    return html`<button class="link" title=${this.texts.improve.note} @click=${act}>
      ${label}
    </button>`;
  }
}
