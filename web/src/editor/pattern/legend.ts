/** Legend of the mismatch colours along seams. */
import {css, html, nothing, svg, type TemplateResult} from 'lit';

import {
  mismatchLine,
  mismatchSteps,
  stepLines,
  worstMismatch,
  type MismatchLine,
} from '../../scene/colours.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';

/** Part of a seam's line in the style of the pattern. [px] */
const stretch = ({colour, width, dash}: MismatchLine, from: number, to: number) =>
  svg`<path d="M${from} 5H${to}" stroke=${colour} stroke-width=${width}
    stroke-dasharray=${dash ? dash.map((part) => part / 2).join(' ') : 'none'}
    stroke-dashoffset=${from} />`;

const rampSteps = 24;
const rampWidth = 96;

/** Lines from perfect to worst, on the colour scale of the paper. */
const ramp = Array.from({length: rampSteps}, (_, k) => {
  const line = mismatchLine((worstMismatch.paper * (k + 0.5)) / rampSteps, 'paper');
  const to = ((k + 1) * rampWidth) / rampSteps;
  return stretch(line, (k * rampWidth) / rampSteps, to + 0.3);
});

const sampleWidth = 26;

export class Legend extends WorkbenchElement {
  static override styles = [
    controls,
    css`
      :host {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: 0 var(--sw-space-2);
        font-size: var(--sw-text);
        color: var(--sw-soft);
      }
      .dotted::before {
        content: '· · · ';
        font-weight: 700;
        letter-spacing: 0.05em;
      }
      .kept::before {
        content: '';
        display: inline-block;
        width: 1.5rem;
        height: 3px;
        margin-right: 0.4em;
        border-block: 1px solid currentcolor;
        vertical-align: 0.25em;
      }
      svg {
        display: block;
      }
      .step {
        display: inline-flex;
        align-items: center;
        gap: var(--sw-space-1);
        white-space: nowrap;
      }
    `,
  ];

  protected override render(): TemplateResult {
    const {legend} = this.texts;
    const {scale} = this.workbench.preferences.chosen;
    const scene = this.workbench.sheet.scenes?.now;
    return html`
      <span>${legend.title}</span>
      ${scale === 'paper' ? this.#ramp() : this.#steps()}
      <span class="dotted">${legend.notCounted}</span>
      ${scene?.kept ? html`<span class="kept">${this.texts.keep.kept}</span>` : nothing}
    `;
  }

  /** Samples for 1 mm, 3 mm, 6 mm and more, each in its line style. */
  #steps(): TemplateResult[] {
    const {legend} = this.texts;
    return stepLines.map((line, k) => {
      const bound = mismatchSteps[k] ?? mismatchSteps[2];
      const words = k < mismatchSteps.length ? legend.upTo : legend.over;
      return html`<span class="step">
        <svg width=${sampleWidth} height="10" viewBox="0 0 ${sampleWidth} 10" aria-hidden="true">
          ${stretch(line, 0, sampleWidth)}
        </svg>
        ${words(this.format.fine(bound))}
      </span>`;
    });
  }

  #ramp(): TemplateResult {
    const {legend} = this.texts;
    return html`<span>${legend.none}</span>
      <svg width=${rampWidth} height="10" viewBox="0 0 ${rampWidth} 10" aria-hidden="true">
        ${ramp}
      </svg>
      <span>${legend.andMore(this.format.fine(worstMismatch.paper))}</span>`;
  }
}
