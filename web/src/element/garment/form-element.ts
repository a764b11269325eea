/** An element that belongs to a form, and tells the page about itself: what has nothing to do with garments. */
import {LitElement} from 'lit';

import {bubbling, type GarmentEvents, type SeamwiseGarmentEventMap} from './events.js';

/** Browsers before 2023 have no states, no validity or no internals at all: then there is nothing to be told. */
type Internals = Partial<ElementInternals>;

export abstract class FormElement extends LitElement {
  static readonly formAssociated = true;
  readonly #internals: Internals;
  #isDisabled = false;
  #state = '';
  /** What is said of a value that is missing; empty while none is. */
  #missing = '';

  constructor() {
    super();
    this.#internals = 'attachInternals' in this ? this.attachInternals() : {};
  }

  /** As forms know it. */
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
    this.setAttribute('name', name);
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

  /** By itself or by a fieldset around it. */
  protected get isDisabled(): boolean {
    return this.#isDisabled || this.disabled;
  }

  /** A value is required, and there is none: the part `stage` can have the focus then. */
  protected get isMissing(): boolean {
    return this.#missing !== '';
  }

  /** @param missing what is said of an empty value where one is required */
  protected present(value: string, missing: string): void {
    this.#internals.setFormValue?.(value === '' ? null : value);
    this.#missing = this.required && value === '' ? missing : '';
    this.#validate();
  }

  protected override firstUpdated(): void {
    this.#validate();
  }

  /** A browser shows what is wrong only with what can have the focus: without an anchor it says nothing at all. */
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

  /** What the element is for those who do not see it. */
  protected describe(role: 'img' | 'group', label: string): void {
    Object.assign(this.#internals, {role, ariaLabel: label});
  }

  /** Shown as `:state(...)`. */
  protected enter(state: string): void {
    if (state === this.#state) return;
    try {
      this.#internals.states?.delete(this.#state);
      this.#internals.states?.add(state);
    } catch {
      // some versions take only names with two hyphens, which no page asks for
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
