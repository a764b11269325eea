/** Mismatch of the garment in one sentence, with the figures below. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {Failure} from '../../model/result/failure.js';
import type {MeshedPattern, Metrics, SolveResult} from '../../model/result/result.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {finalMismatch, mismatchOf, worstOf, type PatternMismatch} from '../../scene/mismatch.js';
import {seamRows} from '../../workbench/lists/rows.js';
import {lastOf} from '../../model/base/last-of.js';
import type {Samples} from '../../workbench/samples.js';
import {spokenNote} from '../../workbench/lists/spoken-note.js';

export class Headline extends WorkbenchElement {
  static override properties = {...WorkbenchElement.properties, samples: {attribute: false}};
  declare samples: Samples | undefined;

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

  /** Cached, since every update reads it. */
  readonly #mismatches = lastOf(mismatches);

  protected override render(): TemplateResult | typeof nothing {
    const {pattern, result, state} = this.workbench.solving;
    const {headline, progress} = this.texts;
    if (state.kind === 'failed') {
      return this.#failed(state.failure);
    }
    if (!result) {
      if (state.kind === 'empty') return nothing;
      const text = state.kind === 'stale' ? progress.failed : progress.solving;
      return html`<h2 class="soft">${text}</h2>`;
    }
    const {before, after} = this.#mismatches(result, pattern);
    const worst = worstOf(after);
    return html`
      <h2>${worst ? headline.fits(this.format.fine(after.mean)) : headline.noSeams}</h2>
      ${
        worst
          ? html`<output aria-label=${headline.fit}>
              ${headline.worst(this.format.fine(worst.mean), this.#seamName(worst.seam))}
              ${before && headline.before(this.format.fine(before.mean))}
            </output>`
          : nothing
      }
      <sw-keep-improving .workbench=${this.workbench}></sw-keep-improving>
      <sw-stays-off .workbench=${this.workbench} .samples=${this.samples}></sw-stays-off>
      ${this.#cost(after.mean)} ${this.#more(result.metrics)} ${this.#notes(result)}
    `;
  }

  #seamName(seam: number): string {
    return seamRows(this.workbench, this.texts)[seam]?.name ?? '';
  }

  #failed(failure: Failure): TemplateResult {
    return html`<h2>${this.texts.progress.failed}</h2>
      <sw-ways-out .workbench=${this.workbench} .failure=${failure}></sw-ways-out>`;
  }

  /** Figures for a comparison with the paper. */
  #more(metrics: Metrics): TemplateResult {
    const {fit, fitRandom} = metrics.continuous ?? metrics;
    const {value, unit} = this.format.area(fit);
    const share = this.format.percent(fitRandom > 0 ? fit / fitRandom : 0);
    const {headline} = this.texts;
    return html`<details>
      <summary>${headline.more}</summary>
      <p>${headline.area}: ${value} ${unit}<sup>2</sup>, ${headline.percentOfRandom(share)}</p>
      ${this.#proof(metrics)}
    </details>`;
  }

  /** Bound on the alignment that was found before the deformation. */
  #proof({method, searchBound}: Metrics): TemplateResult | typeof nothing {
    if (method !== 'best') return nothing;
    const {proven, nearlyProven, unproven} = this.texts.headline;
    const {afterwards} = this.workbench;
    const {design} = this.workbench.history;
    const bound = Math.max(searchBound, (design && afterwards.bound(design)) ?? 0);
    // rounds up to a whole per cent, so that the statement holds
    const left = this.format.percent(Math.ceil(100 * (1 - bound)) / 100);
    const text = bound === 1 ? proven : bound > 0.5 ? nearlyProven(left) : unproven;
    return html`<p>${text}</p>`;
  }

  /** @param mean mean mismatch with symmetry [cm] */
  #cost(mean: number): TemplateResult | typeof nothing {
    const {afterwards} = this.workbench;
    const {design} = this.workbench.history;
    const free = design && afterwards.withoutSymmetry(design);
    if (free === undefined) return nothing;
    const {headline} = this.texts;
    return html`<dl aria-label=${headline.cost}>
      <div>
        <dt>${headline.withSymmetry}</dt>
        <dd>${this.format.fine(mean)}</dd>
      </div>
      <div>
        <dt>${headline.withoutSymmetry}</dt>
        <dd>${this.format.fine(free)}</dd>
      </div>
    </dl>`;
  }

  #notes({notes, noteDetails}: SolveResult): TemplateResult | typeof nothing {
    if (notes.length === 0) return nothing;
    return html`<details>
      <summary>${this.texts.headline.notes} (${notes.length})</summary>
      <ul>
        ${notes.map(
          (note, k) =>
            html`<li>
              ${spokenNote(note, noteDetails?.[k], this.workbench, this.texts, this.format)}
            </li>`,
        )}
      </ul>
    </details>`;
  }
}

/** Returns the mismatch of the pieces as drafted, and of the result. */
function mismatches(
  result: SolveResult,
  pattern: MeshedPattern | undefined,
): {readonly before: PatternMismatch | undefined; readonly after: PatternMismatch} {
  const alignments = pattern?.pieces.map(({alignment}) => alignment) ?? [];
  return {before: pattern && mismatchOf(pattern, 'rest', alignments), after: finalMismatch(result)};
}
