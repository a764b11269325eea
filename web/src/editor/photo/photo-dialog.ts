/** The sheet on which a photograph of cloth becomes a print. */
import {html, nothing, type TemplateResult} from 'lit';

import type {PhotoMap} from '../../model/photo.js';
import {dataUrlOf} from '../../recognition/data-url.js';
import {photoTexts, type PhotoTexts} from '../../texts/photo-texts.js';
import {toFailure} from '../../workbench/latest-solve.js';
import {focused} from '../base/focused.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import type {PhotoOfCloth} from '../print/print-files.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import {sheetDialog} from '../style/sheet-dialog.js';
import {dialogStyle} from './dialog-style.js';
import {startLattice, type PhotoSize} from './lattice-lines.js';
import type {PhotoKeeper} from './photo-keeper.js';
import {cellPicture, pngOf} from '../print/photo-picture.js';
import {PhotoSession} from './photo-session.js';
import {measuresOf, type PhotoStep} from '../print/photo-step.js';
import {pictureButton} from './picture-button.js';
import {shownPicture} from './shown-picture.js';

export class PhotoDialog extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    session: {state: true},
    size: {state: true},
    hand: {state: true},
    name: {state: true},
    trouble: {state: true},
    isTaking: {state: true},
  };
  static override styles = [controls, sheetDialog, dialogStyle];
  /** Undefined until there is a picture. */
  declare protected session: PhotoSession | undefined;
  /** Of the picture as the browser shows it. */
  declare protected size: PhotoSize | undefined;
  /** A lattice that somebody draws. */
  declare protected hand: PhotoMap | undefined;
  declare protected name: string;
  /** What went wrong with the picture, or with taking it. */
  declare protected trouble: string | undefined;
  declare protected isTaking: boolean;
  keeper: PhotoKeeper | undefined;
  #address: string | undefined;
  /** The focus went to what takes the print, once. */
  #isLed = false;

  constructor() {
    super();
    this.name = '';
    this.isTaking = false;
  }

  async open(given?: PhotoOfCloth): Promise<void> {
    await this.updateComplete;
    const dialog = this.renderRoot.querySelector('dialog');
    if (!dialog?.open) dialog?.showModal();
    if (given) await this.#take(given.picture, given.name);
    else if (!this.session) await this.#again();
  }

  /** What was read may be taken without a closer look. */
  get #isSure(): boolean {
    const {state, step} = this.session ?? {};
    return state?.kind === 'done' && step?.reading.confidence !== 'uncertain';
  }

  protected get words(): PhotoTexts {
    const {language, messages} = this.workbench.preferences;
    return photoTexts(language, messages);
  }

  protected override updated(): void {
    if (this.#isLed || !this.#isSure) return;
    this.#isLed = true;
    const at = focused();
    const isLost =
      !at || at === document.body || at.localName === 'dialog' || !!at.closest('header');
    if (isLost) this.renderRoot.querySelector<HTMLElement>('footer .primary')?.focus();
  }

  protected override render(): TemplateResult {
    const {words, texts, session} = this;
    return html`<dialog
      aria-labelledby="title"
      @close=${this.#ended}
      @keydown=${this.#key}
      @dragover=${(event: DragEvent) => {
        if (!event.dataTransfer?.types.includes('Files')) return;
        event.preventDefault();
        event.stopPropagation();
      }}
      @drop=${(event: DragEvent) => {
        this.#hand(event, event.dataTransfer?.files[0]);
      }}
      @paste=${(event: ClipboardEvent) => {
        this.#hand(event, event.clipboardData?.files[0]);
      }}
    >
      <header>
        <h2 id="title">${words.title}</h2>
        ${session ? this.#travel(session) : nothing}
        <button
          class="icon"
          aria-label=${texts.app.close}
          title=${texts.app.close}
          @click=${this.#close}
        >
          ${icon.close}
        </button>
      </header>
      ${session && this.size ? [this.#work(session, this.size), this.#foot(session, this.size)] : this.#intake()}
    </dialog>`;
  }

  #travel(session: PhotoSession): TemplateResult {
    const {app} = this.texts;
    const {canUndo, canRedo} = session.read;
    return html`<button
        class="icon"
        aria-label=${app.undo}
        title=${app.undo}
        ?disabled=${!canUndo}
        @click=${() => session.undo()}
      >
        ${icon.undo}
      </button>
      <button
        class="icon"
        aria-label=${app.redo}
        title=${app.redo}
        ?disabled=${!canRedo}
        @click=${() => session.redo()}
      >
        ${icon.redo}
      </button>`;
  }

  #intake(): TemplateResult {
    const {words} = this;
    const take = this.#given;
    return html`<div class="intake">
      <p>${words.intake}</p>
      <p class="soft">${words.stays}</p>
      ${this.trouble ? html`<p class="error" role="alert">${this.trouble}</p>` : nothing}
      <div class="row">
        ${pictureButton({label: words.choose, look: 'primary', take})}
        ${pictureButton({label: words.camera, look: 'outlined', isCamera: true, take})}
      </div>
    </div>`;
  }

  #work(session: PhotoSession, size: PhotoSize): TemplateResult {
    return html`<sw-photo-work
      .workbench=${this.workbench}
      .session=${session}
      .picture=${this.#address ?? ''}
      .natural=${size}
      .hand=${this.hand}
      @hand=${({detail}: CustomEvent<PhotoMap | null>) => {
        this.hand = detail ?? undefined;
      }}
    ></sw-photo-work>`;
  }

  #foot(session: PhotoSession, natural: PhotoSize): TemplateResult {
    const {words, hand} = this;
    const {step, state} = session.read;
    const size = step?.reading ?? natural;
    const isReady = step !== undefined && !hand && state.kind !== 'reading';
    return html`<footer>
      ${
        this.trouble && state.kind !== 'failed'
          ? html`<p class="error" role="alert">${this.trouble}</p>`
          : nothing
      }
      <label class="name">
        ${words.name}
        <input
          type="text"
          maxlength="80"
          .value=${this.name}
          @change=${(event: Event) => {
            this.name = (event.target as HTMLInputElement).value;
          }}
        />
      </label>
      ${pictureButton({label: words.another, look: 'outlined', take: this.#given})}
      <button
        class="outlined"
        ?disabled=${hand !== undefined || state.kind === 'reading'}
        @click=${() => {
          this.hand = startLattice(size);
        }}
      >
        ${words.byHand}
      </button>
      <button
        class="primary"
        ?disabled=${!isReady || this.isTaking}
        @click=${() => void this.#use(session)}
      >
        ${words.use}
      </button>
    </footer>`;
  }

  readonly #given = (file: File): void => {
    void this.#take(file, file.name);
  };

  #hand(event: Event, file: File | undefined): void {
    event.stopPropagation(); // the page takes files, too
    if (!file) return;
    event.preventDefault();
    this.#given(file);
  }

  async #take(picture: Blob, name: string, step?: PhotoStep): Promise<void> {
    this.#forget();
    this.name = name.replace(/\.[^.]*$/, '');
    const address = URL.createObjectURL(picture);
    this.#address = address;
    const shown = await shownPicture(picture, {address, name}, this.texts.print.files);
    if (this.#address !== address) return;
    if (typeof shown === 'string') {
      this.trouble = shown;
      return;
    }
    this.size = shown;
    this.session = new PhotoSession(this.workbench.solver, picture);
    if (step) this.session.resume(step);
    else void this.session.begin();
  }

  /** The photograph that the present print was made of, as it was left. */
  async #again(): Promise<void> {
    const {image = ''} = this.workbench.design?.print ?? {};
    const kept = image.startsWith('data:') ? await this.keeper?.kept(image) : undefined;
    if (!kept || this.#address !== undefined) return;
    await this.#take(kept.picture, kept.name, kept.step);
  }

  async #use(session: PhotoSession): Promise<void> {
    const {step} = session;
    if (!step || this.isTaking) return;
    this.isTaking = true;
    this.trouble = undefined;
    try {
      const measures = measuresOf(step);
      const canvas = cellPicture(await session.tile(), measures);
      const image = await dataUrlOf(await pngOf(canvas));
      if (this.session !== session) return;
      this.workbench.doubtful = undefined;
      this.workbench.change({print: {title: this.name || this.words.title, ...measures, image}});
      void this.keeper?.keep(image, {picture: session.picture, name: this.name, step});
      this.#close();
    } catch (error) {
      this.trouble = toFailure(error).message;
    } finally {
      this.isTaking = false;
    }
  }

  /** Letters are keys of the page elsewhere. */
  readonly #key = (event: KeyboardEvent): void => {
    event.stopPropagation();
    const {session} = this;
    const [target] = event.composedPath() as Element[];
    const isField = target?.matches('input:is([type=text], [type=number]), textarea') ?? false;
    if (!session || isField) return;
    if ((event.ctrlKey || event.metaKey) && /^[zy]$/i.test(event.key)) {
      event.preventDefault();
      if (event.shiftKey || event.key.toLowerCase() === 'y') session.redo();
      else session.undo();
    }
    const isPressed = target?.matches('button, a') ?? false;
    if (event.key === 'Enter' && !isPressed && !this.hand && this.#isSure) void this.#use(session);
  };

  readonly #close = (): void => {
    this.renderRoot.querySelector('dialog')?.close();
  };

  readonly #ended = (): void => {
    this.#forget();
  };

  #forget(): void {
    this.session?.dispose();
    this.session = undefined;
    this.size = undefined;
    this.hand = undefined;
    this.trouble = undefined;
    this.#isLed = false;
    if (this.#address !== undefined) URL.revokeObjectURL(this.#address);
    this.#address = undefined;
  }
}
