/**
 * `<seamwise-garment>`: a sewing pattern in a print that meets at its seams. This module registers nothing;
 * `auto.ts` does.
 */
import {html, nothing, type TemplateResult} from 'lit';

import type {Failure} from '../model/failure.js';
import {SolverError} from '../model/failure.js';
import type {SolveResult} from '../model/result.js';
import {readStoredDesign, type StoredDesign} from '../model/stored-design.js';
import {asking, attributes, localeOf, type GarmentMode} from './garment/attributes.js';
import type {GarmentState} from './garment/events.js';
import {AttributeElement} from './garment/attribute-element.js';
import {
  offeredPrints,
  withPrints,
  type OfferedPrint,
  type PrintOffer,
} from './garment/offered-prints.js';
import {pictureAs} from './garment/picture.js';
import {asError, GarmentSession, type LoadReason} from './garment/session.js';
import {garmentUrl} from './garment/sources.js';
import {garmentStyle} from './garment/style.js';
import {drawnEvent, PatternDrawing, undrawableEvent} from './pattern/drawing.js';
import {register} from './register.js';
import {controls} from './style/controls.js';
import {tokens} from './style/tokens.js';
import {textsOf, type Messages, type Texts} from './texts/texts.js';
import {preferencesFor} from './workbench/preferences.js';

export type * from './garment/attributes.js';
export type * from './garment/events.js';
export type {PrintOffer} from './garment/offered-prints.js';
export type {Messages} from './texts/texts.js';

/** An element that is taken out of the document may only be on its way to another place. [ms] */
const grace = 1000;
/** So far from what is visible of the page it begins. */
const rootMargin = '200px';

/** What may have been set before the element was known. */
const properties = [
  ...[
    'garment',
    'size',
    'print',
    'colourway',
    'symmetry',
    'maxChangeMm',
    'view',
    'mode',
    'loading',
  ],
  ...['units', 'locale', 'alt', 'workerUrl', 'wasmUrl', 'messages', 'prints', 'name', 'required'],
  ...['disabled', 'value'],
] as const;

/** Events of the parts that would leave the element as if they were its own. */
const innerEvents = ['input', 'change', 'select', 'sw-lens-cursor', 'sw-lens-wanted'];

export class SeamwiseGarment extends AttributeElement {
  static override styles = [tokens, controls, garmentStyle];

  static override get observedAttributes(): string[] {
    return [...super.observedAttributes, ...attributes];
  }

  readonly #session: GarmentSession;
  #messages: Messages | undefined;
  #offered: readonly OfferedPrint[] = [];
  #offering: AbortController | undefined;
  #near: IntersectionObserver | undefined;
  /** Seen, or asked for. */
  #isWanted = false;
  /** Something is asked for that has not been begun. */
  #isDue = false;
  #reason: LoadReason = {};
  #isScheduled = false;
  #isDrawn = false;
  #resting: ReturnType<typeof setTimeout> | undefined;
  /** What is needed for a mode has been loaded, or was tried to. */
  readonly #modes = new Set<GarmentMode>(['preview']);

