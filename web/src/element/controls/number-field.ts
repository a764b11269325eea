/** A number that somebody types: a wrong entry is said beside it and changes nothing. */
import {css, html, LitElement, nothing, type PropertyValues, type TemplateResult} from 'lit';
import {live} from 'lit/directives/live.js';

import type {Units} from '../../model/units.js';
import {controls} from '../style/controls.js';

/** One unit of length, as fields are labelled. */
export const lengthUnit: Readonly<Record<Units, {readonly name: string; readonly cm: number}>> = {
  cm: {name: 'cm', cm: 1},
  inch: {name: 'in', cm: 2.54},
};

/** Fires `entered` with the number as `detail`, whenever a good one has been typed. */
export class NumberField extends LitElement {
  static override properties = {
    label: {},
    value: {type: Number},
    least: {type: Number},
    most: {type: Number},
    step: {type: Number},
    digits: {type: Number},
    wrong: {},
    subject: {attribute: false},
    typed: {state: true},
  };
  declare label: string;
  declare value: number;
  declare least: number;
  declare most: number;
  declare step: number;
  /** After the point. */
  declare digits: number;
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
    this.step = 1;
    this.digits = 2;
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
        ${this.label}
        <input
          type="number"
          inputmode="decimal"
          step=${this.step}
          .value=${live(this.typed ?? this.#shown)}
          aria-invalid=${isWrong ? 'true' : nothing}
          aria-describedby=${isWrong ? 'wrong' : nothing}
          @input=${(event: Event) => {
            // once it is right, the words below go, and not just when somebody presses what is under them
            if (this.typed !== undefined) this.typed = (event.target as HTMLInputElement).value;
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
    return String(Number(this.value.toFixed(this.digits)) + 0);
  }

  #enter(input: HTMLInputElement): void {
    const isRight = this.#isRight(input.value);
    this.typed = isRight ? undefined : input.value;
    const value = input.valueAsNumber;
    if (!isRight || value === Number(this.#shown)) return;
    this.dispatchEvent(new CustomEvent<number>('entered', {detail: value}));
  }

  #isRight(typed: string): boolean {
    const value = Number(typed);
    return typed !== '' && value >= this.least && value <= this.most;
  }
}
