/** A notice. It disappears after enough time to read it, unless it is an error. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {undoAndSay} from '../../workbench/history/step-change.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import type {Notice} from '../../workbench/state.js';

/** Time of a notice: for looking up, and for every letter. [ms] */
const [least, perLetter] = [4000, 60];

export class NoticeBar extends WorkbenchElement {
  static override styles = [
    controls,
    css`
      :host {
        display: block;
        max-width: min(36rem, calc(100% - 2rem));
        pointer-events: none;
      }
      .notice {
        pointer-events: auto;
        display: flex;
        align-items: center;
        gap: var(--sw-space-3);
        padding: var(--sw-space-2) var(--sw-space-2) var(--sw-space-2) var(--sw-space-4);
        border: 1px solid var(--sw-line);
        border-radius: var(--sw-radius);
        background: var(--sw-raised);
        box-shadow: 0 2px 8px light-dark(rgb(38 40 44 / 0.12), rgb(0 0 0 / 0.4));
      }
      .notice.error {
        border-color: var(--sw-bad);
        background: var(--sw-bad-tint);
      }
      span {
        overflow-wrap: anywhere;
      }
      .close {
        width: var(--sw-target);
        padding: 0;
        flex: none;
      }
    `,
  ];

  #shown: Notice | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearTimeout(this.#timer);
  }

  protected override updated(): void {
    const {notice} = this.workbench.notices;
    if (notice === this.#shown) return;
    this.#shown = notice;
    this.#stay();
  }

  protected override render(): TemplateResult | typeof nothing {
    const {notice} = this.workbench.notices;
    if (!notice) return nothing;
    const {app} = this.texts;
    return html`<div
      class="notice ${notice.tone}"
      role=${notice.tone === 'error' ? 'alert' : 'status'}
      @pointerleave=${this.#stay}
      @focusout=${this.#stay}
    >
      <span>${notice.text}</span>
      ${
        notice.undo
          ? html`<button
              class="link"
              @click=${() => {
                undoAndSay(this.workbench);
              }}
            >
              ${app.undo}
            </button>`
          : nothing
      }
      ${
        notice.action
          ? html`<button class="link" @click=${notice.action.act}>${notice.action.label}</button>`
          : nothing
      }
      <button
        class="close"
        aria-label=${app.dismiss}
        title=${app.dismiss}
        @click=${() => {
          this.workbench.notices.say(undefined);
        }}
      >
        ${icon.close}
      </button>
    </div>`;
  }

  /** Restarts the timer. The notice also stays while it has the pointer or the focus. */
  readonly #stay = (): void => {
    clearTimeout(this.#timer);
    const {notice} = this.workbench.notices;
    if (!notice || notice.tone === 'error') return;
    this.#timer = setTimeout(
      () => {
        const isHeld = this.renderRoot.querySelector('.notice:is(:hover, :focus-within)');
        if (!isHeld && this.workbench.notices.notice === notice)
          this.workbench.notices.say(undefined);
      },
      least + perLetter * notice.text.length,
    );
  };
}