  constructor() {
    super();
    register('sw-drawing', PatternDrawing);
    this.#session = new GarmentSession(
      {
        places: () => ({
          ...this.solverPlaces,
          onBlocked: (failure) => {
            this.#session.report(new SolverError(failure));
          },
        }),
        emit: (type, detail) => {
          this.emit(type, detail);
        },
        changed: () => {
          this.#present();
        },
      },
      preferencesFor(localeOf(navigator.language)),
    );
  }

  /** Words to be shown in place of the element's own. */
  get messages(): Messages | undefined {
    return this.#messages;
  }

  set messages(messages: Messages | null | undefined) {
    this.#messages = typeof messages === 'object' && messages ? messages : undefined;
    this.#prefer();
  }

  /** With `mode="place"`: the prints to choose from. */
  get prints(): readonly PrintOffer[] {
    return this.#offered.map(({url, title}) => ({url, title}));
  }

  set prints(prints: readonly PrintOffer[] | null | undefined) {
    this.#offered = offeredPrints(prints);
    this.#offering?.abort();
    this.#offering = undefined;
    this.requestUpdate();
  }

  get state(): GarmentState {
    return this.#session.state;
  }

  /** The answer to what is asked for, while `state` is `ready`. */
  get result(): SolveResult | undefined {
    return this.#session.result;
  }

  /** What is wrong, while `state` is `error`. */
  get error(): SolverError | undefined {
    return this.#session.error;
  }

  /** The design as JSON text; empty while there is no answer, or none that can be stored. */
  get value(): string {
    if (this.#session.state !== 'ready') return '';
    try {
      return JSON.stringify(this.#session.stored());
    } catch {
      return ''; // given as objects: there is no URL to store
    }
  }

  set value(value: string | null | undefined) {
    if (value) this.setDesign(value).catch(() => undefined);
    else this.#session.reset();
  }

  /**
   * The answer to what is asked for now, or to what takes its place before that is there. Nothing that is
   * known already is solved again. Works out of view, and outside the document, too.
   * @throws {SolverError} for what is wrong with it; the signal's reason, an `AbortError` by default, when it
   *   fires; an `AbortError` after `cancel`
   */
  async solve({signal}: {readonly signal?: AbortSignal} = {}): Promise<SolveResult> {
    signal?.throwIfAborted();
    this.#upgrade();
    this.#isWanted = true;
    const {state} = this.#session;
    if (!this.isAskable && (state === 'idle' || this.#isDue)) {
      throw new SolverError({code: 'notAGarment', message: this.#texts.garment.noGarment});
    }
    const isStuck = state === 'idle' || state === 'error' || state === 'stale';
    if (isStuck && !this.#isDue && !this.#session.solveAgain()) this.#isDue = true;
    if (this.#isDue) this.#begin();
    try {
      return await this.#session.answer(signal);
    } finally {
      if (!this.isConnected) this.#rest();
    }
  }

  /** Ends what is under way; what is shown stays. */
  cancel(): void {
    this.#session.cancel();
  }

  /**
   * The design with its answer, as `seamwise-design/1`.
   * @throws {SolverError} with one sentence before there is an answer, and when garment or print are objects
   */
  getDesign(): StoredDesign & {readonly format: string} {
    return this.#session.stored();
  }

  /**
   * Takes a stored design, or its JSON text, in the place of what is shown; resolves when it is solved.
   * @throws {FileError} for what is no design; {SolverError} `file-changed` when garment or print are not the
   *   files that it was made with, and as `solve` does
   */
  async setDesign(design: StoredDesign | string): Promise<void> {
    const text = typeof design === 'string' ? design : JSON.stringify(design);
    const stored = readStoredDesign(text, 'design');
    const {garment, print, symmetry, options} = stored;
    const template = this.getAttribute('garment');
    const isThis = template !== null && sameUrl(garmentUrl(template, garment.size), garment.url);
    if (!isThis) this.garment = garment.url;
    else this.forget('garment');
    this.write('size', garment.size);
    this.print = print.url;
    this.colourway = print.colourway;
    this.symmetry = symmetry;
    if (options.maxChangeCm !== undefined) this.maxChangeMm = options.maxChangeCm * 10;
    this.#reason = {stored};
    this.#isDue = true;
    await this.solve();
  }

  /**
   * The whole pattern as a picture, so many pixels wide: `image/png`, `image/jpeg` or `image/webp`.
   * @throws {SolverError} while nothing is drawn
   */
  async toBlob({
    type,
    width,
  }: {readonly type?: string; readonly width?: number} = {}): Promise<Blob> {
    const {view} = this.#session.desk;
    if (!view || !this.#isDrawn) {
      throw new SolverError({code: 'no-webgl', message: this.#texts.garment.noDrawing});
    }
    return pictureAs(await view.picture(width), type);
  }

  formResetCallback(): void {
    this.#session.reset();
  }

  formStateRestoreCallback(state: string | File | FormData | null): void {
    if (typeof state === 'string' && state !== '') this.value = state;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    clearTimeout(this.#resting);
    this.#upgrade();
    this.#prefer();
    this.#watch();
    this.#schedule();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#near?.disconnect();
    this.#isDrawn = false;
    this.#rest();
  }

  override attributeChangedCallback(name: string, before: string | null, now: string | null): void {
    super.attributeChangedCallback(name, before, now);
    if (before === now) return;
    if (asking.has(name)) {
      if (now !== null) this.forget(name);
      this.ask();
    } else if (name === 'loading') {
      if (this.isConnected) this.#watch();
      this.#schedule();
    } else if (['units', 'locale', 'lang'].includes(name)) {
      this.#prefer();
    }
    this.#present();
  }

  protected override createRenderRoot(): HTMLElement | DocumentFragment {
    const root = super.createRenderRoot();
    for (const type of innerEvents) {
      root.addEventListener(type, (event) => {
        event.stopPropagation();
      });
    }
    root.addEventListener(drawnEvent, (event) => {
      event.stopPropagation();
      this.#isDrawn = true;
      this.requestUpdate();
    });
    root.addEventListener(undrawableEvent, (event) => {
      event.stopPropagation();
      this.#session.report(new SolverError((event as CustomEvent<Failure>).detail));
    });
    return root;
  }

  protected override render(): TemplateResult {
    const {error} = this;
    const {state, desk} = this.#session;
    const shows = this.#shownMode;
    const hides = !this.#isDrawn || (state === 'error' && shows === 'preview');
    const isBusy = state === 'loading' || state === 'solving';
    // the editor says itself what its user can mend
    const says = error && !(shows === 'edit' && desk.state.kind === 'failed');
    return html`<div class="frame" ?inert=${this.isDisabled}>
        <div part="toolbar"><slot name="toolbar"></slot></div>
        <div class="stage" part="stage">
          ${this.#stage(shows)}
          <div class="poster" part="poster" ?hidden=${!hides || shows === 'edit'}>
            <slot name="poster"><p>${this.alt || this.#texts.garment.label}</p></slot>
          </div>
          <progress
            part="progress"
            aria-hidden="true"
            ?hidden=${!isBusy || shows === 'edit'}
            max="1"
            .value=${desk.state.kind === 'solving' ? desk.state.fraction : 0}
          ></progress>
        </div>
        ${this.#panel(shows)}
      </div>
      ${says ? html`<p class="message" part="message" role="alert">${error.message}</p>` : nothing}`;
  }

  #stage(shows: GarmentMode): TemplateResult {
    const {desk} = this.#session;
    switch (shows) {
      case 'preview':
        return html`<sw-drawing .desk=${desk}></sw-drawing>`;
      case 'place':
        return html`<sw-pattern .desk=${desk} .purpose=${'place'}></sw-pattern>`;
      case 'edit':
        return html`<sw-editor .desk=${desk}></sw-editor>`;
    }
  }

  #panel(shows: GarmentMode): TemplateResult | typeof nothing {
    if (shows !== 'place') return nothing;
    this.#readOffers();
    return html`<sw-place-bar
      part="panel"
      .desk=${this.#session.desk}
      .prints=${this.#offered}
      .chosen=${this.#session.desk.design?.print.file?.place?.url ?? ''}
      @sw-print=${({detail}: CustomEvent<OfferedPrint>) => {
        this.colourway = null;
        this.print = detail.url;
        this.#reason = {byUser: true};
      }}
    ></sw-place-bar>`;
  }

  /** Their pictures are fetched once somebody is to see them. */
  #readOffers(): void {
    if (this.#offering || this.#offered.length === 0) return;
    const offering = new AbortController();
    this.#offering = offering;
    void withPrints(this.#offered, this.#texts.garment, offering.signal).then((offered) => {
      if (offering.signal.aborted) return;
      this.#offered = offered;
      this.requestUpdate();
    });
  }

  /** What the mode needs is loaded with it; until then there is the preview. */
  get #shownMode(): GarmentMode {
    const {mode} = this;
    return this.#modes.has(mode) ? mode : 'preview';
  }

  async #loadMode(mode: GarmentMode): Promise<void> {
    if (mode === 'preview' || this.#modes.has(mode)) return;
    try {
      if (mode === 'place') (await import('./garment/placing.js')).definePlacing();
      else (await import('./editor/editor.js')).defineEditor();
      this.#modes.add(mode);
      this.#present();
    } catch (error) {
      const {message} = asError(error);
      this.#session.report(new SolverError({code: 'network', message}));
    }
  }

  #shown: GarmentMode = 'preview';

  /** Tells what has become of the element, outwards and inwards. */
  #present(): void {
    // the constructor has not made it yet
    if (!(#session in this)) return;
    void this.#loadMode(this.mode);
    if (this.#shown !== this.#shownMode) this.#isDrawn = false;
    this.#shown = this.#shownMode;
    this.#session.desk.isEdited = this.#shown === 'edit';
    const {garment} = this.#texts;
    this.enter(this.#session.state);
    this.present(this.value, garment.required);
    this.describe(this.mode === 'preview' ? 'img' : 'group', this.alt || garment.label);
    this.requestUpdate();
  }

  get #texts(): Texts {
    const {language, messages} = this.#session.desk.preferences;
    return textsOf(language, messages);
  }

  #prefer(): void {
    const around = this.closest('[lang]')?.getAttribute('lang');
    const {language} = preferencesFor(localeOf(this.locale, around, navigator.language));
    const {messages, units} = this;
    const known = this.#session.desk.preferences;
    const isKnown =
      language === known.language && units === known.units && messages === known.messages;
    if (isKnown) return;
    this.#session.desk.prefer({language, units, messages});
  }

  /** Properties that were set before the element was known hide its own. */
  #upgrade(): void {
    for (const name of properties) {
      if (!Object.hasOwn(this, name)) continue;
      const value: unknown = Reflect.get(this, name);
      Reflect.deleteProperty(this, name);
      Reflect.set(this, name, value);
    }
  }

  /** Something else is asked for. Changes in one task are one. */
  protected override ask(): void {
    this.#isDue = true;
    this.#schedule();
  }

  #schedule(): void {
    if (this.#isScheduled) return;
    this.#isScheduled = true;
    queueMicrotask(() => {
      this.#isScheduled = false;
      if (this.#isWanted && this.#isDue && this.isConnected) this.#begin();
    });
  }

  #begin(): void {
    if (!this.isAskable) return;
    this.#isDue = false;
    const reason = this.#reason;
    this.#reason = {};
    void this.#session.load(this.asked, reason);
  }

  /** Begins when it is near; an eager one, or one that has begun before, at once. */
  #watch(): void {
    this.#near?.disconnect();
    if (this.#isWanted || this.loading === 'eager') {
      this.#isWanted = true;
      return;
    }
    this.#near = new IntersectionObserver(
      (entries) => {
        if (!entries.some(({isIntersecting}) => isIntersecting)) return;
        this.#near?.disconnect();
        this.#isWanted = true;
        this.#schedule();
      },
      {rootMargin},
    );
    this.#near.observe(this);
  }

  /** Gives back what others may need, unless it is put into the document again soon. */
  #rest(): void {
    clearTimeout(this.#resting);
    this.#resting = setTimeout(() => {
      if (this.isConnected) return;
      this.#offering?.abort();
      this.#offering = undefined;
      if (this.#session.pause()) this.#isDue = true;
    }, grace);
  }
}

const sameUrl = (one: string, other: string): boolean =>
  URL.canParse(one, document.baseURI) &&
  URL.canParse(other, document.baseURI) &&
  new URL(one, document.baseURI).href === new URL(other, document.baseURI).href;

declare global {
  interface HTMLElementTagNameMap {
    'seamwise-garment': SeamwiseGarment;
  }
}
