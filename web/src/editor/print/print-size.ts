/** Visible seams that match in other sizes of the print, as a chart; the best size is offered. */
import {css, html, nothing, svg, type TemplateResult} from 'lit';

import type {ComparedAnswer} from '../../model/design/solve-problem.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {bestSize, canResize, enlarged, type SizeComparison} from '../../workbench/print-sizes.js';

/** Size of the chart, and width of a bar. [px] */
const [width, height, bar] = [220, 48, 12];

export class PrintSize extends WorkbenchElement {
  static override styles = [
    controls,
    css`
      svg {
        display: block;
        margin-block: var(--sw-space-2);
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
    const {afterwards, history, solving} = this.workbench;
    const {design} = history;
    const {result, state} = solving;
    if (!design || !result || state.kind !== 'done' || result.seams.length === 0) return nothing;
    if (!canResize(design)) return nothing;
    const {sizes} = this.texts.print;
    const known = afterwards.printSizes(design);
    if (!known) {
      return html`<button
        class="link"
        title=${sizes.note}
        @click=${() => void afterwards.comparePrintSizes(design, result)}
      >
        ${sizes.compare}
      </button>`;
    }
    const best = bestSize(known);
    return html`${this.#chart(known, best)}
      <p class="soft" role="status" .textContent=${this.#words(known, best)}></p>
      ${
        known.isRunning
          ? html`<button
              class="link"
              @click=${() => {
                afterwards.stopPrintSizes();
              }}
            >
              ${sizes.stop}
            </button>`
          : nothing
      }
      ${
        best
          ? html`<button
              class="outlined"
              @click=${() => {
                history.change({print: enlarged(design.print, best.scale)}, 'print size');
              }}
            >
              ${sizes.use(this.format.percent(best.scale))}
            </button>`
          : nothing
      }`;
  }

  /** "At 93 % 12 of 14 visible seams match, now 9." */
  #words({answers, isRunning}: SizeComparison, best: ComparedAnswer | undefined): string {
    const {sizes} = this.texts.print;
    const [present] = answers;
    if (!best || !present) return isRunning ? sizes.comparing : sizes.nothing;
    const {format} = this;
    const [matched = '', visible = '', now = ''] = [
      best.matched,
      best.visible,
      present.matched,
    ].map((count) => format.number(count));
    return sizes.found(format.percent(best.scale), matched, visible, now);
  }

  /** A bar for each size, as high as its share of matching seams. */
  #chart({answers}: SizeComparison, best: ComparedAnswer | undefined): TemplateResult {
    const {sizes} = this.texts.print;
    const scales = answers.map(({scale}) => scale);
    const [least, most] = [Math.min(...scales), Math.max(...scales)];
    const bars = answers.map((answer, k) => {
      const {scale, matched, visible} = answer;
      const at = most > least ? (scale - least) / (most - least) : 0.5;
      const high = Math.max(2, (height * matched) / Math.max(1, visible));
      const kind = k === 0 ? 'present' : answer === best ? 'best' : '';
      const label = `${this.format.percent(scale)}: ${this.format.number(matched)}`;
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
