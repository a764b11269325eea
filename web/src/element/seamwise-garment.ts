/**
 * `<seamwise-garment>`: a sewing pattern in a print that matches at its seams. This module
 * registers nothing; `auto.ts` does.
 */
import type {PropertyValues, TemplateResult} from 'lit';

import {SolverError} from '../model/base/failure.js';
import type {LayPlan} from '../model/result/marker-plan.js';
import type {SolveResult} from '../model/result/result.js';
import {readStoredDesign, type StoredDesign} from '../model/documents/stored-design.js';
import {asError, keepInside, type Emit} from './garment/emitted-events.js';
import {RequestScheduler} from './garment/request-scheduler.js';
import {AttributeElement, upgrade} from './garment/attribute-element.js';
import {
  asking,
  attributes,
  localeOf,
  spellings,
  type GarmentMode,
  type GarmentView,
} from './garment/attributes.js';
import {Marker, Modes} from './garment/later-parts.js';
import type {GarmentState} from './garment/events.js';
import {faceOf, garmentStyle} from './garment/face.js';
import {PrintOffers, type OfferedPrint, type PrintOffer} from './garment/sources.js';
import {checkedDesign, checkRequest, checkWaiting} from './garment/method-checks.js';
import {blobOf, type BlobRequest} from './garment/picture.js';
import {GarmentSession} from './garment/session.js';
import {ElementLanguage} from './garment/language.js';
import {PatternDrawing} from '../editor/pattern/drawing.js';
import {jsonText} from '../solver/requests/requests.js';
import {register} from '../editor/base/register.js';
import {controls} from '../editor/style/controls.js';
import {tokens} from '../editor/style/tokens.js';
import type {Messages, Texts} from '../texts/texts.js';
import {preferencesFor} from '../texts/preferences.js';

export type * from './garment/attributes.js';
export type * from './garment/events.js';
export type * from '../model/result/marker-plan.js';
export type {Units} from '../model/base/length-text.js';
export type {PrintOffer} from './garment/sources.js';
export type {BlobRequest} from './garment/picture.js';
export type {Messages, Texts} from '../texts/texts.js';
export type {FoldTexts} from '../texts/en/fold.js';
export type {SewTexts} from '../texts/en/sew.js';
export type {DrapeTexts} from '../texts/drape-texts.js';

/** Time after which an element outside the document is unused: it may only be moving. [ms] */
const gracePeriod = 1000;

export class SeamwiseGarment extends AttributeElement {
  /** The page may set the variables of `style/tokens.ts`. */
  static override styles = [tokens, controls, garmentStyle];

  static override get observedAttributes(): string[] {
    return [...super.observedAttributes, ...attributes, ...spellings.keys()];
  }

