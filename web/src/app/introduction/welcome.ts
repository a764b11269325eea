/**
 * Three ways to begin, on a first visit. Sends `pattern`, `fabric` or `sample` for the chosen one,
 * and `done` after the first action.
 */
import {css, html, type TemplateResult} from 'lit';

import {controls} from '../../editor/style/controls.js';
import {WorkbenchElement} from '../../editor/base/workbench-element.js';
import {icon} from '../../editor/style/icons.js';

/** Cards without a sentence above them. */
const oneRow = css`
  .cards {
    grid-template-columns: repeat(3, minmax(0, 1fr)) auto;
  }
  .card,
  .icon {
    grid-area: auto;
  }
  p {
    display: none;
  }
`;

export class Welcome extends WorkbenchElement {
  static override styles = [
    controls,
    css`
      :host {
        display: block;
        padding: var(--sw-space-3);
        border-top: 1px solid var(--sw-line);
        background: var(--sw-paper);
      }
      .cards {
        display: grid;
        grid-template-columns: repeat(3, minmax(0, 1fr));
        gap: var(--sw-space-2);
        max-width: 44rem;
        margin: auto;
      }
      p {
        grid-area: 1 / 1 / 2 / -1;
        align-self: center;
        padding: 0 var(--sw-space-2);
        font-weight: 600;
      }
      .card {
        grid-row: 2;
        display: grid;
        justify-items: start;
        justify-content: start;
        align-content: center;
        gap: 0;
        padding: var(--sw-space-2) var(--sw-space-3);
        border: 1px solid var(--sw-line);
        text-align: start;
        white-space: normal;
      }
      strong {
        font-size: var(--sw-text-large);
        font-weight: 600;
      }
      .icon {
        grid-area: 1 / 1 / 2 / -1;
        place-self: start end;
      }
      /* the header has the sentence, or there is hardly room for it */
      @container (width >= 84rem) {
        ${oneRow}
      }
      @media (height < 32rem) {
        ${oneRow}
      }
      @container (width < 40rem) {
        :host {
          padding: var(--sw-space-2);
        }
        .cards {
          gap: var(--sw-space-1);
        }
        .card {
          padding: var(--sw-space-2);
        }
        .card span {
          display: none;
        }
        strong {
          font-size: var(--sw-text);
        }
      }
      @media (height < 32rem) {
        .card span {
          display: none;
        }
      }
    `,
  ];

  #beginnings = 0;
  #end: (() => void) | undefined;

  override connectedCallback(): void {
    super.connectedCallback();
    this.#beginnings = this.workbench.history.beginnings;
    this.#end = this.workbench.subscribe(['history'], () => {
      const {beginnings, canUndo} = this.workbench.history;
      // the first beginning is the sample of this visit
      if (canUndo || beginnings > this.#beginnings + 1) this.#send('done');
    });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#end?.();
  }

  protected override render(): TemplateResult {
    const {app, introduction, print} = this.texts;
    return html`<div class="cards" role="group" aria-label=${introduction.label}>
      <p>${app.tagline}</p>
      ${this.#card('pattern', app.openGarment, introduction.pattern)}
      ${this.#card('fabric', print.open, introduction.fabric)}
      ${this.#card('sample', introduction.sample, introduction.samples)}
      <button
        class="icon"
        aria-label=${app.dismiss}
        title=${app.dismiss}
        @click=${() => {
          this.#send('done');
        }}
      >
        ${icon.close}
      </button>
    </div>`;
  }

  #card(way: 'pattern' | 'fabric' | 'sample', title: string, note: string): TemplateResult {
    return html`<button
      class="card"
      aria-label="${title}: ${note}"
      @click=${() => {
        this.#send(way);
        this.#send('done');
      }}
    >
      <strong>${title}</strong><span class="soft">${note}</span>
    </button>`;
  }

  #send(type: string): void {
    this.dispatchEvent(new CustomEvent(type));
  }
}
