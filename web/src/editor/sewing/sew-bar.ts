/** Progress of sewing, actions for the chosen run, and answers to an open question. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {SeamEvent, SeamState} from '../../clicks/seam-tool.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import type {SeamChooser} from '../../workbench/sewing/seam-chooser.js';

export class SewBar extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    chooser: {attribute: false},
    state: {attribute: false},
  };
  declare chooser: SeamChooser;
  /** State of the chooser; the bar redraws after a change. */
  declare state: SeamState;

  static override styles = [
    controls,
    css`
      :host {
        display: block;
      }
      .bar {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: var(--sw-space-1);
      }
      .bar > * {
        flex: none;
      }
      button {
        padding: 0 var(--sw-space-2);
      }
      .candidates button {
        width: var(--sw-target);
        padding: 0;
        font-weight: 600;
      }
      .count {
        margin-right: auto;
        padding-right: var(--sw-space-2);
        color: var(--sw-soft);
        font-variant-numeric: tabular-nums;
        white-space: nowrap;
      }
      .candidates {
        display: flex;
        gap: var(--sw-space-1);
      }
    `,
  ];

  protected override render(): TemplateResult {
    const {chooser} = this;
    const {sew} = chooser;
    return html`<div class="bar" role="group" aria-label=${sew.actions}>
      <span class="count">${chooser.countWords()}</span>
      ${this.#question()} ${this.#ofRun()} ${this.#button(sew.next, {type: 'next'}, 'N')}
      <button
        class="outlined"
        aria-pressed=${this.state.suggests}
        title="${sew.suggest} (Q)"
        @click=${this.#sending({type: 'suggest'})}
      >
        ${sew.suggest}
      </button>
    </div>`;
  }

  /** Buttons for answers, and for all certain seams at once. */
  #question(): TemplateResult | typeof nothing {
    const {chooser} = this;
    const {sew, question} = chooser;
    const {state} = this;
    const sure = state.suggests ? (chooser.sewing?.sure().length ?? 0) : 0;
    return html`${
      sure > 0 && state.run.length === 0
        ? this.#button(sew.acceptAll(sure), {type: 'acceptAll'}, 'A')
        : nothing
    }
    ${
      question
        ? html`${this.#button(sew.yes, {type: 'yes'}, 'Y', 'primary')}
          ${this.#button(sew.no, {type: 'no'}, 'N')}
          ${question.kind === 'seam' ? this.#button(sew.skip, {type: 'skip'}, 'S') : nothing}
          ${
            question.kind === 'gathered' && question.instead
              ? this.#button(sew.join, {type: 'join'}, 'M')
              : nothing
          }`
        : nothing
    }`;
  }

  /** Buttons for the chosen run. */
  #ofRun(): TemplateResult | typeof nothing {
    const {chooser} = this;
    const {sew} = chooser;
    const {state} = this;
    if (state.run.length === 0 || chooser.question) return nothing;
    if (chooser.isSewn)
      return html`${this.#button(sew.turn, {type: 'turn'}, 'R')}
      ${this.#button(sew.unsew, {type: 'unsew'}, 'Del')} ${this.#split()}`;
    return html`<span class="candidates" role="group" aria-label=${sew.candidates}>
        ${chooser.candidates.map(
          ({b}, k) =>
            html`<button
              class="outlined"
              aria-label="${sew.sewIt} ${k + 1}: ${chooser.nameOf(b)}"
              title=${chooser.nameOf(b)}
              @click=${this.#sending({type: 'sewTo', candidate: k + 1})}
            >
              ${k + 1}
            </button>`,
        )}
      </span>
      ${this.#split()} ${this.#button(chooser.isOpen ? sew.notOpen : sew.open, {type: 'open'}, 'H')}`;
  }

  #split(): TemplateResult {
    const {sew} = this.chooser;
    return html`<button
      class="outlined"
      title="${sew.split} (P)"
      @click=${() => {
        this.chooser.split();
      }}
    >
      ${sew.split}
    </button>`;
  }

  #button(label: string, event: SeamEvent, key: string, look = 'outlined'): TemplateResult {
    return html`<button class=${look} title="${label} (${key})" @click=${this.#sending(event)}>
      ${label}
    </button>`;
  }

  #sending(event: SeamEvent): () => void {
    return () => {
      this.chooser.send(event);
    };
  }
}