  readonly #session: GarmentSession;
  readonly #requests: RequestScheduler;
  readonly #modes: Modes;
  readonly #offers = new PrintOffers(() => {
    this.requestUpdate();
  });
  readonly #language: ElementLanguage;
  readonly #marker: Marker;
  #shown: GarmentMode = 'preview';
  #shownView: GarmentView = 'pattern';
  #isDrawn = false;
  /** Reason why nothing is drawn, until something is. */
  #undrawable: SolverError | undefined;
  #releasing: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    super();
    const emit: Emit = (type, detail) => {
      this.emit(type, detail);
    };
    register('sw-drawing', PatternDrawing);
    this.#session = new GarmentSession(
      {
        places: () => ({
          ...this.solverPlaces,
          onBlocked: (failure) => {
            this.#session.report(new SolverError(failure));
          },
        }),
        emit,
        changed: () => {
          this.#present();
        },
      },
      preferencesFor(localeOf(navigator.language)),
    );
    this.#language = new ElementLanguage(this, this.#session.workbench);
    this.#requests = new RequestScheduler(
      {
        element: this,
        isEager: () => this.loading === 'eager',
        asked: () => (this.isAskable ? this.asked : undefined),
        begun: () => {
          this.#present();
        },
        noGarment: () => this.#texts.garment.noGarment,
      },
      this.#session,
    );
    const lost = (error: unknown): SolverError =>
      new SolverError({
        code: 'network',
        message: this.#texts.garment.noTools(asError(error).message),
      });
    this.#marker = new Marker(
      {element: this, session: this.#session, texts: () => this.#texts, emit},
      lost,
    );
    this.#modes = new Modes(
      () => {
        this.#present();
      },
      (error) => {
        this.#session.report(lost(error));
      },
    );
    this.addEventListener('invalid', () => {
      if (this.isAskable && this.state !== 'error') this.#requests.start();
    });
  }

  /** Messages that replace the element's own. */
  get messages(): Messages | undefined {
    return this.#language.messages;
  }

  set messages(messages: Messages | null | undefined) {
    this.#language.messages = typeof messages === 'object' && messages ? messages : undefined;
  }

  /** The prints to choose from, with `mode="place"`. */
  get prints(): readonly PrintOffer[] {
    return this.#offers.all.map(({url, title}) => ({url, title}));
  }

  set prints(prints: readonly PrintOffer[] | null | undefined) {
    this.#offers.set(prints);
  }

  get state(): GarmentState {
    return this.#session.state;
  }

  /** The answer to the request, while `state` is `ready`. */
  get result(): SolveResult | undefined {
    return this.#session.result;
  }

  /** The error, while `state` is `error`. */
  get error(): SolverError | undefined {
    return this.#session.error;
  }

  /** Length of the answer's layout on fabric of width `clothWidth`; null until it is there. [cm] */
  get clothLengthCm(): number | null {
    return this.#marker.layer?.lengthCm ?? null;
  }

  /** The design as JSON text; empty if there is no answer, or none that can be stored. */
  get value(): string {
    if (this.#session.state !== 'ready') return '';
    try {
      return JSON.stringify(this.#session.stored());
    } catch {
      return ''; // given as objects: there is no URL to store
    }
  }

  set value(value: string | null | undefined) {
    if (!value) {
      this.#session.reset();
      return;
    }
    try {
      // the session reports errors of the solve
      this.#restore(storedIn(value)).catch(() => undefined);
    } catch (error) {
      this.#session.report(asError(error));
    }
  }

  /**
   * Returns the answer to the current request, or to the one that replaces it meanwhile. Known
   * answers are not solved again. Works out of view, and outside the document, too.
   * @throws {SolverError} if the request fails; the signal's reason, an `AbortError` by default,
   * when it fires; an `AbortError` after `cancel`
   */
  async solve(options: {readonly signal?: AbortSignal} = {}): Promise<SolveResult> {
    checkWaiting('solve', options);
    const {signal} = options;
    signal?.throwIfAborted();
    return this.#needed(() => this.#requests.answer(signal));
  }

  /**
   * Returns the layout of the answer on fabric of width `clothWidth`; if the request changes
   * meanwhile, that of the new answer.
   * @throws {SolverError} if the width is missing, or the fabric is too narrow for a piece; as
   * `solve`
   */
  async layPlan(options: {readonly signal?: AbortSignal} = {}): Promise<LayPlan> {
    checkWaiting('layPlan', options);
    const {signal} = options;
    signal?.throwIfAborted();
    return this.#needed(async () => {
      if (this.clothWidth === null) {
        throw new SolverError({code: 'options', message: this.#texts.garment.noCloth});
      }
      const layer = await this.#marker.load();
      return layer.plan(() => this.solve(signal && {signal}), signal);
    });
  }

  /** Ends running work; the shown result stays. */
  cancel(): void {
    this.#marker.layer?.cancel();
    this.#session.cancel();
  }

  /**
   * Returns the design with its answer, as `seamwise-design/1`.
   * @throws {SolverError} before there is an answer, and if the garment or the print is an object;
   * the message is one sentence
   */
  getDesign(): StoredDesign & {readonly format: string} {
    return this.#session.stored();
  }

  /**
   * Loads a stored design, or its JSON text, in place of the current one; resolves when it is
   * solved.
   * @throws {FileError} if it is no design; {SolverError} `file-changed` if the garment or the
   * print differs from the file used for the design, and as `solve`
   */
  async setDesign(design: StoredDesign | string): Promise<void> {
    await this.#restore(storedIn(design));
  }

  async #restore(stored: StoredDesign): Promise<void> {
    this.writeDesign(stored);
    this.#requests.ask({stored});
    await this.solve();
  }

  /**
   * Returns the whole pattern as a picture, or the cutting sheet as a file at true scale, by type.
   * @throws {SolverError} for a picture: if nothing is drawn, or the width is out of range; for a
   * cutting sheet: if there is no answer, or the paper or an allowance is invalid
   */
  async toBlob(request: BlobRequest = {}): Promise<Blob> {
    checkRequest(request);
    const isDrawn = (): boolean => {
      if (!this.#isDrawn && this.#undrawable) throw this.#undrawable;
      return this.#isDrawn;
    };
    return blobOf(this.#session.workbench, isDrawn, request, this.#texts);
  }

  formResetCallback(): void {
    this.#session.reset();
  }

  formStateRestoreCallback(state: string | File | FormData | null): void {
    if (typeof state === 'string' && state !== '') this.value = state;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    clearTimeout(this.#releasing);
    upgrade(this);
    this.#language.prefer();
    this.#requests.watch();
    this.#requests.schedule();
    this.#marker.follow();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#requests.unwatch();
    this.#isDrawn = false;
    this.#releaseSoon();
  }

  override attributeChangedCallback(name: string, before: string | null, now: string | null): void {
    super.attributeChangedCallback(name, before, now);
    if (before === now) return;
    if (asking.has(spellings.get(name) ?? name)) {
      if (now !== null) this.forget(name);
      this.ask();
    } else if (name === 'loading') {
      if (this.isConnected) this.#requests.watch();
      this.#requests.schedule();
    } else if (name === 'fabric') {
      this.#session.fabric = this.fabric;
    } else if (['units', 'locale', 'lang'].includes(name)) {
      this.#language.prefer();
    }
    this.#present();
  }

  protected override createRenderRoot(): HTMLElement | DocumentFragment {
    const root = super.createRenderRoot();
    keepInside(root, {
      draped: (news) => {
        this.emit('drape', news);
      },
      drawn: () => {
        this.#isDrawn = true;
        this.#undrawable = undefined;
        this.requestUpdate();
      },
      undrawable: (failure) => {
        this.#isDrawn = false;
        this.#undrawable = new SolverError(failure);
        this.#session.report(this.#undrawable);
        this.requestUpdate();
      },
    });
    return root;
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    if (this.#shown === 'place') this.#offers.read(this.#texts.garment);
  }

  protected override render(): TemplateResult {
    return faceOf({
      ...{session: this.#session, texts: this.#texts, mode: this.#shown, alt: this.alt},
      ...{view: this.view, worn: this},
      ...{isDisabled: this.isDisabled, isDrawn: this.#isDrawn, prints: this.#offers.all},
      ...{hasBegun: this.#requests.hasBegun, isMissing: this.isMissing},
      choose: (print) => {
        this.#choose(print);
      },
    });
  }

  /** Runs work that may need the element outside the document. */
  async #needed<T>(work: () => Promise<T>): Promise<T> {
    upgrade(this);
    try {
      return await work();
    } finally {
      if (!this.isConnected) this.#releaseSoon();
    }
  }

  /** Releases shared resources unless the element is in use again within the grace period. */
  #releaseSoon(): void {
    clearTimeout(this.#releasing);
    this.#releasing = setTimeout(() => {
      if (this.isConnected || this.#session.isAwaited || this.#marker.layer?.isAwaited) return;
      this.#marker.layer?.pause();
      this.#offers.stop();
      if (this.#session.pause()) this.#requests.askAgain();
    }, gracePeriod);
  }

  /** Handles the user's choice of a print. */
  #choose({url}: OfferedPrint): void {
    this.colourway = null;
    this.print = url;
    if (this.#requests.isDue) this.#requests.ask({byUser: true});
  }

  /** Updates the element's state, description, form value and template. */
  #present(): void {
    if (this.#requests.hasBegun) this.#modes.load(this.mode, this.view);
    const shown = this.#modes.shown(this.mode);
    if (this.#shown !== shown || this.#shownView !== this.view) this.#isDrawn = false;
    this.#shown = shown;
    this.#shownView = this.view;
    const {workbench} = this.#session;
    workbench.searches.offeredSizes = this.printSizes;
    workbench.solving.isEdited = shown === 'edit';
    const {garment} = this.#texts;
    this.enter(this.#session.state);
    this.present(this.value, this.error?.message ?? garment.required);
    // a picture contains nothing focusable
    const isPicture = this.mode === 'preview' && this.view === 'pattern' && !this.isMissing;
    this.describe(isPicture ? 'img' : 'group', this.alt || garment.label);
    this.requestUpdate();
    this.#marker.follow();
  }

  get #texts(): Texts {
    return this.#language.texts;
  }

  protected override ask(): void {
    this.#requests.ask();
  }
}

/** @throws {FileError} if it is no design; {SolverError} if it is neither object nor text */
function storedIn(design: unknown): StoredDesign {
  const known = checkedDesign(design);
  const text = typeof known === 'string' ? known : jsonText(known, 'design');
  return readStoredDesign(text, 'design');
}

declare global {
  interface HTMLElementTagNameMap {
    'seamwise-garment': SeamwiseGarment;
  }
}
