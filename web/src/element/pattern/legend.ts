/** What the colours along the seams mean. */
import {css, html, nothing, svg, type TemplateResult} from 'lit';

import {mismatchColour, mismatchDash, mismatchWidth, worstMismatch} from '../../picture/colours.js';
import {DeskElement} from '../desk-element.js';
import {controls} from '../style/controls.js';

const steps = 24;
const width = 96;

/** The line of a seam from perfect to worst, as it is drawn on the pattern. */
const ramp = Array.from({length: steps}, (_, k) => {
  const mismatch = (worstMismatch * (k + 0.5)) / steps;
  const [dash, gap] = mismatchDash(mismatch) ?? [0, 0];
  const [from, to] = [(k * width) / steps, ((k + 1) * width) / steps];
  return svg`<path d="M${from} 5H${to + 0.3}" stroke=${mismatchColour(mismatch)}
    stroke-width=${mismatchWidth(mismatch)}
    stroke-dasharray=${gap > 0 ? `${dash / 2} ${gap / 2}` : 'none'}
    stroke-dashoffset=${from} />`;
});

export class Legend extends DeskElement {
  static override styles = [
    controls,
    css`
      :host {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: 0 var(--sw-space-2);
        font-size: var(--sw-text-small);
        color: var(--sw-soft);
      }
      .dotted::before {
        content: '· · · ';
        font-weight: 700;
        letter-spacing: 0.05em;
      }
      svg {
        display: block;
      }
      button {
        min-height: 1.75rem;
        padding: 0 var(--sw-space-2);
        font-size: var(--sw-text-small);
        color: var(--sw-soft);
      }
    `,
  ];

  protected override render(): TemplateResult {
    const {legend} = this.texts;
    const {scale} = this.desk.preferences;
    const scene = this.desk.scenes?.now;
    const chance = scene?.chance ?? 0;
    const worst = scale === 'paper' ? worstMismatch : chance;
    const words = scale === 'paper' ? legend.paper : legend.chance;
    return html`
      <span>${legend.title}</span>
      <span>${legend.none}</span>
      <svg width=${width} height="10" viewBox="0 0 ${width} 10" aria-hidden="true">${ramp}</svg>
      <span>${words(this.format.fine(worst))}</span>
      ${
        scene?.seams.some(({counts}) => !counts)
          ? html`<span class="dotted">${legend.notCounted}</span>`
          : nothing
      }
      <button
        aria-pressed=${scale === 'paper'}
        title=${legend.asPaperNote}
        @click=${() => {
          this.desk.prefer({scale: scale === 'paper' ? 'chance' : 'paper'});
        }}
      >
        ${legend.asPaper}
      </button>
    `;
  }
}
