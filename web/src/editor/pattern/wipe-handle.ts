/** The line between before and after, and the handle that moves it. */
import {css, html, type PropertyValues, type TemplateResult} from 'lit';

import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';

/** Browsers use different names for the handle, which cannot share a rule. */
const thumb = css`
  pointer-events: auto;
  width: 2rem;
  height: 2rem;
  border: 1px solid var(--sw-strong-line);
  border-radius: 50%;
  background: var(--sw-paper);
  cursor: ew-resize;
`;

const focusedThumb = css`
  outline: 2px solid var(--sw-accent);
  outline-offset: 2px;
`;

/**
 * Fires `input` with the share of the width, from 0 to 1, as `detail`. `bare`: no text, and the
 * handle at the foot.
 */
export class WipeHandle extends WorkbenchElement {
  static override properties = {...WorkbenchElement.properties, split: {attribute: false}};
  declare split: number;

  static override styles = [
    controls,
    css`
      :host {
        position: absolute;
        inset: 0;
        pointer-events: none;
        --at: 50%;
      }
      .line {
        position: absolute;
        top: 0;
        bottom: 0;
        left: var(--at);
        width: 1.5rem;
        translate: -50% 0;
        /* soft, so that it is not taken for a seam */
        background: linear-gradient(
          to right,
          transparent,
          color-mix(in srgb, var(--sw-paper) 85%, transparent) 40% 60%,
          transparent
        );
      }
      input {
        position: absolute;
        left: -1rem;
        right: -1rem;
        top: 50%;
        width: calc(100% + 2rem);
        height: 2rem;
        margin: 0;
        translate: 0 -50%;
        appearance: none;
        background: none;
      }
      input::-webkit-slider-thumb {
        appearance: none;
        ${thumb}
      }
      input::-moz-range-thumb {
        ${thumb}
      }
      input:focus-visible {
        outline: none; /* it is as wide as the picture; the handle has one */
      }
      input:focus-visible::-webkit-slider-thumb {
        ${focusedThumb}
      }
      input:focus-visible::-moz-range-thumb {
        ${focusedThumb}
      }
      .mark {
        position: absolute;
        left: var(--at);
        top: 50%;
        translate: -50% -50%;
        color: var(--sw-soft);
      }
      .mark::before {
        content: '↔' / '';
      }
      .before,
      .after {
        position: absolute;
        bottom: var(--sw-space-2);
        padding: 0 var(--sw-space-2);
        border-radius: 4px;
        background: var(--sw-paper);
        color: var(--sw-soft);
      }
      .before {
        right: calc(100% - var(--at) + var(--sw-space-2));
      }
      .after {
        left: calc(var(--at) + var(--sw-space-2));
      }
      :host([bare]) :is(.before, .after) {
        display: none;
      }
      :host([bare]) .mark {
        top: calc(100% - 1rem);
      }
      :host([bare]) input {
        top: auto;
        bottom: 0;
        translate: none;
      }
    `,
  ];

  protected override updated(changed: PropertyValues<this>): void {
    if (changed.has('split')) this.style.setProperty('--at', `${this.split * 100}%`);
  }

  protected override render(): TemplateResult {
    const {pattern} = this.texts;
    return html`
      <div class="line"></div>
      <span class="before">${pattern.before}</span><span class="after">${pattern.after}</span>
      <input
        type="range"
        min="0"
        max="100"
        aria-label=${pattern.wipe}
        .value=${String(Math.round(this.split * 100))}
        @input=${(event: Event) => {
          event.stopPropagation();
          const detail = Number((event.target as HTMLInputElement).value) / 100;
          this.dispatchEvent(new CustomEvent('input', {detail}));
        }}
      />
      <div class="mark"></div>
    `;
  }
}
