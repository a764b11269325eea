/** Progress of the solve: a bar, and a text for screen readers at every quarter. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {keyed} from 'lit/directives/keyed.js';

import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {progressLine} from '../style/progress-line.js';

export class SolveProgress extends WorkbenchElement {
  static override styles = [
    controls,
    progressLine,
    css`
      :host {
        position: relative;
        display: block;
        min-width: 11rem;
        color: var(--sw-soft);
        text-align: right;
      }
      progress {
        inset: auto 0 -5px auto;
        border-radius: 2px;
        overflow: hidden;
        background: color-mix(in srgb, var(--sw-ink) 10%, transparent);
      }
      progress[hidden] {
        display: block;
        visibility: hidden;
      }
    `,
  ];

  protected override render(): TemplateResult {
    const {progress} = this.texts;
    const isSolving = this.workbench.solving.state.kind === 'solving';
    const words = this.#words();
    // a new element for each text, since a text that changes its width would count as a shift
    return html`
      <span role="status" aria-label=${progress.label}
        >${keyed(words, html`<span>${words}</span>`)}</span
      >
      <progress
        ?hidden=${!isSolving}
        aria-hidden="true"
        max="1"
        .value=${isSolving ? this.workbench.running.progress.fraction : 0}
      ></progress>
    `;
  }

  #words(): string | typeof nothing {
    const {progress} = this.texts;
    const {state, result} = this.workbench.solving;
    switch (state.kind) {
      case 'solving': {
        const {phase, fraction} = this.workbench.running.progress;
        const quarter = Math.floor(fraction * 4) / 4;
        return progress[phase](this.format.percent(quarter));
      }
      case 'done':
        return progress.done(this.format.seconds(result?.metrics.milliseconds.total ?? 0));
      case 'failed':
        return progress.failed;
      case 'stale':
        return state.cancelled ? progress.cancelled : progress.stale;
      case 'opening':
        return nothing;
      case 'empty':
        return progress.empty;
    }
  }
}
