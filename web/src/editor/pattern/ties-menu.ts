/** Menu of the lines that a click may refer to, if several are about equally near. */
import {css, html, LitElement, type PropertyValues, type TemplateResult} from 'lit';

import type {Point} from '../../model/geometry/vectors.js';
import {controls} from '../style/controls.js';

interface TiedChoice {
  readonly text: string;
  readonly choose: () => void;
  readonly point: () => void;
}

/** Fires `close` if the user chooses nothing. */
export class TiesMenu extends LitElement {
  static override properties = {
    at: {attribute: false},
    choices: {attribute: false},
    label: {attribute: false},
  };
  declare at: Point;
  declare choices: readonly TiedChoice[];
  declare label: string;

  static override styles = [
    controls,
    css`
      :host {
        position: absolute;
        z-index: 3;
        display: grid;
        max-width: 18rem;
        padding: var(--sw-space-1);
        border: 1px solid var(--sw-line);
        border-radius: var(--sw-radius);
        background: var(--sw-raised);
        box-shadow: 0 4px 16px rgb(0 0 0 / 0.14);
      }
      button {
        justify-content: start;
        width: 100%;
        overflow: hidden;
        text-overflow: ellipsis;
      }
    `,
  ];

  protected override firstUpdated(): void {
    this.renderRoot.querySelector('button')?.focus();
  }

  protected override updated(changed: PropertyValues<this>): void {
    if (!changed.has('at')) return;
    this.style.left = `${this.at[0]}px`;
    this.style.top = `${this.at[1]}px`;
  }

  protected override render(): TemplateResult {
    return html`<div
      role="menu"
      aria-label=${this.label}
      @keydown=${(event: KeyboardEvent) => {
        this.#key(event);
      }}
    >
      ${this.choices.map(
        ({text, choose, point}) =>
          html`<button role="menuitem" @click=${choose} @focus=${point} @pointerenter=${point}>
            ${text}
          </button>`,
      )}
    </div>`;
  }

  #key(event: KeyboardEvent): void {
    event.stopPropagation();
    if (event.key === 'Escape') this.dispatchEvent(new Event('close'));
    const step = {ArrowDown: 1, ArrowUp: -1}[event.key];
    if (step === undefined) return;
    event.preventDefault();
    const items = [...this.renderRoot.querySelectorAll('button')];
    const at = items.findIndex((item) => item === this.shadowRoot?.activeElement);
    items[(at + step + items.length) % items.length]?.focus();
  }
}
