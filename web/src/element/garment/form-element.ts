/** An element of a form with states and events, independent of garments. */
import {LitElement} from 'lit';

import {bubbling, type GarmentEvents, type SeamwiseGarmentEventMap} from './events.js';

/**
 * Browsers before 2023 lack states, validity or all internals; the element then does not set them.
 */
type Internals = Partial<ElementInternals>;

export abstract class FormElement extends LitElement {
  static readonly formAssociated = true;
  readonly #internals: Internals;
  #isDisabled = false;
  #state = '';
  /** Message about a missing value; empty if none is missing. */
  #missing = '';

  constructor() {
    super();
    this.#internals = 'attachInternals' in this ? this.attachInternals() : {};
  }

  /** Type reported to forms. */
  readonly type = 'seamwise-garment';

  get form(): HTMLFormElement | null {
    return this.#internals.form ?? null;
  }

  get labels(): NodeList | undefined {
    return this.#internals.labels;
  }

  get name(): string {
    return this.getAttribute('name') ?? '';
  }

  set name(name: string) {
    this.write('name', name);
  }

  get required(): boolean {
    return this.hasAttribute('required');
  }

  set required(required: boolean) {
    this.toggleAttribute('required', required);
  }

  get disabled(): boolean {
    return this.hasAttribute('disabled');
  }

  set disabled(disabled: boolean) {
    this.toggleAttribute('disabled', disabled);
  }

  get validity(): ValidityState | undefined {
    return this.#internals.validity;
  }

  get validationMessage(): string {
    return this.#internals.validationMessage ?? '';
  }

  get willValidate(): boolean {
    return this.#internals.willValidate ?? false;
  }

  checkValidity(): boolean {
    return this.#internals.checkValidity?.() ?? true;
  }

  reportValidity(): boolean {
    return this.#internals.reportValidity?.() ?? true;
  }

  formDisabledCallback(isDisabled: boolean): void {
    this.#isDisabled = isDisabled;
    this.requestUpdate();
  }

  /** True if the element or a fieldset around it is disabled. */
  protected get isDisabled(): boolean {
    return this.#isDisabled || this.disabled;
  }

  /** True if a required value is missing; the part `stage` is focusable then. */
  protected get isMissing(): boolean {
    return this.#missing !== '';
  }

  /** @param missing message about an empty required value */
  protected present(value: string, missing: string): void {
    this.#internals.setFormValue?.(value === '' ? null : value);
    this.#missing = this.required && value === '' ? missing : '';
    this.#validate();
  }

  protected override firstUpdated(): void {
    this.#validate();
  }

  /** A browser shows the message only at a focusable anchor, and shows nothing without one. */
  #validate(): void {
    const anchor = !this.hasUpdated
      ? null
      : this.renderRoot.querySelector<HTMLElement>('[part=stage]');
    this.#internals.setValidity?.(
      {valueMissing: this.isMissing},
      this.#missing,
      anchor ?? undefined,
    );
  }

  /**
   * Writes a property to its attribute, in the spelling with hyphens. Values that are no text, number
   * or truth value remove it, so that the default applies.
   */
  protected write(name: string, value: unknown): void {
    const spelling = name.replaceAll('-', '');
    if (spelling !== name) this.removeAttribute(spelling);
    const isPlain = ['string', 'number', 'bigint', 'boolean'].includes(typeof value);
    if (isPlain) this.setAttribute(name, String(value));
    else this.removeAttribute(name);
  }

  /** Describes the element to assistive technology. */
  protected describe(role: 'img' | 'group', label: string): void {
    Object.assign(this.#internals, {role, ariaLabel: label});
  }

  /** Sets the custom state for `:state(...)`. */
  protected enter(state: string): void {
    if (state === this.#state) return;
    try {
      this.#internals.states?.delete(this.#state);
      this.#internals.states?.add(state);
    } catch {
      // some versions accept only names with two hyphens, which no page uses
    }
    this.#state = state;
  }

  protected emit<K extends keyof GarmentEvents>(type: K, detail: GarmentEvents[K]): void {
    const isHeardAround = bubbling.has(type);
    const reach = {bubbles: isHeardAround, composed: isHeardAround};
    this.dispatchEvent(new CustomEvent(type, {detail, ...reach}));
  }

  override addEventListener<K extends keyof SeamwiseGarmentEventMap>(
    type: K,
    listener: (this: this, event: SeamwiseGarmentEventMap[K]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void {
    super.addEventListener(type, listener, options);
  }

  override removeEventListener<K extends keyof SeamwiseGarmentEventMap>(
    type: K,
    listener: (this: this, event: SeamwiseGarmentEventMap[K]) => unknown,
    options?: boolean | EventListenerOptions,
  ): void;
  override removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
  override removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void {
    super.removeEventListener(type, listener, options);
  }
}
