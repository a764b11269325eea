/** A number field: a wrong entry shows a message beside the field and changes nothing. */
import {css, html, LitElement, nothing, type PropertyValues, type TemplateResult} from 'lit';
import {live} from 'lit/directives/live.js';

import {fractionOrNumber, numberTyped, type Units} from '../../model/base/length-text.js';
import {controls} from '../style/controls.js';

/** Units of length in labels of fields. */
export const lengthUnit: Readonly<Record<Units, {readonly name: string; readonly cm: number}>> = {
  cm: {name: 'cm', cm: 1},
  inch: {name: 'in', cm: 2.54},
};

/** Steps of the arrow keys. [in/8] */
const eighthsOf: Readonly<Record<string, number>> = {ArrowUp: 1, ArrowDown: -1};
/** Greatest difference between a limit and its displayed fraction. [in] */
const sixteenthMissed = 1 / 32;

/** Fires `entered` with the number as `detail` once a different, valid number has been entered. */
export class NumberField extends LitElement {
  static override properties = {
    label: {},
    sign: {},
    value: {type: Number},
    least: {type: Number},
    most: {type: Number},
    step: {type: Number},
    digits: {type: Number},
    fractions: {type: Boolean},
    wrong: {},
    subject: {attribute: false},
    typed: {state: true},
  };
  declare label: string;
  /** Sign behind the label; hidden from screen readers, which read the label alone. */
  declare sign: string;
  /** NaN for an empty field. */
  declare value: number;
  declare least: number;
  declare most: number;
  declare step: number;
  /** Number of decimals. */
  declare digits: number;
  /** The value is in inches, displayed as a fraction; 3/8 and 1 1/2 are valid entries. */
  declare fractions: boolean;
  /** Message for a wrong entry. */
  declare wrong: string;
  /** Object that the number belongs to; another subject discards a wrong entry. */
  declare subject: unknown;
  /** A wrong entry, and its text while the user corrects it. */
  declare protected typed: string | undefined;

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        align-content: start;
        gap: var(--sw-space-1);
      }
      input {
        color: var(--sw-ink);
      }
    `,
  ];

  constructor() {
    super();
    this.sign = '';
    this.step = 1;
    this.digits = 2;
    this.fractions = false;
  }

  /** True if the last entry was invalid: `value` then differs from the field's text. */
  get isWrong(): boolean {
    return this.typed !== undefined && !this.#isRight(this.typed);
  }

  override focus(options?: FocusOptions): void {
    this.renderRoot.querySelector('input')?.focus(options);
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('value') || changed.has('subject')) this.typed = undefined;
  }

  protected override render(): TemplateResult {
    const {isWrong} = this;
    return html`
      <label>
        ${this.label}${this.sign ? html`<span aria-hidden="true"> ${this.sign}</span>` : nothing}
        <input
          type=${this.fractions ? 'text' : 'number'}
          role=${this.fractions ? 'spinbutton' : nothing}
          inputmode=${this.fractions ? 'text' : 'decimal'}
          autocomplete="off"
          step=${this.fractions ? nothing : this.step}
          aria-valuenow=${this.fractions && !Number.isNaN(this.value) ? this.value : nothing}
          aria-valuetext=${this.fractions ? this.#shown : nothing}
          .value=${live(this.typed ?? this.#shown)}
          aria-invalid=${isWrong ? 'true' : nothing}
          aria-describedby=${isWrong ? 'wrong' : nothing}
          @input=${(event: Event) => {
            // hides the message once the entry is valid: at `change`, a click would miss its target
            if (this.typed !== undefined) this.typed = (event.target as HTMLInputElement).value;
          }}
          @keydown=${(event: KeyboardEvent) => {
            if (event.key === 'Enter') this.#accept(event);
            else if (this.fractions) this.#step(event);
          }}
          @change=${(event: Event) => {
            this.#enter(event.target as HTMLInputElement);
          }}
        />
      </label>
      ${isWrong ? html`<p id="wrong" class="error" role="alert">${this.wrong}</p>` : nothing}
    `;
  }

  get #shown(): string {
    if (Number.isNaN(this.value)) return ''; // no value yet
    return this.fractions
      ? fractionOrNumber(this.value, this.digits)
      : String(Number(this.value.toFixed(this.digits)) + 0);
  }

  /** A text field has no steps, so the arrow keys step by eighths of an inch. */
  #step(event: KeyboardEvent): void {
    const eighths = eighthsOf[event.key];
    if (eighths === undefined) return;
    event.preventDefault();
    const next = Math.round(8 * this.value + eighths) / 8;
    const value = this.#within(next);
    if (value === this.value) return;
    this.typed = undefined;
    this.dispatchEvent(new CustomEvent<number>('entered', {detail: value}));
  }

  /** Takes the entry at once: a listener that moves the focus must not send Enter elsewhere too. */
  #accept(event: KeyboardEvent): void {
    event.preventDefault();
    this.#enter(event.target as HTMLInputElement);
  }

  #enter(input: HTMLInputElement): void {
    const isRight = this.#isRight(input.value);
    this.typed = isRight ? undefined : input.value;
    const value = numberTyped(input.value);
    if (!isRight || value === numberTyped(this.#shown)) return;
    this.dispatchEvent(new CustomEvent<number>('entered', {detail: this.#within(value)}));
  }

  #within(value: number): number {
    return Math.min(this.most, Math.max(this.least, value));
  }

  #isRight(typed: string): boolean {
    const value = numberTyped(typed);
    const slack = this.fractions ? sixteenthMissed : 0;
    return value >= this.least - slack && value <= this.most + slack;
  }
}
