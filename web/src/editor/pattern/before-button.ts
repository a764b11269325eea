/**
 * Button that shows the garment without pattern matching while it is pressed. Sends `hold` with
 * true or false as its detail. Assistive technology that only clicks switches it.
 */
import {css, html, type TemplateResult} from 'lit';

import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';

/** Keys that press a button. */
const pressing: ReadonlySet<string> = new Set([' ', 'Enter']);

export class BeforeButton extends WorkbenchElement {
  static override properties = {...WorkbenchElement.properties, isOn: {attribute: false}};
  /** The garment without pattern matching is on display. */
  declare isOn: boolean;

  static override styles = [
    controls,
    css`
      button {
        padding: 0 var(--sw-space-3) 0 var(--sw-space-2);
        touch-action: none;
        user-select: none;
      }
    `,
  ];

  constructor() {
    super();
    this.isOn = false;
  }

  protected override render(): TemplateResult {
    const {pattern} = this.texts;
    return html`<button
      title=${pattern.beforeHint}
      aria-pressed=${this.isOn}
      @pointerdown=${(event: PointerEvent) => {
        if (event.button !== 0) return;
        (event.currentTarget as Element).setPointerCapture(event.pointerId);
        this.#hold(true);
      }}
      @lostpointercapture=${() => {
        this.#hold(false);
      }}
      @keydown=${(event: KeyboardEvent) => {
        if (!pressing.has(event.key)) return;
        event.preventDefault(); // no click follows
        if (!event.repeat) this.#hold(true);
      }}
      @keyup=${({key}: KeyboardEvent) => {
        if (pressing.has(key)) this.#hold(false);
      }}
      @blur=${() => {
        if (this.isOn) this.#hold(false);
      }}
      @click=${({detail}: MouseEvent) => {
        if (detail === 0) this.#hold(!this.isOn);
      }}
    >
      ${icon.before} ${pattern.before}
    </button>`;
  }

  #hold(isOn: boolean): void {
    this.dispatchEvent(new CustomEvent('hold', {detail: isOn}));
  }
}
