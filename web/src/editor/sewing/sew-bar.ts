/** Progress of sewing, actions for the chosen run, and answers to an open question. */
import {css, html, nothing, svg, type TemplateResult} from 'lit';

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
      figure {
        position: relative;
        margin: 0 0 var(--sw-space-1);
        border-radius: var(--sw-radius);
        background: var(--sw-ground);
        overflow: hidden;
      }
      svg {
        display: block;
        width: 100%;
        height: clamp(5.5rem, 16vh, 9rem);
      }
      .side {
        position: absolute;
        left: var(--sw-space-2);
        max-width: 45%;
        color: var(--sw-soft);
        font-size: var(--sw-text);
        line-height: 1.2;
      }
      .side:first-of-type {
        top: var(--sw-space-1);
      }
      .side:last-of-type {
        bottom: var(--sw-space-1);
      }
      svg path {
        fill: none;
        stroke-linejoin: round;
        vector-effect: non-scaling-stroke;
      }
      svg .piece {
        fill: var(--sw-paper);
        stroke: var(--sw-strong-line);
      }
      svg .edge {
        stroke: var(--sw-accent);
        stroke-width: 3;
      }
      svg .tie {
        stroke: var(--sw-accent);
        stroke-width: 1.5;
        stroke-dasharray: 3 3;
      }
    `,
  ];

  protected override render(): TemplateResult {
    const {chooser} = this;
    const {sew} = chooser;
    return html`${this.#picture()}
      <div class="bar" role="group" aria-label=${sew.actions}>
        <span class="count">${this.#count()}</span>
        ${this.#question()} ${this.#ofRun()}
        ${chooser.question ? nothing : this.#button(sew.next, {type: 'next'}, 'N')}
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

  /** Progress of the questions, or the number of sewn edges. */
  #count(): string {
    const {chooser} = this;
    const {progress} = chooser;
    return progress ? chooser.sew.progress(progress.present, progress.all) : chooser.countWords();
  }

  /** Both sides of the seam in question. */
  #picture(): TemplateResult | typeof nothing {
    const {picture, sides, sew} = this.chooser;
    if (!picture) return nothing;
    const lines = (look: string, paths: readonly string[]) =>
      paths.map((path) => svg`<path class=${look} d=${path}></path>`);
    return html`<figure>
      <svg viewBox=${picture.box.join(' ')} role="img" aria-label=${sew.picture}>
        ${lines('piece', picture.pieces)} ${lines('tie', picture.ties)}
        ${lines('edge', picture.edges)}
      </svg>
      ${sides.map((name) => html`<span class="side">${name}</span>`)}
    </figure>`;
  }

  /** Buttons for answers, and for all certain seams at once. */
  #question(): TemplateResult | typeof nothing {
    const {chooser} = this;
    const {sew, question} = chooser;
    const {state} = this;
    const sure = state.suggests ? (chooser.sewing?.sure().length ?? 0) : 0;
    return html`${
      question
        ? html`${this.#button(sew.yes, {type: 'yes'}, 'Y', 'primary')}
          ${this.#button(sew.no, {type: 'no'}, 'N')}
          ${question.kind === 'seam' ? this.#button(sew.skip, {type: 'skip'}, 'L') : nothing}
          ${
            question.kind === 'gathered' && question.instead
              ? this.#button(sew.join, {type: 'join'}, 'M')
              : nothing
          }`
        : nothing
    }
    ${state.suggests && state.log.length > 0 && state.run.length === 0 ? this.#back() : nothing}
    ${
      sure > 0 && state.run.length === 0
        ? this.#button(sew.acceptAll(sure), {type: 'acceptAll'}, 'A')
        : nothing
    }`;
  }

  /** Takes the last answer back. */
  #back(): TemplateResult {
    const {sew} = this.chooser;
    return html`<button
      class="outlined"
      title="${sew.back} (B)"
      @click=${() => {
        this.chooser.unanswer();
      }}
    >
      ${sew.back}
    </button>`;
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
