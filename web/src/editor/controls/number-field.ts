/** A number that somebody types: a wrong entry is said beside it and changes nothing. */
import {css, html, LitElement, nothing, type PropertyValues, type TemplateResult} from 'lit';
import {live} from 'lit/directives/live.js';

import {fractionOrNumber, numberTyped, type Units} from '../../model/units.js';
import {controls} from '../style/controls.js';

/** One unit of length, as fields are labelled. */
export const lengthUnit: Readonly<Record<Units, {readonly name: string; readonly cm: number}>> = {
  cm: {name: 'cm', cm: 1},
  inch: {name: 'in', cm: 2.54},
};

/** What the arrow keys add. [in/8] */
const eighthsOf: Readonly<Record<string, number>> = {ArrowUp: 1, ArrowDown: -1};
/** By which limits differ from how they are said at most. [in] */
const sixteenthMissed = 1 / 32;

/** Fires `entered` with the number as `detail`, whenever a good one has been typed. */
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
  /** Drawn behind the label; the field's name for those who hear it stays the label alone. */
  declare sign: string;
  /** NaN for none. */
  declare value: number;
  declare least: number;
  declare most: number;
  declare step: number;
  /** After the point. */
  declare digits: number;
  /** It is in inches, which are shown and may be typed as 3/8 or 1 1/2. */
  declare fractions: boolean;
  /** What is said of a wrong entry. */
  declare wrong: string;
  /** What has this number: a wrong entry is forgotten with it. */
  declare subject: unknown;
  /** A wrong entry, and what it is being mended to. */
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

  /** What was typed last is no good: `value` is not what the field shows. */
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
            // once it is right, the words below go, and not just when somebody presses what is under them
            if (this.typed !== undefined) this.typed = (event.target as HTMLInputElement).value;
          }}
          @keydown=${(event: KeyboardEvent) => {
            if (this.fractions) this.#step(event);
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
    if (Number.isNaN(this.value)) return ''; // nobody has said it yet
    return this.fractions
      ? fractionOrNumber(this.value, this.digits)
      : String(Number(this.value.toFixed(this.digits)) + 0);
  }

  /** A text has no steps of its own: the arrow keys go by eighths. */
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
