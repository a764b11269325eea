/**
 * Visible seams that match in other sizes and turns of the print. The sizes form a chart; the best
 * size or turn is offered.
 */
import {css, html, nothing, svg, type TemplateResult} from 'lit';

import {noPicture, type Design, type DesignPrint} from '../../model/design/design.js';
import type {PrintComparison, VariantAnswer} from '../../workbench/print-sizes.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';

/** Size of the chart, width of a bar, and height of a bar without a seam. [px] */
const [width, height, bar, leastHeight] = [220, 48, 12, 2];

export class PrintSize extends WorkbenchElement {
  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        justify-items: start;
        gap: var(--sw-space-2);
      }
      svg {
        display: block;
        max-width: 100%;
      }
      rect {
        fill: var(--sw-line);
      }
      rect.best {
        fill: var(--sw-accent);
      }
      rect.present {
        fill: var(--sw-soft);
      }
    `,
  ];

  protected override render(): TemplateResult | typeof nothing {
    const {design} = this.workbench.history;
    if (!design) return nothing;
    return html`${this.#onDemand(design.print)} ${this.#comparison(design)}`;
  }

  /** Asks about the user's own print, since fabric that is printed already has one size. */
  #onDemand(print: DesignPrint): TemplateResult | typeof nothing {
    const isShop = this.workbench.searches.offeredSizes !== undefined;
    if (isShop || print.sample || print.unscaled || print.image === noPicture) return nothing;
    const {sizes} = this.texts.print;
    return html`<label class="inline" title=${sizes.onDemandNote}>
      <input
        type="checkbox"
        .checked=${!print.isPrinted}
        @change=${({target}: Event) => {
          const isPrinted = !(target as HTMLInputElement).checked || undefined;
          this.workbench.history.change({print: {...print, isPrinted}});
        }}
      />
      ${sizes.onDemand}
    </label>`;
  }

  #comparison(design: Design): TemplateResult | typeof nothing {
    const {afterwards, searches, history, solving} = this.workbench;
    const {result, state} = solving;
    if (!result || state.kind !== 'done' || result.seams.length === 0) return nothing;
    if (!searches.hasOtherSizes(design)) return nothing;
    const {sizes} = this.texts.print;
    const known = searches.printSizes(design);
    if (!known) {
      return html`<button
        class="link"
        title=${sizes.note}
        @click=${() => void afterwards.search('sizes', design, result)}
      >
        ${sizes.compare}
      </button>`;
    }
    const {better, isRunning} = known;
    return html`${known.sizes.length > 1 ? this.#chart(known) : nothing}
      <p class="soft" role="status" .textContent=${this.#words(known)}></p>
      ${
        isRunning
          ? html`<button
              class="link"
              @click=${() => {
                searches.end('sizes', design);
              }}
            >
              ${sizes.stop}
            </button>`
          : nothing
      }
      ${
        better
          ? html`<button
              class="outlined"
              @click=${() => {
                history.change({print: better.design.print}, 'print size');
              }}
            >
              ${this.#offer(better, known)}
            </button>`
          : nothing
      }`;
  }

  /** "At 93 % 12 of 14 visible seams match, now 9." */
  #words({present, better, isRunning}: PrintComparison): string {
    const {sizes} = this.texts.print;
    if (!better) return isRunning ? sizes.comparing : sizes.nothing;
    const {format} = this;
    const [matched = '', visible = '', now = ''] = [
      better.standing.matched,
      better.standing.visible,
      present.standing.matched,
    ].map((count) => format.number(count));
    return isTurned(better, present)
      ? sizes.foundTurned(format.number(turnTo(better, present)), matched, visible, now)
      : sizes.found(format.percent(better.variant.scale), matched, visible, now);
  }

  #offer(better: VariantAnswer, {present}: PrintComparison): string {
    const {sizes} = this.texts.print;
    return isTurned(better, present)
      ? sizes.turn(this.format.number(turnTo(better, present)))
      : sizes.use(this.format.percent(better.variant.scale));
  }

  /** A bar for each size, as high as its number of matching seams; the highest fills the chart. */
  #chart({sizes: answers, present, better}: PrintComparison): TemplateResult {
    const {sizes} = this.texts.print;
    const scales = answers.map(({variant}) => variant.scale);
    const [least, most] = [Math.min(...scales), Math.max(...scales)];
    const mostMatched = Math.max(1, ...answers.map(({standing}) => standing.matched));
    const bars = answers.map((answer) => {
      const {variant, standing} = answer;
      const at = (variant.scale - least) / (most - least);
      const high = Math.max(leastHeight, (height * standing.matched) / mostMatched);
      const kind = answer === present ? 'present' : answer === better ? 'best' : '';
      const label = `${this.format.percent(variant.scale)}: ${this.format.number(standing.matched)}`;
      return svg`<rect class=${kind} x=${at * (width - bar)} y=${height - high}
        width=${bar} height=${high}><title>${label}</title></rect>`;
    });
    return html`<svg
      role="img"
      aria-label=${sizes.chart}
      viewBox="0 0 ${width} ${height}"
      width=${width}
      height=${height}
    >
      ${bars}
    </svg>`;
  }
}

const isTurned = (one: VariantAnswer, present: VariantAnswer): boolean =>
  one.variant.turnDeg !== present.variant.turnDeg;

/** Turn from the present print to another one. [degrees] */
const turnTo = (one: VariantAnswer, present: VariantAnswer): number =>
  one.variant.turnDeg - present.variant.turnDeg;
