/** The result in one headline and a few sentences, with the figures folded below. */
import {css, html, nothing, type PropertyValues, type TemplateResult} from 'lit';

import type {Failure} from '../../model/base/failure.js';
import type {Metrics, SolveResult} from '../../model/result/result.js';
import {countedGroups, seamCount} from '../../model/result/seam-groups.js';
import {countAt, groupMismatch} from '../../scene/group-states.js';
import {finalMismatch, mismatchOf, worstOf, type PatternMismatch} from '../../scene/mismatch.js';
import {lastOf} from '../../model/base/last-of.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {firstOff, groupRows} from '../../workbench/lists/group-rows.js';
import {seamRows} from '../../workbench/lists/rows.js';
import {gainOf, headlineOf, sentencesOf} from '../../workbench/lists/verdict.js';
import type {Samples} from '../../workbench/samples.js';
import {spokenNote} from '../../workbench/lists/spoken-note.js';

export class Headline extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    samples: {attribute: false},
    failed: {type: Boolean, reflect: true},
  };
  declare samples: Samples | undefined;
  /** Reflected for the layout, which then leaves room for the whole reason. */
  declare failed: boolean;

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: var(--sw-space-2);
        padding: var(--sw-space-4);
      }
      @media (pointer: coarse), (width < 40rem) {
        output .link {
          min-width: var(--sw-target);
        }
      }
      h2 {
        font-size: var(--sw-text-title);
        font-weight: 600;
        line-height: 1.2;
        letter-spacing: -0.01em;
        text-wrap: balance;
      }
      output {
        display: grid;
        gap: var(--sw-space-1);
        min-height: 6rem; /* what is below it stays in its place */
        align-content: start;
      }
      details {
        color: var(--sw-soft);
      }
      summary {
        cursor: pointer;
      }
      output p {
        display: var(--sw-sentences, block);
      }
      /* its room before it is loaded */
      sw-better-match {
        display: grid;
        min-height: 1.5rem;
      }
      ul {
        margin: var(--sw-space-1) 0 0;
        padding-left: var(--sw-space-4);
      }
    `,
  ];

  /** Cached, since every update reads it. */
  readonly #mismatches = lastOf(mismatches);

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    this.failed = this.workbench.solving.state.kind === 'failed';
  }

  protected override render(): TemplateResult | typeof nothing {
    const {result, state} = this.workbench.solving;
    const {headline, progress} = this.texts;
    if (state.kind === 'failed') return this.#failed(state.failure);
    if (!result) {
      if (state.kind === 'empty') return nothing;
      const text = state.kind === 'stale' ? progress.failed : headline.working;
      return html`<output aria-label=${headline.result}><h2 class="soft">${text}</h2></output>`;
    }
    return html`
      ${this.#verdict(result)}
      <sw-remedies .workbench=${this.workbench} .samples=${this.samples}></sw-remedies>
      ${this.#details(result)} ${this.#notes(result)}
      <sw-better-match .workbench=${this.workbench}></sw-better-match>
    `;
  }

  #verdict(result: SolveResult): TemplateResult {
    const {texts, format, workbench} = this;
    const {headline} = texts;
    const {design} = workbench.history;
    const {seamGroups: groups} = workbench.solving;
    const weights = design?.options.weights;
    const {before, after} = this.#mismatches(result);
    const counted = countedGroups(groups, weights);
    const judged = {
      ...{groups, weights, before: countAt(groups, weights, before.seams)},
      most: Math.max(0, ...counted.map((group) => groupMismatch(group, after.seams))),
    };
    const {language} = workbench.preferences.chosen;
    const gain = gainOf(judged, texts);
    const off = firstOff(groupRows(workbench, texts));
    return html`<output aria-label=${headline.result}>
      <h2>${headlineOf(judged, texts)}</h2>
      <p>
        ${sentencesOf(judged, texts, format, language).join(' ')}
        ${
          off &&
          this.#link(headline.show, () => {
            workbench.selection.select({kind: 'seam', seam: off.worst, side: 'a'});
          })
        }
        ${
          groups.length === 0
            ? this.#link(headline.suggest, () => {
                this.dispatchEvent(new Event('sw-sew-wanted', {bubbles: true, composed: true}));
              })
            : nothing
        }
      </p>
      ${gain === undefined ? nothing : html`<p class="soft">${gain}</p>`}
    </output>`;
  }

  #link(text: string, act: () => void): TemplateResult {
    return html`<button class="link" @click=${act}>${text}</button>`;
  }

  #failed(failure: Failure): TemplateResult {
    return html`<h2>${this.texts.progress.failed}</h2>
      <sw-ways-out .workbench=${this.workbench} .failure=${failure}></sw-ways-out>`;
  }

  /** Means, and figures for a comparison with the paper. */
  #details(result: SolveResult): TemplateResult {
    const {headline} = this.texts;
    const {metrics, print} = result;
    const {before, after} = this.#mismatches(result);
    const worst = worstOf(after);
    const {fit, fitRandom} = metrics.continuous ?? metrics;
    const {value, unit} = this.format.area(fit);
    const share = this.format.percent(fitRandom > 0 ? fit / fitRandom : 0);
    return html`<details>
      <summary>${headline.details}</summary>
      ${
        worst &&
        html`<p>${headline.mean(this.format.fine(after.mean), this.format.fine(before.mean))}</p>
          <p>${headline.worst(this.format.fine(worst.mean), this.#seamName(worst.seam))}</p>`
      }
      ${this.#cost()}
      <p>${headline.area(`${value} ${unit}²`, share)}</p>
      <p>${headline.group(print.group)}</p>
      ${this.#proof(metrics)}
    </details>`;
  }

  #seamName(seam: number): string {
    return seamRows(this.workbench, this.texts)[seam]?.name ?? '';
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

  /** The number of seams that would match only without symmetry. */
  #cost(): TemplateResult | typeof nothing {
    const {afterwards, solving, history} = this.workbench;
    const {design} = history;
    const free = design && afterwards.withoutSymmetry(design);
    if (!free) return nothing;
    const {matched} = seamCount(solving.seamGroups, design.options.weights);
    return html`<p>${this.texts.headline.cost(Math.max(0, free.matched - matched))}</p>`;
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

/** The mismatch of the pieces as drafted, laid on grain, and of the result. */
function mismatches(result: SolveResult): {
  readonly before: PatternMismatch;
  readonly after: PatternMismatch;
} {
  const drafted = result.drafted ?? result.pieces.map(({alignment}) => alignment);
  return {before: mismatchOf(result, 'rest', drafted), after: finalMismatch(result)};
}
