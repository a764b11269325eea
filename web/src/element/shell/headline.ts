/** How well the garment meets, in one sentence; under it the figures. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {Failure} from '../../model/failure.js';
import {carries, groupsThatCarry} from '../../model/repeat.js';
import type {Metrics} from '../../model/result.js';
import {DeskElement} from '../desk-element.js';
import {controls} from '../style/controls.js';
import {lastOf} from '../workbench/last-of.js';
import {matchOf} from '../workbench/match.js';

export class Headline extends DeskElement {
  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: var(--sw-space-2);
        padding: var(--sw-space-4);
      }
      h2 {
        font-size: var(--sw-text-title);
        font-weight: 600;
        line-height: 1.2;
        letter-spacing: -0.01em;
        text-wrap: balance;
      }
      output {
        color: var(--sw-soft);
      }
      sup {
        line-height: 0;
      }
      dl {
        display: grid;
        grid-template-columns: auto 1fr;
        gap: var(--sw-space-1) var(--sw-space-4);
        margin: var(--sw-space-2) 0 0;
        padding: var(--sw-space-3);
        border-radius: var(--sw-radius);
        background: var(--sw-tint);
      }
      dl > div {
        display: contents;
      }
      dt,
      dd {
        margin: 0;
      }
      details {
        color: var(--sw-soft);
      }
      summary {
        cursor: pointer;
      }
      ul {
        margin: var(--sw-space-1) 0 0;
        padding-left: var(--sw-space-4);
      }
    `,
  ];

  /** Asked for with every change of anything. */
  readonly #matchOf = lastOf(matchOf);

  protected override render(): TemplateResult | typeof nothing {
    const {result, state} = this.desk;
    const {headline, progress} = this.texts;
    if (state.kind === 'failed') {
      return this.#failed(state.failure);
    }
    if (!result) {
      if (state.kind === 'empty') return nothing;
      const text = state.kind === 'stale' ? progress.failed : progress.solving;
      return html`<h2 class="soft">${text}</h2>`;
    }
    const {mean, chance} = this.#matchOf(result);
    const fits = headline.fits(this.format.fine(mean), this.format.fine(chance));
    return html`
      <h2>${result.seams.length > 0 ? fits : headline.noSeams}</h2>
      <output aria-label=${headline.fit}>${this.#fit(result.metrics)}</output>
      ${this.#proof(result.metrics)} ${this.#cost(result.metrics)} ${this.#notes(result.notes)}
    `;
  }

  /** What went wrong, and the way out where there is one. */
  #failed({code, message}: Failure): TemplateResult {
    const {progress, symmetry} = this.texts;
    const {design} = this.desk;
    if (code !== 'symmetryGroup' || !design) {
      return html`<h2>${progress.failed}</h2>
        <p class="error" role="alert">${message}</p>`;
    }
    const {group} = design.print;
    return html`<h2>${progress.failed}</h2>
      <p class="error" role="alert">
        ${symmetry.wouldCarry(group, groupsThatCarry('piece').join(', '))}
      </p>
      <button
        class="outlined"
        @click=${() => {
          const symmetries = design.symmetries.filter(({kind}) => carries(group, kind));
          this.desk.change({symmetries});
        }}
      >
        ${symmetry.leaveOut}
      </button>`;
  }

  #fit({fit, fitRandom}: Metrics): TemplateResult {
    const {value, unit} = this.format.area(fit);
    const share = this.format.percent(fitRandom > 0 ? fit / fitRandom : 0);
    return html`${value} ${unit}<sup>2</sup>, ${this.texts.headline.percentOfRandom(share)}`;
  }

  /** Of the placing that was found before anything was deformed. */
  #proof({method, searchBound}: Metrics): TemplateResult | typeof nothing {
    if (method !== 'best') return nothing;
    const {proven, nearlyProven, unproven} = this.texts.headline;
    const left = this.format.percent(1 - searchBound);
    const text = searchBound === 1 ? proven : searchBound > 0.5 ? nearlyProven(left) : unproven;
    return html`<p class="soft">${text}</p>`;
  }

  #cost(metrics: Metrics): TemplateResult | typeof nothing {
    const without = this.desk.withoutSymmetry;
    if (!without) return nothing;
    // both are searches; without symmetry one is free to keep it
    const free = without.fit < metrics.fit ? without : metrics;
    const {headline} = this.texts;
    return html`<dl aria-label=${headline.cost}>
      <div>
        <dt>${headline.withSymmetry}</dt>
        <dd>${this.#fit(metrics)}</dd>
      </div>
      <div>
        <dt>${headline.withoutSymmetry}</dt>
        <dd>${this.#fit(free)}</dd>
      </div>
    </dl>`;
  }

  #notes(notes: readonly string[]): TemplateResult | typeof nothing {
    if (notes.length === 0) return nothing;
    return html`<details>
      <summary>${this.texts.headline.notes} (${notes.length})</summary>
      <ul>
        ${notes.map((note) => html`<li>${note}</li>`)}
      </ul>
    </details>`;
  }
}
